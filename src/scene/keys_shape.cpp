// Shapes and boxes: read and printed.
#include "keys.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

std::string per_dimension(int dimension) {
  return dimension == 1 ? "x, as dimension = 1" : "x and y, as dimension = 2";
}

Vector<2> read_point(const Node& node) {
  const auto x = read_vector(node, 2, "x and y");
  return {x[0], x[1]};
}

template <int D>
Node print_point(const Vector<D>& point) {
  return print_list(std::vector<double>(point.begin(), point.end()));
}

/// The one key of a shape table.
const Node& only_form(const TableView& view, int dimension) {
  const auto& entries = *view.node()->table();
  const char* allowed = dimension == 1 ? "interval" : "box, disc, polygon or difference";
  if (entries.size() != 1)
    fail_at(view.place(), "must have exactly one of {}, not {}", allowed,
            entries.empty() ? "none" : "several");
  if ((dimension == 1) != (entries.front().name == "interval"))
    fail_at(entries.front().place, "no shape in dimension {}; allowed: {}", dimension, allowed);
  return entries.front().value;
}

Shape<1> read_shape_1d(const TableView& view) {
  const Node& node = only_form(view, 1);
  const auto ends = read_vector(node, 2, "from and to");
  auto shape = make_interval(ends[0], ends[1]);
  validate(shape, node.place);
  return shape;
}

Shape<2> read_shape_2d(const TableView& view);

Shape<2> read_difference(const TableView& view, const Node& node) {
  const auto parts = view.tables("difference");
  if (parts.size() < 2)
    throw InputError(node.place, "must be [shape, hole, …], a shape and at least one hole");
  std::vector<Shape<2>> holes;
  for (std::size_t i = 1; i < parts.size(); ++i) holes.push_back(read_shape_2d(parts[i]));
  return make_difference(read_shape_2d(parts[0]), std::move(holes));
}

Shape<2> read_shape_2d(const TableView& view) {
  const Node& node = only_form(view, 2);
  Shape<2> shape;
  if (view.has("box")) {
    const auto [lower, upper] = read_box(node, 2);
    shape = make_box<2>({lower[0], lower[1]}, {upper[0], upper[1]});
  } else if (view.has("disc")) {
    const TableView disc = view.table("disc");
    shape = make_disc(read_point(disc.require("centre")), disc.require("radius").number());
  } else if (view.has("polygon")) {
    std::vector<Vector<2>> corners;
    for (const Node& corner : *node.list()) corners.push_back(read_point(corner));
    shape = make_polygon(std::move(corners));
  } else {
    shape = read_difference(view, node);
  }
  validate(shape, node.place);
  return shape;
}

/// `{ name = value }`.
Node print_form(std::string_view name, Node value) {
  return node_of(std::vector<Entry>{entry_of(name, std::move(value))});
}

Node print_shape(const Shape<1>& shape) {
  const auto& ends = std::get<Box<1>>(shape.form);
  return print_form("interval", print_list(std::vector<double>{ends.lower(0), ends.upper(0)}));
}

Node print_shape(const Shape<2>& shape) {
  if (const auto* box = std::get_if<Box<2>>(&shape.form))
    return print_form(
        "box", node_of(std::vector<Node>{print_point<2>(box->lower), print_point<2>(box->upper)}));
  if (const auto* disc = std::get_if<Disc>(&shape.form))
    return print_form("disc",
                      node_of(std::vector<Entry>{entry_of("centre", print_point<2>(disc->centre)),
                                                 entry_of("radius", node_of(disc->radius))}));
  std::vector<Node> parts;
  if (const auto* polygon = std::get_if<Polygon>(&shape.form)) {
    for (const Vector<2>& corner : polygon->corners) parts.push_back(print_point<2>(corner));
    return print_form("polygon", node_of(std::move(parts)));
  }
  parts.push_back(print_shape(base_of(shape)));
  for (const Shape<2>& hole : holes_of(shape)) parts.push_back(print_shape(hole));
  return print_form("difference", node_of(std::move(parts)));
}

}  // namespace

AnyShape Codec<AnyShape>::read(const Node& node, const Scene& scene) {
  const TableView view(node, below);
  if (scene.dimension == 1) return read_shape_1d(view);
  return read_shape_2d(view);
}

Node Codec<AnyShape>::print(const AnyShape& shape) {
  if (const auto* interval = std::get_if<Shape<1>>(&shape)) return print_shape(*interval);
  if (const auto* region = std::get_if<Shape<2>>(&shape)) return print_shape(*region);
  return node_of(std::vector<Entry>{});
}

std::vector<Key> shape_keys() {
  const Allowed any;
  return {
      {"shape", "interval", numbers, "m", any, "1D: [from, to]"},
      {"shape", "box", points, "m", any, "[[x0, y0], [x1, y1]]: lower left, upper right"},
      {"shape", "disc", table, "m", any, "a full circle", "disc"},
      {"shape", "polygon", points, "m", any, "[[x, y], …]: corners in order"},
      {"shape", "difference", tables, "", any, "[shape, hole, …]: the first without the others",
       "shape"},
      {"disc", "centre", numbers, "m", any, "[x, y]", "", ""},
      {"disc", "radius", number, "m", above(0.0), "", "", ""},
  };
}

CornerPair read_box(const Node& node, int dimension) {
  const auto& list = *node.list();
  if (list.size() != 2)
    fail_at(node.place, "must be two corners, [lower, upper], not {}", list.size());
  CornerPair corners;
  if (list[0].is_number() && dimension != 1)
    throw InputError(node.place, "must be [[x0, y0], [x1, y1]], as dimension = 2");
  if (list[0].is_number()) {
    corners = {{list[0].number()}, {list[1].number()}};
  } else {
    corners = {read_vector(list[0], dimension, per_dimension(dimension)),
               read_vector(list[1], dimension, per_dimension(dimension))};
  }
  for (int a = 0; a < dimension; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    if (!(corners.lower[axis] <= corners.upper[axis]))
      fail_at(node.place,
              "the lower corner must not be above the upper one, "
              "but in {} {} > {}",
              "xy"[a], corners.lower[axis], corners.upper[axis]);
  }
  return corners;
}

Node print_box(const CornerPair& corners) {
  return node_of(std::vector<Node>{print_list(corners.lower), print_list(corners.upper)});
}

}  // namespace tlsph
