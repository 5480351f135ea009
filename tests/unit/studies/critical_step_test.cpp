/// The critical step of a run, found by a few Krylov steps, against the whole spectrum of M⁻¹K.

#include "tlsph/stepping/critical_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

const std::string bar = R"(dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.02
[material]
law = "linear-elastic"
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "right"
fixed = true
[time]
end = 1.0
)";

const std::string sheet = R"(dimension = 2
[body]
shape = { box = [[0.0, 0.0], [1.0, 0.6]] }
spacing = 0.1
[material]
law = "linear-elastic"
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
fixed = true
[time]
end = 1.0
)";

struct StepCase {
  const char* name;
  std::string scene;
  std::vector<std::string> overrides;
};

void PrintTo(const StepCase& of, std::ostream* out) {
  *out << of.name;
}

/// M⁻¹K of the free degrees of freedom, a column a force: the law is linear, so −f(e)/m is the
/// column.
template <int D>
SparseMatrix dynamic_matrix(const Discretisation<D>& body, State<D>& state) {
  std::vector<Index> free;
  for (Index dof = 0; dof < state.u.size(); ++dof)
    if (body.inverse_mass.data()[dof] > 0.0) free.push_back(dof);
  const auto n = static_cast<Index>(free.size());
  Eigen::MatrixXd dense(n, n);
  constexpr double size = 1e-3;  // keeps det F positive; the answer does not depend on it
  for (Index column = 0; column < n; ++column) {
    state.u.setZero();
    state.u.data()[free[static_cast<std::size_t>(column)]] = size * body.spacing;
    evaluate<D>(body, state);
    for (Index row = 0; row < n; ++row) {
      const Index dof = free[static_cast<std::size_t>(row)];
      dense(row, column) =
          -body.inverse_mass.data()[dof] * state.f.data()[dof] / (size * body.spacing);
    }
  }
  state.u.setZero();
  evaluate<D>(body, state);
  return dense.sparseView();
}

template <int D>
void compare(const StepCase& of) {
  const Scene scene = read_scene_text(of.scene, "scene.toml", of.overrides);
  const Discretisation<D> body = build<D>(scene);
  InitialState<D> initial = build_initial<D>(scene, body);
  State<D> state =
      make_state<D>(body, std::move(initial.displacement), std::move(initial.velocity));

  const auto spectrum = eigenvalues(dynamic_matrix<D>(body, state));
  const CriticalStep found = critical_step<D>(body, state);

  const double dt = 2.0 / std::sqrt(std::abs(spectrum.front()));
  EXPECT_LE(found.dt, dt * (1.0 + 1e-9)) << "beyond the limit of stability";
  EXPECT_GE(found.dt, dt * 0.995) << "wastes steps";
  EXPECT_NEAR(found.scaled, found.dt * body.wave_speed() / body.spacing, 1e-12 * found.scaled);
  EXPECT_EQ(found.growth.has_value(), !body.adjoint);
  if (body.adjoint) {
    for (const std::complex<double>& value : spectrum) {
      EXPECT_GT(value.real(), -1e-9 * std::abs(spectrum.front()));
      EXPECT_LT(std::abs(value.imag()), 1e-6 * std::abs(spectrum.front()));
    }
  } else {
    double growth = 0.0;
    for (const std::complex<double>& value : spectrum)
      growth = std::max(growth, std::abs(std::sqrt(-value).real()));
    EXPECT_NEAR(*found.growth, growth, 1e-3 * growth + 1e-5 / dt);
  }
}

class CriticalStepOf : public testing::TestWithParam<StepCase> {};

TEST_P(CriticalStepOf, IsThatOfTheWholeSpectrum) {
  GetParam().scene == bar ? compare<1>(GetParam()) : compare<2>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Formulations, CriticalStepOf,
    testing::Values(
        StepCase{"BarStressPoint", bar, {"formulation=stress-point"}},
        StepCase{"BarMirror", bar, {"formulation=mirror"}},
        StepCase{"BarMirrorWide", bar, {"formulation=mirror", "kernel.support=5.5"}},
        StepCase{"BarVariational", bar, {"formulation=variational"}},
        StepCase{"BarThesis", bar, {"formulation=thesis"}},
        StepCase{"BarThesisWide", bar, {"formulation=thesis", "kernel.support=5.5"}},
        StepCase{"SheetStressPoint", sheet, {"formulation=stress-point"}},
        StepCase{"SheetNoStabiliser", sheet, {"formulation=stress-point", "stabiliser.kind=none"}},
        StepCase{"SheetVariational", sheet, {"formulation=variational", "body.jitter=0.1"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace tlsph
