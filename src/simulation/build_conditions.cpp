#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "parts.hpp"

namespace tlsph::parts {
namespace {

template <int D>
std::string patch_names(const Particles<D>& particles) {
  std::string text;
  for (const Patch<D>& patch : particles.patches) text += (text.empty() ? "" : ", ") + patch.name;
  return text;
}

template <int D>
const Patch<D>& patch_of(const Particles<D>& particles, const BoundaryScene& boundary) {
  if (const Patch<D>* patch = particles.find(boundary.where)) return *patch;
  throw InputError(boundary.place, fmt::format("the body has no boundary \"{}\"; it has {}",
                                               boundary.where, patch_names<D>(particles)));
}

bool is_zero(const Curve& curve) {
  const auto* constant = std::get_if<ConstantCurve>(&curve);
  return constant != nullptr && constant->amplitude == 0.0;
}

/// Which curve moves a degree of freedom, or none where it is held.
struct Prescription {
  std::optional<std::size_t> curve;
  const BoundaryScene* by = nullptr;
};

template <int D>
class ConstraintList {
 public:
  explicit ConstraintList(const Particles<D>& particles) : particles_(particles) {}

  void hold(const Patch<D>& patch, int component, const BoundaryScene& by) {
    for (const int node : patch.nodes) set(node, component, std::nullopt, by);
  }
  void move(const Patch<D>& patch, int component, const Curve& curve, const BoundaryScene& by) {
    if (is_zero(curve)) return hold(patch, component, by);
    list_.curves.push_back(curve);
    for (const int node : patch.nodes) set(node, component, list_.curves.size() - 1, by);
  }
  [[nodiscard]] Constraints finish() {
    for (const auto& [dof, prescription] : prescribed_) {
      if (prescription.curve)
        list_.moved.push_back({dof, *prescription.curve});
      else
        list_.fixed.push_back(dof);
    }
    return std::move(list_);
  }

 private:
  void set(int node, int component, std::optional<std::size_t> curve, const BoundaryScene& by) {
    const Index dof = Index{node} * D + component;
    const auto [entry, fresh] = prescribed_.try_emplace(dof, Prescription{curve, &by});
    if (fresh || entry->second.curve == curve) return;
    std::string at;
    for (int a = 0; a < D; ++a)
      at += fmt::format("{}{:.6g}", a == 0 ? "" : ", ", particles_.X(node, a));
    throw InputError(
        by.place,
        fmt::format("contradicts the boundary \"{}\": the particle at ({}) would have two "
                    "displacements in {}; let one of them leave the component free",
                    entry->second.by->where, at, "xyz"[component]));
  }

  const Particles<D>& particles_;
  Constraints list_;
  std::map<Index, Prescription> prescribed_;
};

}  // namespace

template <int D>
int normal_axis(const Patch<D>& patch, const Place& place) {
  int axis = -1;
  for (const Face<D>& face : patch.faces) {
    Index direction = 0;
    const double largest = face.area.cwiseAbs().maxCoeff(&direction);
    const bool aligned = face.area.cwiseAbs().sum() - largest <= 1e-9 * largest;
    if (!aligned || (axis >= 0 && axis != direction))
      throw InputError(place, fmt::format("symmetry: \"{}\" is no straight edge along an axis; fix "
                                          "components by name instead",
                                          patch.name));
    axis = static_cast<int>(direction);
  }
  if (axis < 0)
    throw InputError(place, fmt::format("\"{}\" has no boundary faces, only particles; it can be "
                                        "fixed or moved, not loaded or mirrored",
                                        patch.name));
  return axis;
}

template <int D>
void add_conditions(const Scene& scene, Discretisation<D>& disc) {
  const Particles<D>& particles = disc.particles;
  ConstraintList<D> constraints(particles);
  for (const BoundaryScene& boundary : scene.boundaries) {
    const Patch<D>& patch = patch_of<D>(particles, boundary);
    for (const int component : boundary.fixed) constraints.hold(patch, component, boundary);
    if (boundary.symmetry) {
      if (particles.placement == NodePlacement::cell_centred)
        throw InputError(boundary.place,
                         "symmetry needs particles on the boundary; use body.placement = "
                         "\"on-boundary\"");
      constraints.hold(patch, normal_axis<D>(patch, boundary.place), boundary);
    }
    for (const ComponentCurve& motion : boundary.motion)
      constraints.move(patch, motion.component, motion.curve, boundary);
    const bool loaded = boundary.normal_traction || !boundary.traction.empty();
    if (loaded && patch.faces.empty())
      throw InputError(
          boundary.place,
          fmt::format("\"{}\" has no boundary faces to load, only particles", patch.name));
    if (boundary.normal_traction)
      disc.loads.push_back(normal_traction<D>(patch, *boundary.normal_traction));
    for (const ComponentCurve& traction : boundary.traction)
      disc.loads.push_back(component_traction<D>(patch, traction.component, traction.curve));
  }
  disc.constraints = constraints.finish();
  for (std::size_t a = 0; a < scene.body_force.size(); ++a)
    disc.body_force[static_cast<Index>(a)] = scene.body_force[a];

  disc.inverse_mass = disc.mass.cwiseInverse().replicate(1, D);
  for (const Index dof : disc.constraints.fixed) disc.inverse_mass.data()[dof] = 0.0;
  for (const auto& motion : disc.constraints.moved) disc.inverse_mass.data()[motion.dof] = 0.0;
}

template int normal_axis<1>(const Patch<1>&, const Place&);
template int normal_axis<2>(const Patch<2>&, const Place&);
template void add_conditions<1>(const Scene&, Discretisation<1>&);
template void add_conditions<2>(const Scene&, Discretisation<2>&);

}  // namespace tlsph::parts
