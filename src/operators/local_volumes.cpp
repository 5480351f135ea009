#include "tlsph/operators/local_volumes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "support.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/operators/neighbours.hpp"
#include "tlsph/particles/boundary_runs.hpp"

namespace tlsph {
namespace {

/// Least and largest volumes that are tried in turn, as shares of what lies nearest to a node.
constexpr std::array shares = {std::pair{0.44, 1.4}, std::pair{0.3, 2.0}, std::pair{0.2, 3.0},
                               std::pair{0.1, 10.0}};
constexpr double rounding = 1e-9;
constexpr double gauss = 0.57735026918962576;

/// A point of the quadrature.
template <int D>
struct RulePoint {
  Vector<D> X;
  double weight = 0.0;
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
      if constexpr (D == 1) {
        point.weight = 0.5 * (particles.X(cell[1], 0) - particles.X(cell[0], 0));
        point.X[0] =
            0.5 * (1 - s) * particles.X(cell[0], 0) + 0.5 * (1 + s) * particles.X(cell[1], 0);
      } else {
        const double t = g < 2 ? -gauss : gauss;
        constexpr std::array<double, 4> sign_s = {-1, 1, 1, -1}, sign_t = {-1, -1, 1, 1};
        Vector<2> along_s = Vector<2>::Zero(), along_t = Vector<2>::Zero();
        point.X.setZero();
        for (std::size_t c = 0; c < 4; ++c) {
          const Vector<2> corner = particles.X.row(cell[c]).transpose();
          point.X += 0.25 * (1 + sign_s[c] * s) * (1 + sign_t[c] * t) * corner;
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
      rule.push_back(point);
    }
}

/// w φ_q(X_g) of one point of the quadrature: the q that make Σ φ_q²/k_q least among those with
/// Σ φ_q p(X_q) = p(X_g) for quadratic p, so φ_q = k_q p_q·c.
template <int D>
class Fit {
  using Polynomial = typename Support<D>::Polynomial;

 public:
  Fit(const RulePoint<D>& point, std::span<const int> near, const VectorField<D>& X, double h)
      : weight_(point.weight), support_(kernel, h, point.X, near, X) {
    values_ = support_.quadratics(h);
    moment_.compute(values_ * support_.value.asDiagonal() * values_.transpose());
  }

  void add_to(ScalarField& V) const { add(weight_ * moment_.solve(Polynomial::Unit(0)), V); }
  /// What a term −μ φ_q in the sum above changes, for μ = 1: w (k_q δ_qr − k_q p_q·M⁻¹ p_r k_r).
  void add_response(int q, Eigen::SparseVector<double>& V) const {
    const Index r = std::ranges::lower_bound(support_.nodes, q) - support_.nodes.begin();
    V.coeffRef(q) += weight_ * support_.value[r];
    add(-weight_ * support_.value[r] * moment_.solve(values_.col(r)), V);
  }

 private:
  template <class Vector>
  void add(const Polynomial& c, Vector& V) const {
    for (Index k = 0; k < support_.size(); ++k)
      V.coeffRef(support_.nodes[static_cast<std::size_t>(k)]) +=
          support_.value[k] * c.dot(values_.col(k));
  }
  static inline const AnyKernel kernel = WendlandC2{};
  double weight_;
  Support<D> support_;
  Eigen::Matrix<double, Support<D>::terms, Eigen::Dynamic> values_;
  Eigen::LDLT<typename Support<D>::Moment> moment_;
};

/// V + Σ_r μ_r R_r that lies between the bounds, μ > 0 where it is at the lower one, μ < 0 at the
/// upper one and 0 between: the least change of the fits that does. R_r = `response(r)`. Empty
/// where no such change is found.
template <class Response>
std::optional<ScalarField> bounded(const ScalarField& V, const ScalarField& lower,
                                   const ScalarField& upper, const Response& response) {
  constexpr int most_rounds = 40;
  std::map<int, Eigen::SparseVector<double>> responses;
  std::map<int, double> held;  // where it is held
  ScalarField now = V;
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t before = held.size();
    for (int q = 0; q < static_cast<int>(V.size()); ++q) {
      if (now[q] < (1.0 - rounding) * lower[q])
        held.emplace(q, lower[q]);
      else if (now[q] > (1.0 + rounding) * upper[q])
        held.emplace(q, upper[q]);
    }
    if (held.size() == before) return now;
    for (bool all_pull = false; !all_pull;) {
      const std::vector<std::pair<int, double>> list(held.begin(), held.end());
      const auto count = static_cast<Index>(list.size());
      const auto position = [&](int q) {
        return std::ranges::lower_bound(list, q, {}, &std::pair<int, double>::first) - list.begin();
      };
      std::vector<Eigen::Triplet<double>> entries;
      Eigen::VectorXd lack(count);
      for (Index i = 0; i < count; ++i) {
        const auto& [q, bound] = list[static_cast<std::size_t>(i)];
        if (!responses.contains(q)) responses[q] = response(q);
        lack[i] = bound - V[q];
        for (Eigen::SparseVector<double>::InnerIterator entry(responses[q]); entry; ++entry)
          if (held.contains(static_cast<int>(entry.index())))
            entries.emplace_back(position(static_cast<int>(entry.index())), i, entry.value());
      }
      SparseMatrix H(count, count);
      H.setFromTriplets(entries.begin(), entries.end());
      const auto factor = Cholesky::attempt(H);
      if (!factor) return std::nullopt;
      const Eigen::VectorXd mu = factor->solve(lack);
      now = V;
      all_pull = true;
      for (Index i = 0; i < count; ++i) {
        const auto& [q, bound] = list[static_cast<std::size_t>(i)];
        now += mu[i] * responses[q];
        if (mu[i] * (bound == lower[q] ? 1.0 : -1.0) > 0.0) continue;
        held.erase(q);
        all_pull = false;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

template <int D>
ScalarField local_volumes(const Particles<D>& particles) {
  std::vector<RulePoint<D>> rule = over_cells<D>(particles);
  if constexpr (D == 2) add_triangles(particles, rule);
  if (rule.empty()) return particles.V;
  if constexpr (D == 2) add_segments(particles, rule);
  VectorField<D> at(static_cast<Index>(rule.size()), D);
  for (std::size_t g = 0; g < rule.size(); ++g)
    at.row(static_cast<Index>(g)) = rule[g].X.transpose();
  const double h = volume_support * particles.spacing;
  const Neighbours near = find_neighbours<D>(at, particles.X, h);
  const auto fit = [&](std::size_t g) {
    return Fit<D>(rule[g], near.of(static_cast<Index>(g)), particles.X, h);
  };
  ScalarField V = ScalarField::Zero(particles.size());
  for (std::size_t g = 0; g < rule.size(); ++g) fit(g).add_to(V);
  if (!V.allFinite()) return particles.V;
  const Neighbours reached = find_neighbours<D>(particles.X, at, h);
  const auto response = [&](int q) -> Eigen::SparseVector<double> {
    Eigen::SparseVector<double> R(particles.size());
    for (const int g : reached.of(q)) fit(static_cast<std::size_t>(g)).add_response(q, R);
    return R;
  };
  for (const auto& [least, largest] : shares)
    if (const auto volumes = bounded(V, least * particles.V, largest * particles.V, response))
      return *volumes;
  return particles.V;
}

#define TLSPH_INSTANTIATE(D) template ScalarField local_volumes<D>(const Particles<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph
