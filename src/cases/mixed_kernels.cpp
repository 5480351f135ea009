// One kernel for strains, another for stresses, and the mixed Hu-Washizu form.
#include "mixed_kernels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "list.hpp"
#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/operators/products.hpp"
#include "tlsph/stepping/stepper.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace mixed {
namespace {

/// Largest growth rate of a motion e^{st}, s² = −ω² [1/s].
double growth(const Discretisation<2>& disc) {
  double rate = 0.0;
  for (const auto& square : eigenvalues(dynamical_matrix<2>(disc)))
    rate = std::max(rate, std::abs(std::sqrt(square).imag()));
  return rate;
}

/// The strong form of Hu and Washizu, (8.61): W_ij V_j α_j = D_i is solved for α, and the field is
/// interpolated from α again. K = W V⁻¹ is symmetric, and g = V α its unknown.
class MixedForm {
 public:
  MixedForm(const AnyKernel& kernel, double h, const VectorField<2>& X)
      : K_(kernel_matrix<2>(kernel, h, X, ScalarField::Ones(X.rows()))), factor_(K_) {}

  [[nodiscard]] TensorField<2> pass(const TensorField<2>& field) const {
    const Eigen::MatrixXd g = factor_.solve(Eigen::MatrixXd(field));
    return K_ * g;
  }
  [[nodiscard]] const SymmetricOrGeneral& factor() const { return factor_; }

 private:
  SparseMatrix K_;
  SymmetricOrGeneral factor_;
};

/// `evaluate`, with strain and stress passed through the mixed form.
void evaluate_mixed(const Discretisation<2>& disc, const MixedForm& form, State<2>& state) {
  evaluate<2>(disc, state);
  state.H = form.pass(state.H);
  std::visit(
      [&](const auto& law) {
        for (Index s = 0; s < state.H.rows(); ++s) {
          const Tensor<2> P = law.pk1(tensor_at<2>(state.H, s));
          Eigen::Map<Tensor<2>>(state.P.row(s).data()) = P;
        }
      },
      disc.regions.front().law);
  state.P = form.pass(state.P);
  disc.divergence.divergence(state.P, state.f);
}

}  // namespace

void reference_pairs(CaseRun& run) {
  const auto base = build<2>(run.read("free_sheet.toml"));
  const double h = support * base.spacing;
  const double unit = base.spacing / base.wave_speed();
  std::vector<VectorOperator<2>> G;
  for (const auto family : families)
    G.push_back(collocated_gradient<2>(kernel(family), h, base.particles.X, base.particles.V,
                                       Correction::gradient));
  std::vector<std::vector<double>> rates(families.size());
  for (std::size_t strain = 0; strain < families.size(); ++strain)
    for (std::size_t stress = 0; stress < families.size(); ++stress) {
      Discretisation<2> disc = base;
      disc.gradient = G[strain];
      disc.divergence = G[stress].negative_adjoint(disc.points.V);
      disc.adjoint = strain == stress;
      const double rate = growth(disc) * unit;
      rates[stress].push_back(rate);
      const auto quantity =
          fmt::format("growth at rest in the reference configuration, strain {}, stress {} [c/Δ]",
                      families[strain], families[stress]);
      if (strain == stress)
        run.at_most("Cranfield thesis, sec. 4.2", quantity, 1e-6, rate);
      else
        run.at_least("Cranfield thesis, sec. 4.2", quantity, 1e-4, rate);
    }
  run.table("pairs", {families.begin(), families.end()}, rates);
}

void reinterpolated(CaseRun& run) {
  const Scene scene = run.read("sheet.toml");
  const auto disc = build<2>(scene);
  const MixedForm form(kernel(scene.kernel.family), support * disc.spacing, disc.particles.X);
  const auto initial = build_initial<2>(scene, disc);
  Stepper<2> basic(disc, initial.displacement, initial.velocity,
                   {.safety = 0.8, .adaptive = false, .sweep = false, .balance_every = 0});
  const double dt = 0.8 * basic.critical().dt;
  Stepper<2> passed(disc, initial.displacement, initial.velocity,
                    {.step = dt,
                     .balance_every = 0,
                     .evaluate = [&form](const Discretisation<2>& body, State<2>& state) {
                       evaluate_mixed(body, form, state);
                     }});
  std::vector<std::vector<double>> columns(3);
  double displacement = 0.0;
  double stress = 0.0;
  const auto steps = static_cast<long>(scene.time.end / dt);
  for (long n = 0; n < steps; ++n) {
    for (Stepper<2>* stepper : {&basic, &passed}) {
      stepper->step();
      stepper->evaluate();
    }
    const auto difference = [](const auto& a, const auto& b) {
      return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
    };
    columns[0].push_back(basic.state().time);
    columns[1].push_back(difference(passed.state().u, basic.state().u));
    columns[2].push_back(difference(passed.state().P, basic.state().P));
    displacement = std::max(displacement, columns[1].back());
    stress = std::max(stress, columns[2].back());
  }
  const std::string source = "Cranfield thesis, Fig. 8-4";
  run.at_most(source, "displacement of the re-interpolated run, relative difference", 1e-9,
              displacement);
  run.at_most(source, "stress of the re-interpolated run, relative difference", 1e-9, stress);
  run.absolute(source, "W V⁻¹ of the cubic spline is factorised by Cholesky (1: yes)", 1.0,
               form.factor().chosen() == SolverChoice::cholmod ? 1.0 : 0.0, 0.0);
  run.report(source, "condition of W V⁻¹, an estimate from below",
             form.factor().condition_estimate());
  run.table("reinterpolated", {"time", "displacement", "stress"}, columns);
}

}  // namespace mixed

void mixed_kernels(CaseRun& run) {
  mixed::tension(run);
  mixed::reference_pairs(run);
  mixed::reinterpolated(run);
}

}  // namespace tlsph
