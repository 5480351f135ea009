#include "tlsph/operators/local_volumes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

#include "tlsph/kernels/families.hpp"
#include "tlsph/kernels/kernel.hpp"
#include "tlsph/operators/neighbours.hpp"
#include "tlsph/particles/boundary_runs.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {
namespace {

constexpr int degree = 2;
constexpr double least_share = 0.05;  // of a node's share of the cells around it
constexpr double gauss = 0.57735026918962576;

/// A point of the quadrature with the nodes whose linear interpolation stands in for the fit.
template <int D>
struct RulePoint {
  Vector<D> X;
  double weight = 0.0;
  Cell<D> node{};
  std::array<double, (1 << D)> linear{};
};

/// Two Gauss points a direction: exact for quadratics on any cell with straight edges.
template <int D>
std::vector<RulePoint<D>> over_cells(const Particles<D>& particles) {
  std::vector<RulePoint<D>> rule;
  rule.reserve(particles.cells.size() << D);
  for (const Cell<D>& cell : particles.cells)
    for (int g = 0; g < (1 << D); ++g) {
      const double s = g % 2 == 0 ? -gauss : gauss;
      RulePoint<D> point;
      point.node = cell;
      if constexpr (D == 1) {
        point.linear = {0.5 * (1 - s), 0.5 * (1 + s)};
        point.weight = 0.5 * (particles.X(cell[1], 0) - particles.X(cell[0], 0));
        point.X[0] =
            point.linear[0] * particles.X(cell[0], 0) + point.linear[1] * particles.X(cell[1], 0);
      } else {
        const double t = g < 2 ? -gauss : gauss;
        constexpr std::array<double, 4> sign_s = {-1, 1, 1, -1}, sign_t = {-1, -1, 1, 1};
        Vector<2> along_s = Vector<2>::Zero(), along_t = Vector<2>::Zero();
        point.X.setZero();
        for (std::size_t c = 0; c < 4; ++c) {
          const Vector<2> corner = particles.X.row(cell[c]).transpose();
          point.linear[c] = 0.25 * (1 + sign_s[c] * s) * (1 + sign_t[c] * t);
          point.X += point.linear[c] * corner;
          along_s += 0.25 * sign_s[c] * (1 + sign_t[c] * t) * corner;
          along_t += 0.25 * sign_t[c] * (1 + sign_s[c] * s) * corner;
        }
        point.weight = along_s.x() * along_t.y() - along_s.y() * along_t.x();
      }
      rule.push_back(point);
    }
  return rule;
}

/// Triangles of a cloud, by the middles of their edges: exact for quadratics.
void add_triangles(const Particles<2>& particles, std::vector<RulePoint<2>>& rule) {
  for (const Triangle& triangle : particles.triangles) {
    const auto corner = [&](std::size_t c) -> Vector<2> {
      return particles.X.row(triangle[c % 3]).transpose();
    };
    const Vector<2> u = corner(1) - corner(0);
    const Vector<2> v = corner(2) - corner(0);
    const double area = 0.5 * (u.x() * v.y() - u.y() * v.x());
    for (std::size_t c = 0; c < 3; ++c) {
      RulePoint<2> point;
      point.X = 0.5 * (corner(c) + corner(c + 1));
      point.weight = area / 3;
      point.node = {triangle[c], triangle[(c + 1) % 3], triangle[c], triangle[(c + 1) % 3]};
      point.linear = {0.25, 0.25, 0.25, 0.25};
      rule.push_back(point);
    }
  }
}

/// Between chords and arcs: ℓ²φ/6 (1 + 2φ²/15) at two fifths of the rise, half a turn φ a chord.
void add_segments(const Particles<2>& particles, std::vector<RulePoint<2>>& rule) {
  const Patch<2>* boundary = particles.find("boundary");
  if (boundary == nullptr) return;
  for (const BoundaryRun& run : boundary_runs(particles.X, boundary->faces))
    for (std::size_t k = 0; k < run.face.size(); ++k) {
      const double phi = run.half_turn[k];
      if (phi == 0.0) continue;
      const int a = run.node[run.at(k, 0)];
      const int b = run.node[run.at(k, 1)];
      const Vector<2> middle = 0.5 * (particles.X.row(a) + particles.X.row(b)).transpose();
      const Face<2>& face = boundary->faces[run.face[k]];
      const double length = run.chord[k];
      RulePoint<2> point;
      point.X = middle + 0.1 * length * phi * face.area.normalized();
      point.weight = length * length * phi / 6 * (1 + 2 * phi * phi / 15);
      point.node = {a, b, a, b};
      point.linear = {0.25, 0.25, 0.25, 0.25};
      rule.push_back(point);
    }
}

/// Adds weight·φ_q(X_g) for the nodes q around the point.
template <int D>
void add_fit(const RulePoint<D>& point, const int* near, Index count, const VectorField<D>& X,
             double h, ScalarField& V) {
  static const auto exponents = monomials<D>(degree);
  const auto terms = static_cast<Index>(exponents.size());
  Eigen::MatrixXd values(terms, count);
  Eigen::VectorXd kernel(count);
  for (Index k = 0; k < count; ++k) {
    const Vector<D> arm = X.row(near[k]).transpose() - point.X;
    kernel[k] = kernel_value<D>(WendlandC2{}, arm.norm(), h);
    values.col(k) = monomial_values<D>(exponents, Vector<D>(arm / h));
  }
  const Eigen::MatrixXd moment = values * kernel.asDiagonal() * values.transpose();
  const Eigen::VectorXd c = moment.ldlt().solve(Eigen::VectorXd::Unit(terms, 0));
  for (Index k = 0; k < count; ++k) V[near[k]] += point.weight * kernel[k] * c.dot(values.col(k));
}

}  // namespace

