#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "parts.hpp"

namespace tlsph {

template <int D>
int normal_axis(const Patch<D>& patch, const Place& place) {
  int axis = -1;
  for (const Face<D>& face : patch.faces) {
    const auto has = [&](int node) { return std::ranges::binary_search(patch.nodes, node); };
    if (!std::ranges::all_of(face.nodes, has)) continue;  // moves with a particle that is free
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
    throw InputError(place, fmt::format("symmetry: \"{}\" has no boundary between its particles; "
                                        "fix components by name instead",
                                        patch.name));
  return axis;
}

template int normal_axis<1>(const Patch<1>&, const Place&);
template int normal_axis<2>(const Patch<2>&, const Place&);

namespace parts {
namespace {

template <int D>
std::string text_of(const Vector<D>& x) {
  if constexpr (D == 1) return fmt::format("{:.4g}", x[0]);
  return fmt::format("({:.4g}, {:.4g})", x[0], x[D - 1]);
}

/// A patch and the box around it, "left (0, 0) to (0, 1)".
template <int D>
std::string name_and_place(const Particles<D>& particles, const Patch<D>& patch) {
  if (patch.nodes.empty()) return patch.name;
  const auto X = particles.X(patch.nodes, Eigen::all);
  const Vector<D> lower = X.colwise().minCoeff().transpose();
  const Vector<D> upper = X.colwise().maxCoeff().transpose();
  if (lower == upper) return fmt::format("{} {}", patch.name, text_of<D>(lower));
  return fmt::format("{} {} to {}", patch.name, text_of<D>(lower), text_of<D>(upper));
}

template <int D>
std::string patch_names(const Particles<D>& particles) {
  constexpr std::size_t most_edges = 24;
  std::vector<std::string> names;
  for (const Patch<D>& patch : particles.patches)
    names.push_back(name_and_place<D>(particles, patch));
  for (std::size_t k = 0; k < std::min(most_edges, particles.edges.size()); ++k)
    names.push_back(name_and_place<D>(particles, particles.edges[k]));
  if (particles.edges.size() > most_edges)
    names.push_back(fmt::format("… {}", particles.edges.back().name));
  return fmt::format("{}", fmt::join(names, "; "));
}

template <int D>
const Patch<D>& patch_of(const Particles<D>& particles, const BoundaryScene& boundary) {
  if (const Patch<D>* patch = particles.find(boundary.where)) return *patch;
  throw InputError(boundary.place,
                   fmt::format("the body has no boundary \"{}\"; it has, with the smallest box "
                               "around each [m]: {}",
                               boundary.where, patch_names<D>(particles)));
}

bool is_zero(const Curve& curve) {
  const auto* constant = std::get_if<ConstantCurve>(&curve);
  return constant != nullptr && constant->amplitude == 0.0;
}

/// What becomes of a degree of freedom; `curve` moves it.
struct Prescription {
  enum class Kind { fixed, held, moved } kind = Kind::fixed;
  std::size_t curve = 0;
  [[nodiscard]] bool operator==(const Prescription&) const = default;
};

template <int D>
class ConstraintList {
 public:
  explicit ConstraintList(const Particles<D>& particles) : particles_(particles) {}

  void fix(const Patch<D>& patch, int component, const BoundaryScene& by) {
    set(patch, component, {Prescription::Kind::fixed}, by);
  }
  void hold(const Patch<D>& patch, int component, const BoundaryScene& by) {
    set(patch, component, {Prescription::Kind::held}, by);
  }
  void move(const Patch<D>& patch, int component, const Curve& curve, const BoundaryScene& by) {
    if (is_zero(curve)) return fix(patch, component, by);
    list_.curves.push_back(curve);
    set(patch, component, {Prescription::Kind::moved, list_.curves.size() - 1}, by);
  }
  [[nodiscard]] Constraints finish() {
    for (const auto& [dof, entry] : prescribed_) switch (entry.prescription.kind) {
        case Prescription::Kind::fixed:
          list_.fixed.push_back(dof);
          break;
        case Prescription::Kind::held:
          list_.held.push_back(dof);
          break;
        case Prescription::Kind::moved:
          list_.moved.push_back({dof, entry.prescription.curve});
          break;
      }
    return std::move(list_);
  }

 private:
  struct Entry {
    Prescription prescription;
    const BoundaryScene* by = nullptr;
  };

  void set(const Patch<D>& patch, int component, const Prescription& prescription,
           const BoundaryScene& by) {
    for (const int node : patch.nodes) set(node, component, prescription, by);
  }
  void set(int node, int component, const Prescription& prescription, const BoundaryScene& by) {
    const Index dof = Index{node} * D + component;
    const auto [entry, fresh] = prescribed_.try_emplace(dof, Entry{prescription, &by});
    if (fresh || entry->second.prescription == prescription) return;
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
  std::map<Index, Entry> prescribed_;
};

}  // namespace

template <int D>
void add_conditions(const Scene& scene, Discretisation<D>& disc) {
  const Particles<D>& particles = disc.particles;
  ConstraintList<D> constraints(particles);
  std::set<std::pair<std::string, int>> booked;  // reactions of these patches and components
  for (const BoundaryScene& boundary : scene.boundaries) {
    const Patch<D>& patch = patch_of<D>(particles, boundary);
    const bool constrained = !boundary.fixed.empty() || !boundary.held.empty() ||
                             boundary.symmetry || !boundary.motion.empty();
    if (constrained && patch.nodes.empty())
      throw InputError(boundary.place,
                       fmt::format("\"{}\" holds a part of the boundary but no particle; it can be "
                                   "loaded, not held or moved",
                                   patch.name));
    for (const int component : boundary.fixed) constraints.fix(patch, component, boundary);
    for (const int component : boundary.held) constraints.hold(patch, component, boundary);
    if (boundary.symmetry) {
      if (particles.placement == NodePlacement::cell_centred)
        throw InputError(boundary.place,
                         "symmetry needs particles on the boundary; use body.placement = "
                         "\"on-boundary\"");
      constraints.fix(patch, normal_axis<D>(patch, boundary.place), boundary);
    }
    for (const ComponentCurve& motion : boundary.motion)
      constraints.move(patch, motion.component, motion.curve, boundary);
    if (!disc.adjoint) {
      std::set<int> held(boundary.fixed.begin(), boundary.fixed.end());
      if (boundary.symmetry) held.insert(normal_axis<D>(patch, boundary.place));
      for (const int component : held)
        if (booked.insert({boundary.where, component}).second)
          std::ranges::copy(reaction_terms<D>(patch, component),
                            std::back_inserter(disc.reactions));
    }
    const bool loaded = boundary.normal_traction || !boundary.traction.empty();
    if (loaded && patch.faces.empty())
      throw InputError(
          boundary.place,
          fmt::format("\"{}\" holds particles but no part of the boundary; it can be held or "
                      "moved, not loaded",
                      patch.name));
    if (boundary.normal_traction)
      disc.loads.push_back(normal_traction<D>(patch, *boundary.normal_traction));
    for (const ComponentCurve& traction : boundary.traction)
      disc.loads.push_back(component_traction<D>(patch, traction.component, traction.curve));
  }
  disc.constraints = constraints.finish();
  for (std::size_t a = 0; a < scene.body_force.size(); ++a)
    disc.body_force[static_cast<Index>(a)] = scene.body_force[a];

  disc.inverse_mass = disc.mass.cwiseInverse().replicate(1, D);
  for (const auto* still : {&disc.constraints.fixed, &disc.constraints.held})
    for (const Index dof : *still) disc.inverse_mass.data()[dof] = 0.0;
  for (const auto& motion : disc.constraints.moved) disc.inverse_mass.data()[motion.dof] = 0.0;
}

template void add_conditions<1>(const Scene&, Discretisation<1>&);
template void add_conditions<2>(const Scene&, Discretisation<2>&);

}  // namespace parts
}  // namespace tlsph
