// Own law, own load, own observer: a sine wave along a viscoelastic bar, from outside the library.
//
//     P = E_inf H + E (H - H_v),  dH_v/dt = (H - H_v)/tau      a spring beside Maxwell's spring and
//     damper
//
//     p(t) = A sin wt -> |o---o---o---x---o--- ... ---y---o---o|     a bar of 1 m, free at its
//     right end
//                                    0.1 m           0.2 m           observed: P at the points x
//                                    and y
//
// A wave e^i(wt - kX) has k = w sqrt(rho/E*), E* = E_inf + E i w tau/(1 + i w tau): it decays by
// e^(Im k 0.1 m) from x to y. Expected: 0.3475, here right to 5e-4. Returns 0 if that holds.

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/particles/points.hpp"
#include "tlsph/stepping/stepper.hpp"

using namespace tlsph;

// 1. The law: one text for all number types R, so that its tangent needs no line of its own
//    (tlsph/materials/law.hpp). A point remembers H, e = H - H_v and the energy that the damper
//    took.
struct Viscoelastic {
  static constexpr int dimension = 1;
  static constexpr std::string_view name = "viscoelastic";
  static constexpr bool small_strain = true;
  static constexpr int memory = 3;
  double slow, fast, tau;  // E_inf [Pa], E [Pa], tau [s]

  // Exact for a strain rate that is constant since the past.
  template <class R>
  TensorOf<1, R> stress(const TensorOf<1, R>& H, const Past& past, R* now, Mask<R>& good) const {
    const double share = std::exp(-past.dt / tau);
    const double memory_of_rate = past.dt > 0.0 ? tau * (1.0 - share) / past.dt : 1.0;
    now[0] = H(0, 0);
    now[1] = share * past.memory[1] + memory_of_rate * (H(0, 0) - past.memory[0]);
    const R middle = 0.5 * (now[1] + past.memory[1]);
    now[2] = past.memory[2] + past.dt / tau * fast * middle * middle;
    good &= now[1] < huge;
    return {{{slow * H(0, 0) + fast * now[1]}}};
  }
  double energy(const TensorOf<1, double>& H, const double* now) const {
    return 0.5 * (slow * H(0, 0) * H(0, 0) + fast * now[1] * now[1]);
  }
  double dissipated(const double* now) const { return now[2]; }
  double transverse_stretch(const TensorOf<1, double>&) const { return 1.0; }
  double transverse_stress(const TensorOf<1, double>&) const { return 0.0; }
  double margin(const TensorOf<1, double>&) const { return 1.0; }
};

// 2. The observer: anything that is called with an instant, here at every step. It collects the
//    Fourier integral of a point's stress over the last of eight periods.
struct Amplitude {
  Index point;
  double omega, from;
  std::complex<double> sum = 0.0;

  void operator()(const Instant<1>& now) {
    if (now.time() > from) sum += now.P()(point, 0) * std::polar(1.0, -omega * now.time());
  }
};

int main() {
  const Viscoelastic law{.slow = 2e6, .fast = 3e6, .tau = 3e-4};
  const double density = 1000.0, period = 2e-3, omega = 2 * std::numbers::pi / period;

  // 3. A bar of stress points, as in library_use.cpp, with that law behind a pointer.
  Discretisation<1> bar;
  bar.particles = make_lattice<1>(make_interval(0.0, 1.0), 2.5e-3);
  bar.points = cell_points(bar.particles);
  bar.spacing = bar.particles.spacing;
  bar.gradient = cell_gradient(bar.particles, bar.points);
  bar.divergence = bar.gradient.negative_adjoint(bar.points.V);
  bar.regions = {{GivenLaw<1, true>(Law<Viscoelastic>(law)), density, {}}};
  bar.mass = density * bar.particles.V;
  bar.inverse_mass = bar.mass.cwiseInverse();

  // 4. The load: any function of time; the amplitude grows to 1 kPa within two periods or so.
  const auto pressure = [=](double t) {
    return 1e3 * (1.0 - std::exp(-std::pow(t / period, 2))) * std::sin(omega * t);
  };
  bar.loads = {normal_traction<1>(*bar.particles.find("left"), GivenCurve{pressure})};

  // 5. Steps, a whole number of them a period, through eight periods.
  const VectorField<1> rest = VectorField<1>::Zero(bar.nodes(), 1);
  const double limit = Stepper<1>(bar, rest, rest).critical().dt;
  const double dt = period / std::ceil(period / (0.9 * limit));
  Stepper<1> stepper(bar, rest, rest, {.end = 8 * period, .step = dt});
  Amplitude near{40, omega, 7.001 * period}, far{80, omega, 7.001 * period};
  stepper.run([&](const Instant<1>& now) {
    near(now);
    far(now);
  });

  // 6. The decay between the two, and the exact one.
  using namespace std::complex_literals;
  const std::complex<double> modulus =
      law.slow + law.fast * (1i * omega * law.tau) / (1.0 + 1i * omega * law.tau);
  const std::complex<double> k = omega * std::sqrt(density / modulus);
  const double distance = bar.points.X(far.point, 0) - bar.points.X(near.point, 0);
  const double exact = std::exp(k.imag() * distance);
  const double decay = std::abs(far.sum / near.sum);
  fmt::print("decay over {} m: {:.5f}, exact {:.5f}, relative error {:.1e}\n", distance, decay,
             exact, std::abs(decay / exact - 1));
  return std::abs(decay / exact - 1) < 5e-4 && std::abs(exact - 0.3475) < 1e-4 ? 0 : 1;
}
