// The keys of the top level and of the small tables, and all keys in the order of the reference.
#include "keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tlsph/observe/quantity.hpp"

namespace tlsph {
namespace {

Allowed quantities_named() {
  return Allowed({quantity_names.begin(), quantity_names.end()});
}

void check_time(TimeScene& time, const TableView& view, const Scene&) {
  if (time.step && *time.step > time.end)
    fail_at(view.place_of("step"), "must not exceed time.end, {} s", time.end);
}

const Table<TimeScene>& time_keys() {
  static const Table<TimeScene> keys = {
      "time",
      {
          key(&TimeScene::end, "end", "s", above(0.0), "the last step lands on it")
              .required()
              .at(&TimeScene::end_place),
          key(&TimeScene::safety, "safety", "", Range{0.0, 1.0, false, true},
              "share of the computed critical step; where large strains stiffen the body, the step "
              "falls below its first value and stays there"),
          key(&TimeScene::step, "step", "s", above(0.0),
              "instead of safety; the same from start to end. Refused where it exceeds the "
              "critical step at the start by more than 0.5 %")
              .otherwise("(safety x critical step)")
              .at(&TimeScene::step_place),
          key(&TimeScene::allow_unstable, "allow_unstable", "", {},
              "takes a step above the critical one, to see what grows: the run ends where it does"),
          key(&TimeScene::energy_tolerance, "energy_tolerance", "", above(0.0),
              "ends the run where its energy leaves its balance by more than this share of the "
              "largest energy; without it, 1 % and more are reported at the end"),
      },
      check_time};
  return keys;
}

/// The last of the scene's probes. Its name can head a column of probes.csv.
void check_probe(ProbeScene& probe, const TableView& view, const Scene& scene) {
  const Place place = view.place_of("name");
  if (!view.has("name")) probe.name = fmt::format("p{}", scene.probes.size());
  const bool plain = !probe.name.empty() && probe.name.find_first_not_of(
                                                "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWX"
                                                "YZ0123456789_-") == std::string::npos;
  if (!plain)
    fail_at(place,
            "\"{}\" cannot head a column; allowed: letters, digits, _ "
            "and -",
            probe.name);
  for (const ProbeScene& other : scene.probes)
    if (&other != &probe && other.name == probe.name)
      fail_at(place, "\"{}\" is already the name of another probe", probe.name);
  for (auto word = probe.record.begin(); word != probe.record.end(); ++word)
    if (std::find(probe.record.begin(), word, *word) != word)
      fail_at(view.place_of("record"), "\"{}\" is listed twice", *word);
  if (probe.record.empty())
    fail_at(view.place_of("record"), "must name at least one of {}",
            fmt::join(quantity_names, " | "));
}

const Table<ProbeScene>& probe_keys() {
  static const Table<ProbeScene> keys = {
      "probe",
      {
          key(&ProbeScene::name, "name", "", {}, "its columns are name.quantity")
              .otherwise("(p1, p2, …)"),
          key(&ProbeScene::at, "at", "m", {}, "reference position, inside the body")
              .required()
              .at(&ProbeScene::place),
          key(&ProbeScene::record, "record", "", quantities_named(), "what to record"),
      },
      check_probe};
  return keys;
}

const Table<Scene>& reference_keys() {
  static const Table<Scene> keys = {
      "reference",
      {key(&Scene::exact, "exact", "", {}, "an exact solution: errors go to summary.json")
           .at(&Scene::exact_place)}};
  return keys;
}

void check_output(OutputScene& output, const TableView& view, const Scene&) {
  auto sorted = output.fields;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    throw InputError(view.place_of("fields"), "lists a field twice");
}

const Table<OutputScene>& output_keys() {
  static const Table<OutputScene> keys = {
      "output",
      {
          key(&OutputScene::frames, "frames", "", not_below(0.0),
              "full fields after the initial one"),
          key(&OutputScene::fields, "fields", "", quantities_named(), "what a frame holds"),
          key(&OutputScene::probe_every, "probe_every", "steps", not_below(1.0),
              "between rows of probes.csv"),
          key(&OutputScene::energy_every, "energy_every", "steps", not_below(0.0),
              "between rows of the energy ledger; 0: about 200 rows, at least 50 steps apart"),
          key(&OutputScene::checkpoint, "checkpoint", "s", above(0.0),
              "wall time between checkpoints"),
          key(&OutputScene::checkpoint_steps, "checkpoint_steps", "steps", not_below(0.0),
              "steps between checkpoints; 0: by wall time only"),
      },
      check_output};
  return keys;
}

}  // namespace

const Table<Scene>& scene_keys() {
  static const Table<Scene> keys = {
      "",
      {
          key(&Scene::title, "title", "", {}, "what the run is called in its results"),
          key(&Scene::dimension, "dimension", "", closed(1.0, 2.0),
              "1: a bar; 2: a sheet of unit thickness"),
          key(&Scene::formulation, "formulation", "", {},
              "which gradient and divergence matrices: thesis (SPH sums, ghosts, modified SPH "
              "matrix), mirror (SPH sums, ghosts folded into the matrices), variational (corrected "
              "gradient, adjoint divergence), consistent (the same, corrected so that its adjoint "
              "is exact too), stress-point (gradient at cell centres, adjoint divergence)")
              .at(&Scene::formulation_place),
          key(&Scene::ghosts, "boundary_treatment", "", {},
              "thesis only: the modified SPH matrix with the coupling to the interior, as printed "
              "without it, or the eta corrections (1D)"),
          key(&Scene::boundary_solver, "boundary_solver", "", {},
              "thesis only: factorisation of the modified SPH matrix; auto tries cholmod, then "
              "umfpack")
              .at(&Scene::boundary_solver_place),
          key(&Scene::precision, "precision", "", {},
              "mixed: weights in single precision where particles are irregular, sums in double; "
              "faster there, momenta kept to 1e-7; lattices are not touched, nor thesis and "
              "mirror"),
          consistency_key(),
          key(&Scene::body_force, "gravity", "m/s^2", {},
              "acceleration of the whole body, one number per dimension")
              .otherwise("(none)"),
          table_key(&Scene::body, body_keys(), "body", "what is modelled").required(),
          table_key(&Scene::kernel, kernel_keys(), "kernel", "what weights the neighbours"),
          table_key(&Scene::stabiliser, stabiliser_keys(), "stabiliser",
                    "what holds zero-energy modes"),
          materials_key(),
          list_key(&Scene::boundaries, boundary_keys(), "boundary",
                   "one entry per condition; patches without one are free"),
          table_key(&Scene::time, time_keys(), "time", "how long and in which steps").required(),
          list_key(&Scene::probes, probe_keys(), "probe",
                   "points whose history goes to probes.csv"),
          part_key(reference_keys(), "reference", "what the result is compared with"),
          part_key(initial_keys(), "initial", "the state at t = 0"),
          table_key(&Scene::output, output_keys(), "output", "what is written, and how often"),
      }};
  return keys;
}

const std::vector<Key>& schema() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    for (const std::vector<Key>& more :
         {keys_of(scene_keys()), keys_of(body_keys()), shape_keys(), keys_of(tag_keys()),
          keys_of(kernel_keys()), keys_of(stabiliser_keys()), keys_of(material_keys()),
          keys_of(region_keys()), keys_of(boundary_keys()), curve_keys(), keys_of(time_keys()),
          keys_of(probe_keys()), keys_of(reference_keys()), keys_of(initial_keys()),
          initial_part_keys(), keys_of(output_keys())})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return keys;
}

const Key* find_key(std::string_view group, std::string_view name) {
  for (const Key& key : schema())
    if (key.group == group && key.name == name) return &key;
  return nullptr;
}

}  // namespace tlsph
