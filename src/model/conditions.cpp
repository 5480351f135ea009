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
namespace {

/// Axis a patch is perpendicular to. InputError if it is no straight axis-aligned edge.
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

}  // namespace

template <int D>
std::vector<Condition> conditions_on(const Patch<D>& patch, const BoundaryScene& entry) {
  return conditions_of(entry, entry.symmetry ? normal_axis<D>(patch, entry.place) : unknown_axis);
}

template <int D>
Load load_of(const Patch<D>& patch, const Condition& condition) {
  return condition.across ? normal_traction<D>(patch, *condition.curve)
                          : component_traction<D>(patch, condition.component, *condition.curve);
}

template std::vector<Condition> conditions_on<1>(const Patch<1>&, const BoundaryScene&);
template std::vector<Condition> conditions_on<2>(const Patch<2>&, const BoundaryScene&);
template Load load_of<1>(const Patch<1>&, const Condition&);
template Load load_of<2>(const Patch<2>&, const Condition&);

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
  Condition::Kind kind = Condition::Kind::fixed;
  std::size_t curve = 0;
  [[nodiscard]] bool operator==(const Prescription&) const = default;
};

template <int D>
class ConstraintList {
 public:
  explicit ConstraintList(const Particles<D>& particles) : particles_(particles) {}

  /// What a condition that is no load does to the nodes of its patch.
  void add(const Patch<D>& patch, const Condition& condition, const BoundaryScene& by) {
    Prescription prescription{condition.kind};
    if (condition.kind == Condition::Kind::moved) {
      if (is_zero(*condition.curve)) {
        prescription.kind = Condition::Kind::fixed;
      } else {
        prescription.curve = list_.curves.size();
        list_.curves.push_back(*condition.curve);
      }
    }
    for (const int node : patch.nodes) set(node, condition.component, prescription, by);
  }
  [[nodiscard]] Constraints finish() {
    for (const auto& [dof, entry] : prescribed_)
      if (entry.prescription.kind == Condition::Kind::fixed)
        list_.fixed.push_back(dof);
      else if (entry.prescription.kind == Condition::Kind::held)
        list_.held.push_back(dof);
      else
        list_.moved.push_back({dof, entry.prescription.curve});
    return std::move(list_);
  }

 private:
  struct Entry {
    Prescription prescription;
    const BoundaryScene* by = nullptr;
  };

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

/// Refuses what a patch cannot carry.
template <int D>
void check_patch(const Patch<D>& patch, const Condition& condition, const BoundaryScene& by) {
  const bool loaded = condition.kind == Condition::Kind::loaded;
  if (loaded && patch.faces.empty())
    throw InputError(
        by.place,
        fmt::format("\"{}\" holds particles but no part of the boundary; it can be held or "
                    "moved, not loaded",
                    patch.name));
  if (!loaded && patch.nodes.empty())
    throw InputError(by.place, fmt::format("\"{}\" holds a part of the boundary but no particle; "
                                           "it can be loaded, not held or moved",
                                           patch.name));
}

}  // namespace

template <int D>
void add_conditions(const Scene& scene, Discretisation<D>& body) {
  const Particles<D>& particles = body.particles;
  ConstraintList<D> constraints(particles);
  std::set<std::pair<std::string, int>> booked;  // reactions of these patches and components
  for (const BoundaryScene& boundary : scene.boundaries) {
    const Patch<D>& patch = patch_of<D>(particles, boundary);
    if (boundary.symmetry && particles.placement == NodePlacement::cell_centred)
      throw InputError(boundary.place,
                       "symmetry needs particles on the boundary; use body.placement = "
                       "\"on-boundary\"");
    for (const Condition& condition : conditions_on<D>(patch, boundary)) {
      check_patch<D>(patch, condition, boundary);
      if (condition.kind == Condition::Kind::loaded) {
        body.loads.push_back(load_of<D>(patch, condition));
        continue;
      }
      constraints.add(patch, condition, boundary);
      const int i = condition.component;
      if (!body.adjoint && condition.kind == Condition::Kind::fixed &&
          booked.insert({boundary.where, i}).second)
        std::ranges::copy(reaction_terms<D>(patch, i), std::back_inserter(body.reactions));
    }
  }
  body.constraints = constraints.finish();
  for (std::size_t a = 0; a < scene.body_force.size(); ++a)
    body.body_force[static_cast<Index>(a)] = scene.body_force[a];

  body.inverse_mass = body.mass.cwiseInverse().replicate(1, D);
  for (const auto* still : {&body.constraints.fixed, &body.constraints.held})
    for (const Index dof : *still) body.inverse_mass.data()[dof] = 0.0;
  for (const auto& motion : body.constraints.moved) body.inverse_mass.data()[motion.dof] = 0.0;
}

template void add_conditions<1>(const Scene&, Discretisation<1>&);
template void add_conditions<2>(const Scene&, Discretisation<2>&);

}  // namespace parts
}  // namespace tlsph
