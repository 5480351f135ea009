// [initial]: the state at t = 0.
#include "keys.hpp"

namespace tlsph {

template <>
struct Codec<InitialField> {
  static constexpr unsigned forms = text | numbers | Form::table;
  static constexpr const char* below = "field";
  static std::vector<std::string> words() { return {"zero"}; }
  static InitialField read(const Node& node, const Scene& scene);
  static Node print(const InitialField& field);
};

namespace {

InitialField read_named(const TableView& view, InitialField field) {
  for (const char* other : {"constant", "gradient"})
    if (view.has(other))
      throw InputError(view.place_of(other), "does not go with a named field; leave one out");
  field.kind = *from_name<InitialField::Kind>(*view.require("field").text());
  field.amplitude = view.require("amplitude").number();
  return field;
}

InitialField read_linear(const TableView& view, InitialField field, int dimension) {
  if (view.has("amplitude"))
    throw InputError(view.place_of("amplitude"), "goes with a named field; give field too");
  if (!view.has("constant") && !view.has("gradient"))
    throw InputError(view.place(), "must have constant, gradient or field; or be \"zero\"");
  const auto n = static_cast<std::size_t>(dimension);
  field.kind = InitialField::Kind::linear;
  field.constant.assign(n, 0.0);
  field.gradient.assign(n, std::vector<double>(n, 0.0));
  if (const Node* constant = view.find("constant"))
    field.constant = read_vector(*constant, dimension, "one per dimension");
  if (const Node* gradient = view.find("gradient")) {
    if (gradient->list()->size() != n)
      fail_at(gradient->place, "must have {} row{}, one per dimension, not {}", n,
              n == 1 ? "" : "s", gradient->list()->size());
    for (std::size_t i = 0; i < n; ++i)
      field.gradient[i] = read_vector((*gradient->list())[i], dimension, "one per dimension");
  }
  return field;
}

void check_region(InitialRegion& region, const TableView&, const Scene&) {
  if (!region.displacement && !region.velocity)
    throw InputError(region.place, "says nothing about its box; give displacement or velocity");
}

const Table<InitialRegion>& initial_region_keys() {
  const std::string same = "(of [initial])";
  static const Table<InitialRegion> keys = {
      "initial region",
      {
          box_key<InitialRegion>(
              "[[x0, y0], [x1, y1]], in 1D [from, to]: the nodes meant, those on its rim too"),
          key(&InitialRegion::displacement, "displacement", "m", {}, "instead of that of [initial]")
              .otherwise(same),
          key(&InitialRegion::velocity, "velocity", "m/s", {}, "instead of that of [initial]")
              .otherwise(same),
      },
      check_region};
  return keys;
}

}  // namespace

InitialField Codec<InitialField>::read(const Node& node, const Scene& scene) {
  InitialField field;
  field.place = node.place;
  if (node.text()) return field;
  if (node.list()) {
    field.kind = InitialField::Kind::linear;
    field.constant = read_vector(node, scene.dimension, "one per dimension");
    return field;
  }
  const TableView view(node, below);
  return view.has("field") ? read_named(view, field) : read_linear(view, field, scene.dimension);
}

Node Codec<InitialField>::print(const InitialField& field) {
  if (field.kind == InitialField::Kind::zero) return node_of(std::string("zero"));
  if (field.kind != InitialField::Kind::linear)
    return node_of(
        std::vector<Entry>{entry_of("field", Codec<InitialField::Kind>::print(field.kind)),
                           entry_of("amplitude", node_of(field.amplitude))});
  if (field.gradient.empty()) return print_list(field.constant);
  return node_of(std::vector<Entry>{entry_of("constant", print_list(field.constant)),
                                    entry_of("gradient", print_list(field.gradient))});
}

const Table<Scene>& initial_keys() {
  static const Table<Scene> keys = {
      "initial",
      {
          key(&Scene::displacement, "displacement", "m", {},
              "at t = 0; numbers: the same everywhere"),
          key(&Scene::velocity, "velocity", "m/s", {}, "at t = 0; numbers: the same everywhere"),
          list_key(&Scene::initial_regions, initial_region_keys(), "region",
                   "parts with another start, [[initial.region]]; of overlapping ones the last "
                   "counts"),
      }};
  return keys;
}

std::vector<Key> initial_part_keys() {
  std::vector<Key> all = keys_of(initial_region_keys());
  const Allowed any;
  all.insert(all.end(),
             {{"field", "constant", numbers, "m or m/s", any, "the same everywhere"},
              {"field", "gradient", points, "1 or 1/s", any,
               "[[xx, xy], [yx, yy]]: gradient times position is added"},
              {"field", "field", text, "", Allowed(Codec<InitialField::Kind>::words()),
               "a named field: of the swinging plate, or the first bending mode of a beam clamped "
               "at left"},
              {"field", "amplitude", number, "m or m/s", any,
               "of the named field: its largest component, at the tip of the beam"}});
  return all;
}

}  // namespace tlsph
