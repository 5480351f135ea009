#include "tlsph/scene/conditions.hpp"

#include <algorithm>

#include "tlsph/geometry/region.hpp"

namespace tlsph {

std::vector<Condition> conditions_of(const BoundaryScene& entry, int axis) {
  using Kind = Condition::Kind;
  std::vector<Condition> all;
  for (const int component : entry.fixed) all.push_back({Kind::fixed, component});
  for (const int component : entry.held) all.push_back({Kind::held, component});
  if (entry.symmetry) all.push_back({Kind::fixed, axis, true});
  for (const ComponentCurve& motion : entry.motion)
    all.push_back({Kind::moved, motion.component, false, &motion.curve});
  for (const ComponentCurve& load : entry.traction)
    all.push_back({Kind::loaded, load.component, false, &load.curve});
  if (entry.normal_traction) all.push_back({Kind::loaded, axis, true, &*entry.normal_traction});
  return all;
}

int patch_axis(const Scene& scene, const std::string& patch) {
  const auto* sheet = std::get_if<Shape<2>>(&scene.body.shape);
  if (sheet && !std::holds_alternative<Box<2>>(base_of(*sheet).form)) return unknown_axis;
  if (patch == "left" || patch == "right") return 0;
  if (patch == "top" || patch == "bottom") return 1;
  return unknown_axis;
}

PatchConditions::PatchConditions(const Scene& scene, const std::string& patch) {
  for (const BoundaryScene& entry : scene.boundaries)
    if (entry.where == patch)
      std::ranges::copy(conditions_of(entry, patch_axis(scene, patch)), std::back_inserter(all_));
}

const Condition* PatchConditions::find(Kind kind, int component) const {
  const auto found = std::ranges::find_if(
      all_, [&](const Condition& c) { return c.kind == kind && c.component == component; });
  return found == all_.end() ? nullptr : &*found;
}

bool PatchConditions::has(Kind kind) const {
  return std::ranges::find(all_, kind, &Condition::kind) != all_.end();
}

Curve tension(const Condition& load, double outward) {
  if (load.across || outward > 0.0) return *load.curve;
  return GivenCurve{[curve = *load.curve](double t) { return -value(curve, t); }};
}

}  // namespace tlsph