template <int D>
ScalarField local_volumes(const Particles<D>& particles) {
  std::vector<RulePoint<D>> rule = over_cells<D>(particles);
  if constexpr (D == 2) add_triangles(particles, rule);
  if (rule.empty()) return particles.V;
  if constexpr (D == 2) add_segments(particles, rule);
  VectorField<D> at(static_cast<Index>(rule.size()), D);
  ScalarField linear = ScalarField::Zero(particles.size());
  for (std::size_t g = 0; g < rule.size(); ++g) {
    at.row(static_cast<Index>(g)) = rule[g].X.transpose();
    for (std::size_t c = 0; c < rule[g].node.size(); ++c)
      linear[rule[g].node[c]] += rule[g].weight * rule[g].linear[c];
  }
  const double h = volume_support * particles.spacing;
  const Neighbours near = find_neighbours<D>(at, particles.X, h);
  std::vector<char> plain(rule.size(), 0);
  for (bool changed = true; changed;) {
    ScalarField V = ScalarField::Zero(particles.size());
    for (std::size_t g = 0; g < rule.size(); ++g) {
      if (plain[g] == 0)
        add_fit<D>(rule[g], near.column.data() + near.start[g], near.start[g + 1] - near.start[g],
                   particles.X, h, V);
      else
        for (std::size_t c = 0; c < rule[g].node.size(); ++c)
          V[rule[g].node[c]] += rule[g].weight * rule[g].linear[c];
    }
    changed = false;
    for (std::size_t g = 0; g < rule.size(); ++g)
      for (Index k = near.start[g]; plain[g] == 0 && k < near.start[g + 1]; ++k) {
        const int q = near.column[static_cast<std::size_t>(k)];
        if (V[q] >= least_share * linear[q]) continue;
        plain[g] = 1;
        changed = true;
      }
    if (!changed) return V;
  }
  return linear;
}

template ScalarField local_volumes<1>(const Particles<1>&);
template ScalarField local_volumes<2>(const Particles<2>&);

}  // namespace tlsph
