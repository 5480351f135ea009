#include "tlsph/particles/moments.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <cmath>
#include <map>

#include "gauss.hpp"
#include "tlsph/geometry/outline.hpp"
#include "tlsph/particles/boundary_faces.hpp"
#include "tlsph/particles/boundary_runs.hpp"

namespace tlsph {
namespace {

/// Relative residual of the moments that counts as met.
constexpr double met = 1e-12;
constexpr int rounds = 3;

/// Coordinates about the middle of the body in units of its half size along each axis, so that
/// monomials stay of order one, in a strip too.
template <int D>
struct LocalFrame {
  Vector<D> middle;
  Vector<D> size;
  explicit LocalFrame(const VectorField<D>& X) {
    const Vector<D> lower = X.colwise().minCoeff().transpose();
    const Vector<D> upper = X.colwise().maxCoeff().transpose();
    middle = 0.5 * (lower + upper);
    size = 0.5 * (upper - lower);
  }
  [[nodiscard]] Vector<D> operator()(const Vector<D>& X) const {
    return (X - middle).cwiseQuotient(size);
  }
};

template <int D>
using Exponents = std::vector<std::array<int, D>>;

/// A point of a quadrature over the boundary with the area vector it stands for.
template <int D>
struct BoundaryPoint {
  Vector<D> X;
  Vector<D> area;
};

template <int D>
using BoundaryRule = std::vector<BoundaryPoint<D>>;

/// Along the faces between particles; exact for polynomials of degree seven.
template <int D>
BoundaryRule<D> along_faces(const VectorField<D>& X, const std::vector<Face<D>>& faces) {
  BoundaryRule<D> rule;
  for (const Face<D>& face : faces) {
    const Vector<D> from = X.row(face.nodes[0]).transpose();
    if constexpr (D == 1) {
      rule.push_back({from, face.area});
    } else {
      const Vector<2> to = X.row(face.nodes[1]).transpose();
      for (std::size_t k = 0; k < gauss_4.point.size(); ++k)
        rule.push_back({from + gauss_4.point[k] * (to - from), gauss_4.weight[k] * face.area});
    }
  }
  return rule;
}

/// Along the outline of a shape, to rounding on its arcs too.
BoundaryRule<2> along_outline(const Shape<2>& shape) {
  constexpr double longest_sweep = 0.05;
  BoundaryRule<2> rule;
  for (const OutlinePiece& piece : outline(shape)) {
    const int parts =
        piece.is_arc() ? static_cast<int>(std::ceil(std::abs(piece.sweep) / longest_sweep)) : 1;
    for (int part = 0; part < parts; ++part)
      for (std::size_t k = 0; k < gauss_4.point.size(); ++k) {
        const double t = (part + gauss_4.point[k]) / parts;
        rule.push_back({piece.at(t), gauss_4.weight[k] * piece.length() / parts * piece.normal(t)});
      }
  }
  return rule;
}

/// The x that differs least from `x`, Σ δx²/weight, with A x = exact (A: conditions × unknowns).
/// Combinations of conditions that vanish on the nodes to within `negligible` are left as they are:
/// of 1, y and x² those along a straight edge and a shallow arc, which differ there by the rounding
/// of its nodes (ε R/length). A itself is decomposed, for A·Aᵀ keeps only half of the digits of
/// such combinations. InputError if a residual, in units of `scale`, is left where unknowns could
/// do something about it, or one that is not negligible elsewhere.
Eigen::VectorXd least_change(Eigen::VectorXd x, const Eigen::VectorXd& weight,
                             const Eigen::MatrixXd& A, const Eigen::VectorXd& exact, double scale,
                             const char* unknowns, int degree, const Place& place) {
  constexpr double negligible = 1e-9;
  const Eigen::VectorXd root = weight.cwiseSqrt();
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(A * root.asDiagonal(),
                                        Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(negligible);
  for (int round = 0; round < rounds; ++round) x += root.cwiseProduct(svd.solve(exact - A * x));
  const Eigen::VectorXd left = (exact - A * x) / scale;
  const auto U = svd.matrixU().leftCols(svd.rank());
  const Eigen::VectorXd within = U * (U.transpose() * left);
  if (!(within.cwiseAbs().maxCoeff() <= met && left.cwiseAbs().maxCoeff() <= negligible))
    throw InputError(place, fmt::format("{} cannot integrate polynomials of degree {} exactly "
                                        "(residual {:.1e}); choose a finer spacing",
                                        unknowns, degree, left.cwiseAbs().maxCoeff()));
  return x;
}

/// Volumes: ∫ X^β dV by the divergence theorem along the first coordinate.
template <int D>
void correct_volumes(Particles<D>& particles, const BoundaryRule<D>& boundary, int degree,
                     const Place& place) {
  const LocalFrame<D> local(particles.X);
  const Exponents<D> exponents = monomials<D>(degree);
  const auto conditions = static_cast<Index>(exponents.size());
  Eigen::VectorXd exact = Eigen::VectorXd::Zero(conditions);
  for (const auto& [X, area] : boundary) {
    const Vector<D> x = local(X);
    const Eigen::VectorXd values = monomial_values<D>(exponents, x);
    for (Index k = 0; k < conditions; ++k)
      exact[k] += area[0] * local.size[0] * values[k] * x[0] /
                  (exponents[static_cast<std::size_t>(k)][0] + 1);
  }
  Eigen::MatrixXd A(conditions, particles.size());
  for (Index q = 0; q < particles.size(); ++q)
    A.col(q) = monomial_values<D>(exponents, local(particles.X.row(q).transpose()));
  particles.V =
      least_change(particles.V, particles.V, A, exact, exact[0], "node volumes", degree, place);
  if (!(particles.V.minCoeff() > 0.0))
    throw InputError(place,
                     "a node volume exact for polynomials would not be positive; choose a "
                     "finer spacing");
}

/// Shares: one a face end, along the normal of the face.
template <int D>
void correct_shares(const VectorField<D>& X, std::vector<Face<D>>& faces,
                    const BoundaryRule<D>& boundary, int degree, const Place& place) {
  const LocalFrame<D> local(X);
  const Exponents<D> exponents = monomials<D>(degree);
  const auto count = static_cast<Index>(exponents.size());
  const auto unknowns = static_cast<Index>(faces.size()) * D;
  Eigen::MatrixXd A(count * D, unknowns);
  Eigen::VectorXd exact = Eigen::VectorXd::Zero(count * D);
  Eigen::VectorXd shares(unknowns);
  Eigen::VectorXd weight(unknowns);
  for (const auto& [at, area] : boundary) {
    const Eigen::VectorXd values = monomial_values<D>(exponents, local(at));
    for (int a = 0; a < D; ++a) exact.segment(a * count, count) += area[a] * values;
  }
  double total = 0.0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Face<D>& face = faces[f];
    total += face.area.norm();
    for (std::size_t k = 0; k < D; ++k) {
      const Index column = static_cast<Index>(f) * D + static_cast<Index>(k);
      const Eigen::VectorXd values =
          monomial_values<D>(exponents, local(X.row(face.nodes[k]).transpose()));
      for (int a = 0; a < D; ++a) A.col(column).segment(a * count, count) = face.area[a] * values;
      shares[column] = face.share[k];
      weight[column] = 1.0 / face.area.norm();
    }
  }
  shares = least_change(shares, weight, A, exact, total, "boundary areas", degree, place);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < D; ++k)
      faces[f].share[k] = shares[static_cast<Index>(f) * D + static_cast<Index>(k)];
}

}  // namespace

