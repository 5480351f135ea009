#include "tlsph/simulation/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tlsph/io/json.hpp"

namespace tlsph {

std::string LoadedPatch::text() const {
  const std::string extent =
      resultant.size() == 1 ? "" : fmt::format("{:.6g} m of the boundary, ", length);
  return fmt::format("load on {}: {}resultant ({:.6g}) N at its amplitude", where, extent,
                     fmt::join(resultant, ", "));
}

std::string Summary::json() const {
  Json tree;
  tree.set("scene", scene);
  tree.set("title", title);
  tree.set("version", version);
  tree.set("dimension", dimension);
  tree.set("formulation", formulation);
  tree.set("kernel", kernel);
  tree.set("support", support);
  tree.set("particles", particles);
  tree.set("ghosts", ghosts);
  tree.set("points", points);
  tree.set("spacing", spacing);
  tree.set("nonzeros", nonzeros);
  tree.set("neighbours_mean", neighbours_mean);
  tree.set("dt", dt);
  tree.set("dt_critical", dt_critical);
  tree.set("dt_critical_scaled", dt_critical_scaled);
  tree.set("growth_rate", growth_rate);
  tree.set("steps", steps);
  tree.set("end_time", end_time);
  tree.set("threads", threads);
  tree.set("wall_seconds.setup", wall_setup);
  tree.set("wall_seconds.stepping", wall_stepping);
  tree.set("wall_seconds.output", wall_output);
  tree.set("ns_per_particle_step", ns_per_particle_step);
  if (storage) {
    tree.set("storage.stencil_rows", storage->stencil_rows);
    tree.set("storage.distinct_stencils", storage->distinct_stencils);
    tree.set("storage.general_rows", storage->general_rows);
    tree.set("storage.bytes_per_particle",
             storage->bytes / static_cast<double>(std::max<Index>(1, particles)));
  } else {
    tree.set("storage", nullptr);
  }
  tree.set("peak_memory_bytes", peak_memory_bytes);
  tree.set("energy.kinetic", energy.kinetic);
  tree.set("energy.elastic", energy.elastic);
  tree.set("energy.external_work", energy.external_work);
  tree.set("energy.dissipated", energy.dissipated);
  tree.set("energy.drift_relative", energy.drift_relative);
  tree.set("momentum.linear_drift", linear_momentum_drift);
  tree.set("momentum.angular_drift", angular_momentum_drift);
  if (errors) {
    tree.set("errors.displacement", errors->displacement);
    tree.set("errors.velocity", errors->velocity);
    tree.set("errors.stress", errors->stress);
  } else {
    tree.set("errors", nullptr);
  }
  if (hyperbolicity_lost) {
    tree.set("hyperbolicity_lost.time", hyperbolicity_lost->time);
    tree.set("hyperbolicity_lost.point", hyperbolicity_lost->point);
    tree.set("hyperbolicity_lost.position", hyperbolicity_lost->position);
    tree.set("hyperbolicity_lost.stretches", hyperbolicity_lost->stretches);
    tree.set("hyperbolicity_lost.acoustic_eigenvalue", hyperbolicity_lost->acoustic_eigenvalue);
  } else {
    tree.set("hyperbolicity_lost", nullptr);
  }
  if (consistency) {
    tree.set("consistency.row_residual", consistency->row);
    tree.set("consistency.column_residual", consistency->column);
    tree.set("consistency.change", consistency->change);
  } else {
    tree.set("consistency", nullptr);
  }
  std::vector<Json> patches;
  for (const LoadedPatch& load : loads) {
    Json& entry = patches.emplace_back();
    entry.set("where", load.where);
    entry.set("length", load.length);
    entry.set("resultant", load.resultant);
  }
  tree.set("loads", patches);
  tree.set("warnings", warnings);
  tree.set("boundary_solver", Json::text_or_null(boundary_solver));
  tree.set("interrupted", interrupted);
  tree.set("failure", Json::text_or_null(failure));
  return tree.dump() + '\n';
}

}  // namespace tlsph
