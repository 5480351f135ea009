#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "savings.hpp"
#include "tlsph/observe/quantity.hpp"

namespace tlsph::savings {
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
double bytes_of(const std::string& name, const Discretisation<D>& disc) {
  const Quantity<D>& quantity = quantity_named<D>(name);
  const Index rows = quantity.site == Site::particles ? disc.nodes() : disc.points.size();
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
double frame_bytes(const Scene& scene, const Discretisation<D>& disc) {
  double frame = 0.0;
  for (const std::string& field : scene.output.fields) frame += bytes_of<D>(field, disc);
  return frame;
}

template <int D>
std::string of_output(const Scene& scene, const Discretisation<D>& disc, double steps) {
  if (scene.output.frames == 0) return "";
  const double frame = frame_bytes<D>(scene, disc);
  double stress = 0.0;
  std::vector<std::string> others;
  for (const std::string& field : scene.output.fields) {
    const double bytes = bytes_of<D>(field, disc);
    if (is_stress(field))
      stress += bytes;
    else
      others.push_back(fmt::format("\"{}\"", field));
  }
  const double frames = scene.output.frames + 1.0;
  std::string text;
  const Index entries =
      disc.ghosts ? disc.ghosts->plain_gradient().nonzeros() : disc.gradient.nonzeros();
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
template std::string of_output<1>(const Scene&, const Discretisation<1>&, double);
template std::string of_output<2>(const Scene&, const Discretisation<2>&, double);

}  // namespace tlsph::savings
