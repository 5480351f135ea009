// [[boundary]]: conditions of the patches.
#include <algorithm>

#include "keys.hpp"

namespace tlsph {
namespace {

int component(const std::string& axis, int dimension, const Place& place) {
  if (axis == "y" && dimension == 1)
    throw InputError(place, "there is no y where dimension = 1; allowed: x");
  return axis == "x" ? 0 : 1;
}

std::string axis_of(int component) {
  return component == 0 ? "x" : "y";
}

bool is_free(const BoundaryScene& boundary) {
  return boundary.fixed.empty() && boundary.held.empty() && !boundary.symmetry &&
         boundary.motion.empty() && !boundary.normal_traction && boundary.traction.empty();
}

}  // namespace

/// Components of a vector: true for all, one, or a list.
template <>
struct Codec<std::vector<int>> {
  static constexpr unsigned forms = flag | text | texts;
  static std::vector<std::string> words() { return {"x", "y"}; }
  static std::vector<int> read(const Node& node, const Scene& scene) {
    std::vector<int> components;
    if (const bool* all = node.flag()) {
      for (int i = 0; *all && i < scene.dimension; ++i) components.push_back(i);
    } else if (const auto* axis = node.text()) {
      components.push_back(component(*axis, scene.dimension, node.place));
    } else {
      for (const Node& item : *node.list())
        components.push_back(component(*item.text(), scene.dimension, item.place));
      std::sort(components.begin(), components.end());
      if (std::adjacent_find(components.begin(), components.end()) != components.end())
        throw InputError(node.place, "names a component twice");
    }
    return components;
  }
  static Node print(const std::vector<int>& components) {
    std::vector<std::string> axes;
    for (const int c : components) axes.push_back(axis_of(c));
    return print_list(axes);
  }
};

/// A motion: a number or a curve for each component that moves.
template <>
struct Codec<std::vector<ComponentCurve>> {
  static constexpr unsigned forms = Form::table;
  static constexpr const char* below = "motion";
  static std::vector<ComponentCurve> read(const Node& node, const Scene& scene) {
    std::vector<ComponentCurve> motion;
    for (const Entry& entry : *node.table())
      motion.push_back(
          {component(entry.name, scene.dimension, entry.place), read_motion_curve(entry.value)});
    if (motion.empty()) throw InputError(node.place, "must say which component moves: { x = … }");
    return motion;
  }
  static Node print(const std::vector<ComponentCurve>& motion) {
    std::vector<Entry> entries;
    for (const auto& [component, curve] : motion)
      entries.push_back(entry_of(axis_of(component), print_curve(curve)));
    return node_of(std::move(entries));
  }
};

namespace {

/// A normal load, or one with a number per dimension: two members share the key.
Row<BoundaryScene> traction_key() {
  return {{"",
           "traction",
           number | numbers | Form::table,
           "Pa",
           {},
           "load per reference area: a number or curve is normal, tension positive; a list, or a "
           "curve with a list as amplitude, is a vector",
           "curve"},
          [](BoundaryScene& boundary, const TableView& view, const Scene& scene) {
            if (const Node* node = view.find("traction"))
              read_load(*node, scene.dimension, boundary.normal_traction, boundary.traction);
          },
          [](const BoundaryScene& boundary, const Scene& scene, Printed) -> std::optional<Node> {
            if (boundary.normal_traction) return print_curve(*boundary.normal_traction);
            if (boundary.traction.empty()) return std::nullopt;
            return print_vector_load(boundary.traction, scene.dimension);
          }};
}

/// Printed also where an entry says nothing else, which is refused.
Row<BoundaryScene> symmetry_key() {
  Row<BoundaryScene> row = key(&BoundaryScene::symmetry, "symmetry", "", {},
                               "the displacement normal to the (straight) patch is zero");
  row.unsaid = "";
  row.print = [](const BoundaryScene& boundary, const Scene&,
                 Printed printed) -> std::optional<Node> {
    const bool said = boundary.symmetry || is_free(boundary) || printed == Printed::all;
    return said ? std::optional(node_of(boundary.symmetry)) : std::nullopt;
  };
  return row;
}

void check_boundary(BoundaryScene&, const TableView& view, const Scene&) {
  if (!view.has("fixed") && !view.has("held") && !view.has("symmetry") &&
      !view.has("displacement") && !view.has("traction"))
    throw InputError(
        view.place(),
        "says nothing about its patch; give fixed, held, symmetry, displacement or traction");
}

}  // namespace

const Table<BoundaryScene>& boundary_keys() {
  static const Table<BoundaryScene> keys = {
      "boundary",
      {
          key(&BoundaryScene::where, "where", "", {},
              "a patch. left, right, bottom, top: the straight edges of the outer boundary that "
              "face that way, of several the outermost; edge1, edge2 …: one edge, from corner "
              "(more than 20°) to corner, in the order of the shape (a box: bottom, right, top, "
              "left; a polygon: from its first corner on; a difference: edges of its first shape, "
              "then of the others); hole1, hole2 …: all that the first, second … shape taken away "
              "leaves; hole: all that such shapes leave, without left, right, bottom and top; "
              "outer: the rest; boundary: all; or the name of a tag. In 1D left, right, outer, "
              "boundary and tags. A wrong name is answered by the list, with places")
              .required(),
          key(&BoundaryScene::fixed, "fixed", "", {},
              "held at zero displacement: true, or the components held")
              .otherwise("(none)"),
          key(&BoundaryScene::held, "held", "", {},
              "kept at the displacement of t = 0, for a body that starts stretched; for " +
                  adjoint_formulations())
              .otherwise("(none)"),
          symmetry_key(),
          key(&BoundaryScene::motion, "displacement", "m", {}, "prescribed motion")
              .otherwise("(none)"),
          traction_key(),
      },
      check_boundary};
  return keys;
}

}  // namespace tlsph
