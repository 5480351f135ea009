// [material], its regions and the constants of the laws.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "keys.hpp"

namespace tlsph {
namespace {

bool has_constant(LawName law, std::string_view constant) {
  return std::ranges::count(constants_of(law), constant, &LawConstant::name) > 0;
}

/// "(required by …)" for a constant that some laws do not have.
std::string owners_of(std::string_view constant) {
  std::vector<std::string_view> laws;
  for (const auto& [name, law] : word_list<LawName>)
    if (has_constant(law, constant)) laws.push_back(name);
  return laws.size() == law_names.size() ? ""
                                         : fmt::format("(required by {})", fmt::join(laws, ", "));
}

/// Reads the constants of the law; of a region, those that it leaves out are those of [material]. A
/// constant of another law is refused.
void read_constants(MaterialScene& material, const TableView& view, const Scene& scene) {
  material.constants.clear();
  for (const LawConstant& constant : constants_of(material.law)) {
    const auto inherited =
        scene.materials.empty() ? std::nullopt : scene.materials.front().constant(constant.name);
    const bool given = view.has(constant.name) || !inherited;
    material.constants.push_back(given ? view.require(constant.name).number() : *inherited);
  }
  for (const LawConstant& constant : all_law_constants())
    if (view.has(constant.name) && !has_constant(material.law, constant.name))
      fail_at(view.place_of(constant.name), "the law \"{}\" has no such constant",
              name_of(material.law));
}

void read_later(MaterialScene&, const TableView&, const Scene&) {}

/// The keys of the constants. Which of them there are depends on the law: read after all rows.
std::vector<Row<MaterialScene>> constants(bool of_region) {
  std::vector<Row<MaterialScene>> rows;
  for (const LawConstant& constant : all_law_constants()) {
    const std::string name(constant.name);
    rows.push_back(
        {{"", name, number, std::string(constant.unit), constant.range,
          std::string(constant.meaning), "", of_region ? "(of [material])" : owners_of(name)},
         read_later,
         [name](const MaterialScene& material, const Scene&, Printed) {
           const std::optional<double> value = material.constant(name);
           return value ? std::optional(node_of(*value)) : std::nullopt;
         }});
  }
  return rows;
}

using Rows = std::vector<Row<MaterialScene>>;

Rows joined(Rows first, const Rows& second, const Rows& third) {
  first.insert(first.end(), second.begin(), second.end());
  first.insert(first.end(), third.begin(), third.end());
  return first;
}

/// Regions are materials of the scene: read and printed with it.
Row<MaterialScene> regions_key() {
  return {{"",
           "region",
           tables,
           "",
           {},
           "parts of another material, [[material.region]]; of overlapping ones the last counts",
           "region"},
          read_later,
          [](const MaterialScene&, const Scene&, Printed) { return std::optional<Node>(); }};
}

/// What a region has in common with [material] goes without saying.
Node print_region(const MaterialScene& region, const Node& base, const Scene& scene,
                  Printed printed) {
  Node node = print_table(region, region_keys(), scene, Printed::all);
  if (printed == Printed::given)
    std::erase_if(*node.table(), [&](const Entry& entry) {
      const Node* same = base.find(entry.name);
      return same != nullptr && print_value(*same) == print_value(entry.value);
    });
  return node;
}

}  // namespace

const Table<MaterialScene>& material_keys() {
  static const Table<MaterialScene> keys = {
      "material",
      joined(
          {key(&MaterialScene::law, "law", "", {}, "stress from strain"),
           key(&MaterialScene::assumption, "assumption", "", {},
               "of the dimensions left out: no strain (1D strain, plane strain) or no stress")},
          constants(false),
          {key(&MaterialScene::density, "density", "kg/m^3", above(0.0), "in the reference state")
               .required(),
           regions_key()}),
      read_constants};
  return keys;
}

const Table<MaterialScene>& region_keys() {
  const std::string same = "(of [material])";
  static const Table<MaterialScene> keys = {
      "region",
      joined({box_key<MaterialScene>("[[x0, y0], [x1, y1]], in 1D [from, to]: the part"),
              key(&MaterialScene::law, "law", "", {}, "stress from strain").otherwise(same)},
             constants(true),
             {key(&MaterialScene::density, "density", "kg/m^3", above(0.0), "reference density")
                  .otherwise(same)}),
      read_constants};
  return keys;
}

Row<Scene> materials_key() {
  return {{"", "material", table, "", {}, "what the body is made of", "material", ""},
          [](Scene& owner, const TableView& view, const Scene& scene) {
            const TableView base = view.table("material");
            MaterialScene material;
            read_table(material, base, material_keys(), scene);
            owner.materials = {material};
            for (const TableView& region : base.tables("region")) {
              MaterialScene part = material;
              read_table(part, region, region_keys(), scene);
              owner.materials.push_back(std::move(part));
            }
          },
          [](const Scene& scene, const Scene&, Printed printed) -> std::optional<Node> {
            const MaterialScene& material = scene.materials.front();
            const Node base = print_table(material, material_keys(), scene, Printed::all);
            Node node = print_table(material, material_keys(), scene, printed);
            std::vector<Node> regions;
            for (std::size_t k = 1; k < scene.materials.size(); ++k)
              regions.push_back(print_region(scene.materials[k], base, scene, printed));
            if (!regions.empty())
              node.table()->push_back(entry_of("region", node_of(std::move(regions))));
            return node;
          }};
}

}  // namespace tlsph
