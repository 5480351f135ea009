// A strip between rollers is a bar.
#include <algorithm>

#include "reduction_parts.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/scene/conditions.hpp"
#include "tlsph/simulation/reduction.hpp"

namespace tlsph {
namespace {

using Kind = Condition::Kind;

bool slides(const Scene& scene, const std::string& side) {
  const PatchConditions conditions(scene, side);
  return conditions.has(Kind::fixed, 1) && !conditions.has(Kind::fixed, 0) &&
         !conditions.has(Kind::held) && !conditions.has(Kind::moved) &&
         !conditions.has(Kind::loaded);
}

/// Left and right do to the body what they may do in 1D.
bool acts_along_x(const BoundaryScene& entry) {
  return std::ranges::all_of(conditions_of(entry, 0), [](const Condition& c) {
    return c.kind == Kind::fixed || (c.kind == Kind::moved && c.component == 0) ||
           (c.kind == Kind::loaded && c.across);
  });
}

bool depends_on_x_only(const InitialField& field) {
  if (field.kind == InitialField::Kind::zero) return true;
  if (field.kind != InitialField::Kind::linear || field.constant[1] != 0.0) return false;
  const auto& g = field.gradient;
  return g.empty() || (g[0][1] == 0.0 && g[1][0] == 0.0 && g[1][1] == 0.0);
}

/// Its part along x.
InitialField along_x(const InitialField& field) {
  InitialField bar = field;
  if (field.kind == InitialField::Kind::zero) return bar;
  bar.constant = {field.constant[0]};
  bar.gradient = {{field.gradient.empty() ? 0.0 : field.gradient[0][0]}};
  return bar;
}

/// What left or right does in 1D; nothing where it held y alone.
std::optional<BoundaryScene> end_of_bar(const BoundaryScene& entry) {
  BoundaryScene end = entry;
  const bool holds = std::ranges::find(entry.fixed, 0) != entry.fixed.end();
  if (!holds && !entry.symmetry && entry.motion.empty() && !entry.normal_traction)
    return std::nullopt;
  end.fixed = holds ? std::vector{0} : std::vector<int>{};
  return end;
}

}  // namespace

std::optional<Reduction> to_one_dimension(const Scene& scene) {
  const Box<2>* box = plain_box(scene);
  if (box == nullptr || scene.materials.front().assumption != Assumption::strain)
    return std::nullopt;
  if (!slides(scene, "top") || !slides(scene, "bottom")) return std::nullopt;
  if (!scene.body_force.empty() && scene.body_force[1] != 0.0) return std::nullopt;
  if (!depends_on_x_only(scene.displacement) || !depends_on_x_only(scene.velocity))
    return std::nullopt;

  Reduction reduction{"1D: nothing depends on y", scene};
  Scene& bar = reduction.scene;
  bar.dimension = 1;
  bar.body.shape = make_interval(box->lower.x(), box->upper.x());
  const BodyScene standard;
  bar.body.fit = standard.fit;
  bar.boundaries.clear();
  for (const BoundaryScene& entry : scene.boundaries) {
    if (entry.where == "top" || entry.where == "bottom") continue;
    if ((entry.where != "left" && entry.where != "right") || !acts_along_x(entry))
      return std::nullopt;
    if (auto end = end_of_bar(entry)) bar.boundaries.push_back(std::move(*end));
  }
  for (std::size_t k = 1; k < bar.materials.size(); ++k) {
    MaterialScene& region = bar.materials[k];
    if (region.lower[1] > box->lower.y() || region.upper[1] < box->upper.y()) return std::nullopt;
    region.lower.resize(1);
    region.upper.resize(1);
  }
  for (ProbeScene& probe : bar.probes) probe.at.resize(1);
  if (!bar.body_force.empty()) bar.body_force.resize(1);
  bar.displacement = along_x(scene.displacement);
  bar.velocity = along_x(scene.velocity);
  return reduction;
}

}  // namespace tlsph
