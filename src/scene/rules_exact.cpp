// Where named initial fields and exact solutions apply.
#include <algorithm>
#include <cmath>

#include "rules.hpp"
#include "tlsph/scene/conditions.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

using Kind = Condition::Kind;

/// Says what an exact solution needs, where it is not so.
struct Needs {
  const Scene& scene;
  void operator()(bool condition, const char* what) const {
    if (!condition)
      fail_at(scene.exact_place, "{} does not apply: it needs {}", name_of(scene.exact), what);
  }
};

bool starts_at_rest(const Scene& scene) {
  return scene.displacement.kind == InitialField::Kind::zero &&
         scene.velocity.kind == InitialField::Kind::zero;
}

bool only_box_patches(const Scene& scene) {
  return std::all_of(scene.boundaries.begin(), scene.boundaries.end(), [](const auto& entry) {
    return entry.where == "left" || entry.where == "right" || entry.where == "top" ||
           entry.where == "bottom";
  });
}

template <class Test>
bool all_conditions(const Scene& scene, const Test& test) {
  return std::ranges::all_of(scene.boundaries, [&](const BoundaryScene& entry) {
    return std::ranges::all_of(conditions_of(entry, patch_axis(scene, entry.where)), test);
  });
}

void check_one_material(const Scene& scene, const Needs& needs) {
  needs(scene.materials.size() == 1, "one material all over the body");
  needs(std::all_of(scene.body_force.begin(), scene.body_force.end(),
                    [](double g) { return g == 0.0; }),
        "no gravity");
}

void check_bar_wave(const Scene& scene) {
  const Needs needs{scene};
  check_one_material(scene, needs);
  needs(is_box(scene), "an interval, or a box in 2D");
  needs(only_box_patches(scene), "conditions on left, right, top and bottom only");
  needs(starts_at_rest(scene), "zero initial displacement and velocity");
  const PatchConditions left(scene, "left"), right(scene, "right");
  needs(!left.has(Kind::moved) && !right.has(Kind::moved), "no prescribed motion");
  needs(left.has(Kind::loaded, 0) != right.has(Kind::loaded, 0),
        "a traction on exactly one of left and right");
  needs(all_conditions(scene,
                       [](const Condition& c) {
                         return c.kind != Kind::loaded || c.across || c.component == 0;
                       }),
        "loads along x only");
  if (scene.dimension == 1) return;
  for (const char* side : {"top", "bottom"}) {
    const PatchConditions patch(scene, side);
    needs(patch.has(Kind::fixed, 1) && !patch.has(Kind::fixed, 0) && !patch.has(Kind::loaded) &&
              !patch.has(Kind::moved),
          "symmetry on top and bottom, so that the wave is plane");
  }
}

bool is_square_at_origin(const Scene& scene) {
  const auto* box = box_of<2>(scene);
  if (!box) return false;
  const double side = box->upper.x() - box->lower.x();
  return std::abs(box->lower.x()) <= 1e-12 * side && std::abs(box->lower.y()) <= 1e-12 * side &&
         std::abs(box->upper.y() - box->upper.x()) <= 1e-12 * side;
}

void check_swinging_plate(const Scene& scene) {
  const Needs needs{scene};
  check_one_material(scene, needs);
  needs(is_square_at_origin(scene), "a square box with its lower left corner at the origin, in 2D");
  needs(scene.displacement.kind == InitialField::Kind::swinging_plate,
        "initial.displacement = { field = \"swinging-plate\", amplitude = … }");
  needs(scene.velocity.kind == InitialField::Kind::zero, "zero initial velocity");
  needs(only_box_patches(scene), "conditions on left, right, top and bottom only");
  for (const char* side : {"left", "right", "top", "bottom"}) {
    const PatchConditions patch(scene, side);
    const bool hold_x = std::string(side) == "left" || std::string(side) == "top";
    needs(!patch.has(Kind::loaded) && !patch.has(Kind::moved), "no loads and no prescribed motion");
    needs(patch.has(Kind::fixed, 0) == hold_x && patch.has(Kind::fixed, 1) != hold_x,
          "x fixed on left and top, y fixed on bottom and right");
  }
}

void check_uniform_stretch(const Scene& scene) {
  const Needs needs{scene};
  check_one_material(scene, needs);
  needs(is_box(scene), "an interval, or a box in 2D");
  const PatchConditions left(scene, "left"), right(scene, "right");
  const auto moves = [](const PatchConditions& side) { return side.has(Kind::moved, 0); };
  const auto given = [&](const PatchConditions& side) {
    return moves(side) || side.has(Kind::fixed, 0);
  };
  needs(moves(left) || moves(right), "displacement of x prescribed on left or right");
  needs(given(left) && given(right), "both left and right held or moved in x");
  needs(all_conditions(scene, [](const Condition& c) { return c.kind != Kind::loaded; }),
        "no loads");
}

void check_initial(const InitialField& field, const Scene& scene) {
  if (field.kind == InitialField::Kind::swinging_plate && !is_square_at_origin(scene))
    throw InputError(field.place,
                     "the swinging plate is a square box with its lower left corner at the origin");
  if (field.kind == InitialField::Kind::cantilever_mode && !box_of<2>(scene))
    throw InputError(field.place,
                     "the cantilever mode is that of a box in 2D, clamped at its left");
}

}  // namespace

void check_exact(const Scene& scene) {
  check_initial(scene.displacement, scene);
  check_initial(scene.velocity, scene);
  for (const InitialRegion& region : scene.initial_regions)
    for (const auto& field : {region.displacement, region.velocity})
      if (field) check_initial(*field, scene);
  if (scene.exact != ExactKind::none) {
    const Needs needs{scene};
    needs(scene.initial_regions.empty(), "one initial state all over the body");
    needs(all_conditions(scene, [](const Condition& c) { return c.kind != Kind::held; }),
          "fixed patches in place of held ones");
  }
  switch (scene.exact) {
    case ExactKind::none:
      return;
    case ExactKind::bar_wave:
      return check_bar_wave(scene);
    case ExactKind::swinging_plate:
      return check_swinging_plate(scene);
    case ExactKind::uniform_stretch:
      return check_uniform_stretch(scene);
  }
}

}  // namespace tlsph
