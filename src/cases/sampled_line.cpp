#include "sampled_line.hpp"

#include <array>
#include <cmath>

#include "tlsph/operators/gradients.hpp"
#include "tlsph/operators/lattice_stencil.hpp"

namespace tlsph {
namespace {

/// (2.19) without its normalisation.
double shape(double q) {
  const double s = 1 - q * q;
  return s > 0 ? std::exp(-1 / s) * std::pow(s, 8) : 0.0;
}

}  // namespace

SampledLine::SampledLine(double from, double to, int intervals, int layers)
    : X(intervals + 1 + 2 * layers, 1),
      V(intervals + 1 + 2 * layers),
      spacing((to - from) / intervals),
      first(layers),
      count(intervals + 1) {
  for (Index q = 0; q < X.rows(); ++q) X(q, 0) = from + static_cast<double>(q - layers) * spacing;
  V.setConstant(spacing);
  if (layers == 0) V[0] = V[V.size() - 1] = 0.5 * spacing;
}

ScalarField SampledLine::sample(const Function& f) const {
  return X.col(0).unaryExpr([&](double x) { return f(x); });
}

LineOperators plain_sums(const AnyKernel& kernel, double support, const SampledLine& line) {
  const double h = support * line.spacing;
  return {kernel_matrix<1>(kernel, h, line.X, line.V),
          plain_gradient<1>(kernel, h, line.X, line.V).matrix(0)};
}

LineOperators normalised_sums(const AnyKernel& kernel, double support, const SampledLine& line) {
  const auto N = static_cast<int>(line.X.rows());
  const LatticeFrame<1> frame{Vector<1>(line.X(0, 0)), Vector<1>(line.spacing), {N}};
  const LatticeStencil<1> stencil = lattice_stencil<1>(kernel, support, frame);
  std::array<std::vector<Eigen::Triplet<double>>, 2> entries;
  for (int p = 0; p < N; ++p)
    for (std::size_t k = 0; k < stencil.offset.size(); ++k) {
      const int q = p + stencil.offset[k][0];
      if (q < 0 || q >= N) continue;
      entries[0].emplace_back(p, q, stencil.value[k]);
      entries[1].emplace_back(p, q, stencil.gradient[k][0]);
    }
  LineOperators result{SparseMatrix(N, N), SparseMatrix(N, N)};
  result.value.setFromTriplets(entries[0].begin(), entries[0].end());
  result.derivative.setFromTriplets(entries[1].begin(), entries[1].end());
  return result;
}

LatticeSums::LatticeSums(double support) : support_(support) {
  // The trapezoidal rule converges faster than any power for a function that is smooth and flat at
  // both ends.
  constexpr int points = 2000;
  double integral = 0.0;
  for (int k = -points; k <= points; ++k) integral += shape(double(k) / points) / points;
  normalisation_ = 1 / (integral * support);
}

double LatticeSums::first(int j) const {
  const double q = j / support_;
  const double s = 1 - q * q;
  return s > 0 ? -2 * q * normalisation_ / support_ * shape(q) * (1 / (s * s) + 8 / s) : 0.0;
}

double LatticeSums::value(double theta) const {
  double sum = normalisation_ * shape(0.0);
  for (int j = 1; j < support_; ++j)
    sum += 2 * normalisation_ * shape(j / support_) * std::cos(j * theta);
  return sum;
}

double LatticeSums::derivative(double theta) const {
  double sum = 0.0;
  for (int j = 1; j < support_; ++j) sum -= 2 * first(j) * std::sin(j * theta);
  return sum / theta;
}

double LatticeSums::slope() const {
  double sum = 0.0;
  for (int j = 1; j < support_; ++j) sum -= 2 * j * first(j);
  return sum;
}

}  // namespace tlsph
