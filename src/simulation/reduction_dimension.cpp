// A strip between rollers is a bar.
#include <fmt/format.h>

#include <algorithm>

#include "reduction_parts.hpp"
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

std::vector<std::string> initial_overrides(const char* key, const InitialField& field) {
  if (field.kind == InitialField::Kind::zero) return {};
  return {fmt::format("initial.{}={{constant=[{:.17g}],gradient=[[{:.17g}]]}}", key,
                      field.constant[0], field.gradient.empty() ? 0.0 : field.gradient[0][0])};
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

  Reduction reduction;
  reduction.what = "1D: nothing depends on y";
  reduction.overrides = {"dimension=1", fmt::format("body.shape={{interval=[{:.17g},{:.17g}]}}",
                                                    box->lower.x(), box->upper.x())};
  reduction.removed = {"body.fit"};
  std::vector<std::string> conditions;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < scene.boundaries.size(); ++k) {
    const BoundaryScene& entry = scene.boundaries[k];
    if (entry.where != "left" && entry.where != "right") {
      if (entry.where != "top" && entry.where != "bottom") return std::nullopt;
      conditions.push_back(fmt::format("boundary[{}]", k));
      continue;
    }
    if (!acts_along_x(entry)) return std::nullopt;
    const bool holds = std::ranges::find(entry.fixed, 0) != entry.fixed.end();
    if (!holds && !entry.symmetry && entry.motion.empty() && !entry.normal_traction) {
      conditions.push_back(fmt::format("boundary[{}]", k));  // it held y alone
      continue;
    }
    if (!entry.fixed.empty() && !holds)
      reduction.removed.push_back(fmt::format("boundary[{}].fixed", k));
    if (holds) reduction.overrides.push_back(fmt::format("boundary[{}].fixed=true", kept));
    ++kept;
  }
  reduction.removed.insert(reduction.removed.end(), conditions.rbegin(), conditions.rend());
  for (std::size_t k = 1; k < scene.materials.size(); ++k) {
    const MaterialScene& region = scene.materials[k];
    if (region.lower[1] > box->lower.y() || region.upper[1] < box->upper.y()) return std::nullopt;
    reduction.overrides.push_back(fmt::format("material.region[{}].box=[{:.17g},{:.17g}]", k - 1,
                                              region.lower[0], region.upper[0]));
  }
  for (std::size_t k = 0; k < scene.probes.size(); ++k)
    reduction.overrides.push_back(fmt::format("probe[{}].at=[{:.17g}]", k, scene.probes[k].at[0]));
  if (!scene.body_force.empty())
    reduction.overrides.push_back(fmt::format("gravity=[{:.17g}]", scene.body_force[0]));
  for (const auto& [key, field] :
       {std::pair("displacement", scene.displacement), std::pair("velocity", scene.velocity)})
    for (std::string& text : initial_overrides(key, field))
      reduction.overrides.push_back(std::move(text));
  return reduction;
}

}  // namespace tlsph
