#include "advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tlsph/core/dimensions.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/observe/quantity.hpp"
#include "tlsph/scene/edit.hpp"
#include "tlsph/simulation/reduction.hpp"
#include "tlsph/stepping/critical_step.hpp"

namespace tlsph {
namespace {

/// Particles of the smaller scene, of a formulation all scenes have; 0 if it is none after all.
Index particles_of(const Reduction& reduction) {
  const Scene standard;
  Scene smaller = reduction.scene;
  smaller.formulation = standard.formulation;
  smaller.kernel = {};
  smaller.stabiliser = {};
  smaller.consistency = standard.consistency;
  smaller.body.placement = standard.body.placement;
  try {
    smaller = completed(smaller);
    return in_dimension(smaller.dimension,
                        [&]<int D>() { return build_particles<D>(smaller).size(); });
  } catch (const InputError&) {
    return 0;
  }
}

std::string line(const Reduction& reduction, Index particles) {
  const Index fewer = particles_of(reduction);
  if (fewer == 0 || fewer >= particles) return "";
  return fmt::format("  {}; {} particles in place of {}\n", reduction.what, fewer, particles);
}

}  // namespace

std::string advise_reduction(const Scene& scene, Index particles) {
  if (const auto bar = to_one_dimension(scene)) return line(*bar, particles);
  std::string text;
  for (const int axis : {0, 1})
    if (const auto half = to_half(scene, axis)) text += line(*half, particles);
  return text;
}

namespace {

/// About what a step takes for each entry of a row of G, and a frame for its files and its bytes.
constexpr double seconds_per_entry = 2.5e-9, seconds_per_frame = 1e-3, seconds_per_byte = 2.5e-9;
/// Frames may take this share of the time of the steps; stress may take this share of their bytes.
constexpr double time_share = 0.25, stress_share = 0.25;
/// Less is not worth a word: bytes of stress, seconds of writing.
constexpr double worth = 1e5, worth_seconds = 0.2;

bool is_stress(const std::string& quantity) {
  return quantity_named<2>(quantity).unit == "Pa";
}

template <int D>
double bytes_of(const std::string& name, const Discretisation<D>& body) {
  const Quantity<D>& quantity = quantity_named<D>(name);
  const Index rows = quantity.site == Site::particles ? body.nodes() : body.points.size();
  return 8.0 * static_cast<double>(component_count(quantity.rank, D)) * static_cast<double>(rows);
}

bool is_read(const Scene& scene) {
  return scene.exact != ExactKind::none ||
         std::ranges::any_of(scene.probes, [](const ProbeScene& probe) {
           return std::ranges::any_of(probe.record, is_stress);
         });
}

}  // namespace

template <int D>
double frame_bytes(const Scene& scene, const Discretisation<D>& body) {
  double frame = 0.0;
  for (const std::string& field : scene.output.fields) frame += bytes_of<D>(field, body);
  return frame;
}

template <int D>
std::string advise_output(const Scene& scene, const Discretisation<D>& body, double steps) {
  if (scene.output.frames == 0) return "";
  const double frame = frame_bytes<D>(scene, body);
  double stress = 0.0;
  std::vector<std::string> others;
  for (const std::string& field : scene.output.fields) {
    const double bytes = bytes_of<D>(field, body);
    if (is_stress(field))
      stress += bytes;
    else
      others.push_back(fmt::format("\"{}\"", field));
  }
  const double frames = scene.output.frames + 1.0;
  std::string text;
  const Index entries =
      body.ghosts ? body.ghosts->plain_gradient().nonzeros() : body.gradient.nonzeros();
  const double stepping = steps * static_cast<double>(entries) * seconds_per_entry;
  const double writing = frames * (seconds_per_frame + frame * seconds_per_byte);
  if (steps > 0.0 && writing > worth_seconds && writing > time_share * stepping)
    text += fmt::format(
        "  {} frames, {:.2g} MB, take about {:.2g} s beside {:.2g} s of steps: fewer by "
        "output.frames\n",
        frames, frames * frame * 1e-6, writing, stepping);
  if (!is_read(scene) && stress > stress_share * frame && frames * stress > worth)
    text += fmt::format(
        "  stress in every frame, {:.2g} of {:.2g} MB, and no probe or exact solution asks for it: "
        "output.fields = [{}] without\n",
        frames * stress * 1e-6, frames * frame * 1e-6, fmt::join(others, ", "));
  return text;
}

template double frame_bytes<1>(const Scene&, const Discretisation<1>&);
template double frame_bytes<2>(const Scene&, const Discretisation<2>&);
template std::string advise_output<1>(const Scene&, const Discretisation<1>&, double);
template std::string advise_output<2>(const Scene&, const Discretisation<2>&, double);

namespace {

/// A saving below this share of the time is not worth a word.
constexpr double worth_share = 0.9;
/// Points beyond which a second set of operators is not built for the sake of a word.
constexpr Index many = 200000;

template <int D>
double entries_per_row(const Discretisation<D>& body) {
  const VectorOperator<D>& G = body.ghosts ? body.ghosts->plain_gradient() : body.gradient;
  return static_cast<double>(G.nonzeros()) / static_cast<double>(G.rows());
}

}  // namespace

template <int D>
std::string advise_support(const Scene& scene, const Discretisation<D>& body, double dt) {
  if (!scene.kernel.support || body.nodes() > many || !(dt > 0.0)) return "";
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
    const double before = entries_per_row(body);
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

template std::string advise_support<1>(const Scene&, const Discretisation<1>&, double);
template std::string advise_support<2>(const Scene&, const Discretisation<2>&, double);

}  // namespace tlsph