template <int D>
std::vector<std::array<int, D>> monomials(int degree) {
  std::vector<std::array<int, D>> exponents;
  for (int total = 0; total <= degree; ++total)
    if constexpr (D == 1)
      exponents.push_back({total});
    else
      for (int i = total; i >= 0; --i) exponents.push_back({i, total - i});
  return exponents;
}

template <int D>
Eigen::VectorXd monomial_values(const std::vector<std::array<int, D>>& exponents,
                                const Vector<D>& X) {
  Eigen::VectorXd values(static_cast<Index>(exponents.size()));
  for (Index k = 0; k < values.size(); ++k) {
    double product = 1.0;
    for (std::size_t a = 0; a < D; ++a)
      for (int times = 0; times < exponents[static_cast<std::size_t>(k)][a]; ++times)
        product *= X[static_cast<Index>(a)];
    values[k] = product;
  }
  return values;
}

template <int D>
Particles<D> with_exact_moments(Particles<D> particles, QuadratureDegrees degrees,
                                const Shape<D>* shape, const Place& place) {
  const Patch<D>* boundary = particles.find("boundary");
  if (boundary == nullptr || particles.placement == NodePlacement::cell_centred)
    throw InputError(place,
                     "exact moments need particles on the boundary; use body.placement = "
                     "\"on-boundary\"");
  std::vector<Face<D>> faces = boundary->faces;
  BoundaryRule<D> rule;
  if constexpr (D == 2)
    if (shape != nullptr) rule = along_outline(*shape);
  if (rule.empty()) rule = along_faces<D>(particles.X, faces);
  if constexpr (D == 2)
    if (degrees.boundary > 2) make_shares_cubic(particles.X, faces);
  correct_volumes<D>(particles, rule, degrees.volume, place);
  correct_shares<D>(particles.X, faces, rule, degrees.boundary, place);
  std::map<std::array<int, D>, std::array<double, D>> shares;
  for (const Face<D>& face : faces) shares[face.nodes] = face.share;
  for (auto* list : {&particles.patches, &particles.edges})
    for (Patch<D>& patch : *list)
      for (Face<D>& face : patch.faces)
        if (!face.cut) face.share = shares.at(face.nodes);
  particles.B = lumped_areas<D>(particles.size(), faces);
  return particles;
}

#define TLSPH_INSTANTIATE(D)                                                                    \
  template std::vector<std::array<int, D>> monomials<D>(int);                                   \
  template Eigen::VectorXd monomial_values<D>(const std::vector<std::array<int, D>>&,           \
                                              const Vector<D>&);                                \
  template Particles<D> with_exact_moments<D>(Particles<D>, QuadratureDegrees, const Shape<D>*, \
                                              const Place&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
