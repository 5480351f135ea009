#pragma once
/// \file
/// The quantities that can be observed. A new one is a row of the table: what a scene may name,
/// probes, frames and exact histories follow.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tlsph/core/field.hpp"
#include "tlsph/dynamics/measures.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/exact/exact.hpp"

namespace tlsph {

/// What quantities are evaluated from: the motion of a particle, the strain and stress of a
/// material point.
template <int D>
struct Observed {
  Vector<D> u = Vector<D>::Zero(), v = Vector<D>::Zero(), a = Vector<D>::Zero();  ///< m, m/s, m/s²
  Tensor<D> H = Tensor<D>::Zero(), P = Tensor<D>::Zero();                         ///< 1, Pa
  StressMeasures<D> stress;

  /// Adds a share of what was observed elsewhere, all but `stress`.
  void add(double weight, const Observed& other) {
    u += weight * other.u;
    v += weight * other.v;
    a += weight * other.a;
    H += weight * other.H;
    P += weight * other.P;
  }
};

template <int D>
struct Quantity {
  std::string_view name;
  Site site;
  Rank rank;
  std::string_view unit;
  /// Component (i, j); a vector has no j, a scalar neither.
  double (*value)(const Observed<D>&, int i, int j);
  /// The same at X and t of an exact solution, where it knows the quantity.
  double (*exact)(const ExactSolution<D>&, const Vector<D>& X, double t, int i, int j) = nullptr;
  /// Components (i, j) and (j, i) are equal, and a history has one of them.
  bool symmetric = false;
};

template <int D>
inline constexpr auto quantities = std::to_array<Quantity<D>>({
    {"displacement", Site::particles, Rank::vector, "m",
     [](const Observed<D>& o, int i, int) { return o.u[i]; },
     [](const ExactSolution<D>& exact, const Vector<D>& X, double t, int i, int) {
       return exact.displacement(X, t)[i];
     }},
    {"velocity", Site::particles, Rank::vector, "m/s",
     [](const Observed<D>& o, int i, int) { return o.v[i]; },
     [](const ExactSolution<D>& exact, const Vector<D>& X, double t, int i, int) {
       return exact.velocity(X, t)[i];
     }},
    {"acceleration", Site::particles, Rank::vector, "m/s^2",
     [](const Observed<D>& o, int i, int) { return o.a[i]; }},
    {"deformation_gradient", Site::points, Rank::tensor, "1",
     [](const Observed<D>& o, int i, int j) { return (i == j ? 1.0 : 0.0) + o.H(i, j); }},
    {"pk1", Site::points, Rank::tensor, "Pa",
     [](const Observed<D>& o, int i, int j) { return o.P(i, j); },
     [](const ExactSolution<D>& exact, const Vector<D>& X, double t, int i, int j) {
       return exact.stress(X, t)(i, j);
     }},
    {"cauchy", Site::points, Rank::tensor, "Pa",
     [](const Observed<D>& o, int i, int j) { return o.stress.cauchy(i, j); },
     [](const ExactSolution<D>& exact, const Vector<D>& X, double t, int i, int j) {
       return exact.stress(X, t)(i, j);
     },
     true},
    {"pressure", Site::points, Rank::scalar, "Pa",
     [](const Observed<D>& o, int, int) { return o.stress.pressure; }},
    {"von_mises", Site::points, Rank::scalar, "Pa",
     [](const Observed<D>& o, int, int) { return o.stress.von_mises; }},
});

/// The names of all quantities.
inline constexpr auto quantity_names = [] {
  std::array<std::string_view, quantities<1>.size()> names;
  for (std::size_t k = 0; k < names.size(); ++k) names[k] = quantities<1>[k].name;
  return names;
}();

/// The quantity of a name, or null.
template <int D>
[[nodiscard]] const Quantity<D>* find_quantity(std::string_view name);
/// The quantity of a name; InputError if there is none.
template <int D>
[[nodiscard]] const Quantity<D>& quantity_named(std::string_view name);

/// Calls `take(i, j)` for each component, row by row; of a symmetric tensor from the diagonal on.
template <int D, class Take>
void for_components(Rank rank, bool symmetric, const Take& take) {
  const int rows = rank == Rank::scalar ? 1 : D;
  const int columns = rank == Rank::tensor ? D : 1;
  for (int i = 0; i < rows; ++i)
    for (int j = symmetric ? i : 0; j < columns; ++j) take(i, j);
}

/// The motion of a particle.
template <int D>
[[nodiscard]] Observed<D> observed_particle(const Instant<D>& now, Index particle);
/// H and P of a material point; the same with their measures.
template <int D>
[[nodiscard]] Observed<D> observed_strain(const Instant<D>& now, Index point);
template <int D>
[[nodiscard]] Observed<D> observed_point(const Instant<D>& now, Index point);

/// What stands behind the name of a quantity in the names of its columns, in their order: `_x` …,
/// `_xy` …, nothing for a scalar.
template <int D>
[[nodiscard]] std::vector<std::string> component_suffixes(const Quantity<D>& quantity);

}  // namespace tlsph
