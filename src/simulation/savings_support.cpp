#include <fmt/format.h>

#include "savings.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/edit.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/stepping/critical_step.hpp"

namespace tlsph::savings {
namespace {

/// A saving below this share of the time is not worth a word.
constexpr double worth_share = 0.9;
/// Points beyond which a second set of operators is not built for the sake of a word.
constexpr Index many = 200000;

template <int D>
double entries_per_row(const Discretisation<D>& disc) {
  const VectorOperator<D>& G = disc.ghosts ? disc.ghosts->plain_gradient() : disc.gradient;
  return static_cast<double>(G.nonzeros()) / static_cast<double>(G.rows());
}

}  // namespace

template <int D>
std::string of_support(const Scene& scene, const Discretisation<D>& disc, double dt) {
  if (!scene.kernel.support || disc.nodes() > many || !(dt > 0.0)) return "";
  // The default of a formulation is what its order needs.
  const Scene standard;
  Scene needed = scene;
  needed.kernel.support = standard.kernel.support;
  if (scene.formulation == Formulation::stress_point && !scene.body.is_cloud()) {
    needed.kernel = {};
    needed.stabiliser = {};
    needed.consistency = standard.consistency;
  }
  try {
    needed = completed(needed);
    if (needed.kernel.support && *needed.kernel.support >= *scene.kernel.support) return "";
    const Discretisation<D> smaller = build<D>(needed);
    InitialState<D> initial = build_initial<D>(needed, smaller);
    State<D> state =
        make_state<D>(smaller, std::move(initial.displacement), std::move(initial.velocity));
    evaluate<D>(smaller, state);
    const double before = entries_per_row(disc);
    const double after = entries_per_row(smaller);
    const double share = after / before * dt / critical_step<D>(smaller, state).dt;
    if (share > worth_share) return "";
    const std::string name = needed.kernel.support
                                 ? fmt::format("support {}", *needed.kernel.support)
                                 : std::string("the nodes of each cell (no kernel.support)");
    return fmt::format(
        "  support {} with {:.3g} entries a row of G: {} would do with {:.3g}, at about {:.2g} of "
        "the work of a run\n",
        *scene.kernel.support, before, name, after, share);
  } catch (const InputError&) {
    return "";
  }
}

template std::string of_support<1>(const Scene&, const Discretisation<1>&, double);
template std::string of_support<2>(const Scene&, const Discretisation<2>&, double);

}  // namespace tlsph::savings
