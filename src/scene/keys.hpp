#pragma once
/// \file
/// The tables of keys of a scene, each bound to the part of `Scene` that holds it.

#include <vector>

#include "bound.hpp"

namespace tlsph {

const Table<Scene>& scene_keys();  ///< the top level, and by it all below

const Table<BodyScene>& body_keys();
const Table<KernelScene>& kernel_keys();
const Table<StabiliserScene>& stabiliser_keys();
const Table<MaterialScene>& material_keys();
const Table<MaterialScene>& region_keys();
const Table<BoundaryScene>& boundary_keys();
const Table<NamedBox>& tag_keys();
const Table<Scene>& initial_keys();

Row<Scene> consistency_key();
/// [material] with its regions.
Row<Scene> materials_key();

using AnyShape = decltype(BodyScene::shape);
template <>
struct Codec<AnyShape> {
  static constexpr unsigned forms = Form::table;
  static constexpr const char* below = "shape";
  static AnyShape read(const Node& node, const Scene& scene);
  static Node print(const AnyShape& shape);
};

// Keys of values that are read as a whole.
std::vector<Key> shape_keys();         ///< with those of a disc
std::vector<Key> curve_keys();         ///< with those of a motion
std::vector<Key> initial_part_keys();  ///< of the regions and fields of [initial]

/// Two opposite corners of a box, `[lower, upper]`; in 1D also `[from, to]`.
struct CornerPair {
  std::vector<double> lower, upper;
};
[[nodiscard]] CornerPair read_box(const Node& node, int dimension);
[[nodiscard]] Node print_box(const CornerPair& corners);

/// The box of a part, its members `lower` and `upper`.
template <class T>
[[nodiscard]] Row<T> box_key(std::string meaning) {
  return {{"", "box", points | numbers, "m", {}, std::move(meaning), "", ""},
          [](T& part, const TableView& view, const Scene& scene) {
            CornerPair corners = read_box(view.require("box"), scene.dimension);
            part.lower = std::move(corners.lower);
            part.upper = std::move(corners.upper);
          },
          [](const T& part, const Scene&, Printed) -> std::optional<Node> {
            return print_box({part.lower, part.upper});
          }};
}

/// The motion of one component: a number, or a curve with a number as amplitude.
[[nodiscard]] Curve read_motion_curve(const Node& node);

/// A load: a number or curve is `normal`, a list or a curve with a list as amplitude has a number
/// per dimension.
void read_load(const Node& node, int dimension, std::optional<Curve>& normal,
               std::vector<ComponentCurve>& components);

/// A number where the curve is constant, else its table.
[[nodiscard]] Node print_curve(const Curve& curve);

/// A load by components, which differ in nothing but their amplitude. The values of a table curve
/// are those of its first component: the others come back to rounding.
[[nodiscard]] Node print_vector_load(const std::vector<ComponentCurve>& load, int dimension);

}  // namespace tlsph
