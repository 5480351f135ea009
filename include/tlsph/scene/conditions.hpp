#pragma once
/// \file
/// What the entries of [[boundary]] do to a patch, by component: decided once, here. Whoever asks
/// what is held, moved or loaded asks these lists; the constraints and loads of a body are made
/// from them.

#include <string>
#include <vector>

#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// The component across a patch whose axis is not known before its nodes are.
inline constexpr int unknown_axis = -1;

/// What one entry does to one component of its patch.
struct Condition {
  enum class Kind {
    fixed,   ///< the displacement is zero
    held,    ///< it stays what it is at t = 0
    moved,   ///< it is the curve [m]
    loaded,  ///< the traction per reference area is the curve [Pa]
  };
  Kind kind = Kind::fixed;
  int component = 0;
  /// Asked of the component across the patch, by `symmetry` or a normal traction, which acts along
  /// the outward normal, tension positive.
  bool across = false;
  const Curve* curve = nullptr;  ///< of the entry, if moved or loaded
};

/// The conditions of an entry whose patch is perpendicular to `axis`.
[[nodiscard]] std::vector<Condition> conditions_of(const BoundaryScene& entry, int axis);

/// The axis that left, right, bottom and top of a box, with or without holes, are perpendicular to;
/// unknown_axis of other patches and shapes.
[[nodiscard]] int patch_axis(const Scene& scene, const std::string& patch);

/// All that the entries of a scene do to a patch, one entry after the other.
class PatchConditions {
 public:
  using Kind = Condition::Kind;
  PatchConditions(const Scene& scene, const std::string& patch);

  [[nodiscard]] const std::vector<Condition>& all() const { return all_; }
  /// The first of a kind on a component, nullptr if there is none.
  [[nodiscard]] const Condition* find(Kind kind, int component) const;
  [[nodiscard]] bool has(Kind kind, int component) const {
    return find(kind, component) != nullptr;
  }
  [[nodiscard]] bool has(Kind kind) const;

 private:
  std::vector<Condition> all_;
};

/// The traction of a load across a side, tension positive; `outward` is the sign of its normal.
[[nodiscard]] Curve tension(const Condition& load, double outward);

}  // namespace tlsph
