#include "tlsph/stepping/critical_step.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "tlsph/core/error.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/linear/krylov.hpp"
#include "tlsph/operators/products.hpp"
#include "tlsph/stepping/linearised_forces.hpp"

namespace tlsph {
namespace {

/// The linearised equations of motion as maps of plain vectors of N·d entries.
template <int D>
class Linearised {
 public:
  /// `at`: the state and the sweep of its forces, or the sweep alone.
  template <class... At>
  explicit Linearised(const Discretisation<D>& body, const At&... at)
      : body_(body),
        forces_(body, at...),
        x_(VectorField<D>::Zero(body.nodes(), D)),
        y_(x_),
        root_(body.inverse_mass.cwiseSqrt()) {}

  [[nodiscard]] Index size() const { return x_.size(); }

  /// y = M^-½ (k K + c C) M^-½ x.
  void symmetric(double k, double c, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    const double* root = root_.data();
    for_rows(size(),
             [=, from = x.data(), to = x_.data()](Index dof) { to[dof] = root[dof] * from[dof]; });
    forces_.product(x_, y_);
    if (c != 0.0) {
      y_ *= k;
      x_ *= c;
      subtract_differences<D>(body_.viscosity, x_, y_);
      k = 1.0;
    }
    for_rows(size(), [=, from = y_.data(), to = y.data()](Index dof) {
      to[dof] = -(root[dof] * (k * from[dof]));
    });
  }
  /// y = M⁻¹ K x on the free degrees of freedom.
  void general(const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    for (Index k = 0; k < size(); ++k)
      x_.data()[k] = body_.inverse_mass.data()[k] == 0.0 ? 0.0 : x[k];
    forces_.product(x_, y_);
    y = -Eigen::Map<const Eigen::VectorXd>(body_.inverse_mass.data(), size())
             .cwiseProduct(Eigen::Map<const Eigen::VectorXd>(y_.data(), size()));
  }

 private:
  const Discretisation<D>& body_;
  LinearisedForces<D> forces_;
  VectorField<D> x_;
  VectorField<D> y_;
  VectorField<D> root_;
};

template <int D>
double largest(Linearised<D>& linearised, double k, double c, double tolerance) {
  // The Ritz value errs by residual²/gap; the bound θ + residual keeps the step on the safe side.
  return largest_eigenvalue([&](const Eigen::VectorXd& x,
                                Eigen::VectorXd& y) { linearised.symmetric(k, c, x, y); },
                            linearised.size(), {.max_steps = 200, .tolerance = tolerance})
      .upper_bound;
}

/// The eigenvalues of largest modulus of a map of vectors.
std::vector<std::complex<double>> largest_of(const LinearMap& map, Index size) {
  return arnoldi_eigenvalues(map, size, static_cast<int>(std::min<Index>(size, 120)));
}

/// Δt with λ_max(Δt² K + 2Δt C) = 4; the left side grows with an exponent between one and two. No
/// longer than K or C alone allows: if K is not positive, C alone limits the step.
template <int D>
double damped_step(Linearised<D>& linearised, double undamped, double tolerance) {
  double dt = std::min(undamped, 2.0 / largest(linearised, 0.0, 1.0, tolerance));
  double exponent = 1.0;
  double last_dt = 0.0;
  double last_ratio = 0.0;
  for (int k = 0; k < 12; ++k) {
    const double ratio = largest(linearised, dt * dt, 2.0 * dt, tolerance) / 4.0;
    if (ratio < 1.0 + 1e-3 && (k == 0 || ratio > 1.0 - 1e-3)) break;
    if (last_dt > 0.0 && dt != last_dt)
      exponent = std::clamp(std::log(ratio / last_ratio) / std::log(dt / last_dt), 1.0, 2.0);
    last_dt = dt;
    last_ratio = ratio;
    dt *= std::pow(ratio, -1.0 / exponent);
  }
  return dt;
}

template <int D>
std::optional<CriticalStep> estimate(const Discretisation<D>& body, const State<D>& state,
                                     double tolerance, const Sweep<D>* sweep) {
  Linearised<D> linearised(body, state, sweep);
  CriticalStep result;
  if (body.adjoint) {
    const double omega_squared = largest(linearised, 1.0, 0.0, tolerance);
    if (!(omega_squared > 0.0)) return std::nullopt;
    result.dt = 2.0 / std::sqrt(omega_squared);
    if (body.viscosity.nonZeros() > 0) result.dt = damped_step(linearised, result.dt, tolerance);
  } else {
    const auto values =
        largest_of([&](const Eigen::VectorXd& x, Eigen::VectorXd& y) { linearised.general(x, y); },
                   linearised.size());
    double largest_modulus = 0.0;
    double growth = 0.0;
    for (const std::complex<double>& lambda : values) {
      largest_modulus = std::max(largest_modulus, std::abs(lambda));
      growth = std::max(growth, std::abs(std::sqrt(-lambda).real()));
    }
    if (!(largest_modulus > 0.0)) return std::nullopt;
    result.dt = 2.0 / std::sqrt(largest_modulus);
    result.growth = growth;
  }
  result.scaled = result.dt * body.wave_speed() / body.spacing;
  return result;
}

}  // namespace

template <int D>
std::optional<CriticalStep> critical_step_if_any(const Discretisation<D>& body,
                                                 const State<D>& state, double tolerance,
                                                 const Sweep<D>* sweep) {
  try {
    return estimate<D>(body, state, tolerance, sweep);
  } catch (const NumericalError& failure) {
    report_loss<D>(body, state, failure.what());  // the solver knows no time and no particle
  }
}

template <int D>
CriticalStep critical_step(const Discretisation<D>& body, const State<D>& state) {
  if (const auto result = critical_step_if_any<D>(body, state)) return *result;
  report_loss<D>(body, state, "the body has no stiffness, and no critical time step,");
}

template <int D>
double unit_stiffness(const Discretisation<D>& body, const Sweep<D>* sweep) {
  constexpr double tolerance = 5e-2;  // of a factor of what the tangents change
  Linearised<D> linearised(body, sweep);
  if (body.adjoint) return largest(linearised, 1.0, 0.0, tolerance);
  const auto values = largest_of(
      [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) { linearised.symmetric(1.0, 0.0, x, y); },
      linearised.size());
  return std::abs(values.front());
}

#define TLSPH_INSTANTIATE(D)                                                         \
  template std::optional<CriticalStep> critical_step_if_any<D>(                      \
      const Discretisation<D>&, const State<D>&, double, const Sweep<D>*);           \
  template CriticalStep critical_step<D>(const Discretisation<D>&, const State<D>&); \
  template double unit_stiffness<D>(const Discretisation<D>&, const Sweep<D>*);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
