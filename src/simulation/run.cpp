#include <omp.h>

#include <algorithm>

#include "in_scene.hpp"
#include "memory.hpp"
#include "preflight.hpp"
#include "run_loop.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/free_cores.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/core/stopwatch.hpp"
#include "tlsph/core/thread_count.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/version.hpp"

namespace tlsph {
namespace {

/// Below this many particles a second thread costs more than it brings.
constexpr Index one_thread_below = 2000;

template <int D>
void describe(const Scene& scene, const Discretisation<D>& body, Summary& summary) {
  summary.scene = scene.file;
  summary.title = scene.title;
  summary.version = version();
  summary.dimension = D;
  summary.formulation = name_of(scene.formulation);
  summary.consistency = body.consistency;
  summary.kernel = scene.kernel.family;
  summary.support = scene.kernel.support;
  summary.particles = body.nodes();
  summary.points = body.points.size();
  summary.spacing = body.spacing;
  summary.loads = loaded_patches<D>(scene, body);
  summary.warnings = warnings<D>(scene, body);
  const VectorOperator<D>& G = body.ghosts ? body.ghosts->plain_gradient() : body.gradient;
  if (body.ghosts) {
    summary.ghosts = body.ghosts->lattice().ghosts();
    summary.boundary_solver = body.ghosts->solver();
  }
  summary.nonzeros = G.nonzeros();
  summary.neighbours_mean =
      static_cast<double>(G.nonzeros()) / static_cast<double>(std::max<Index>(1, G.rows()));
}

template <int D>
void run_in(const Scene& scene, const RunOptions& options, Summary& summary) {
  const Stopwatch setup;
  const auto body = in_scene(scene, [&] { return build<D>(scene); });
  if (options.threads == 0 && body.nodes() < one_thread_below) omp_set_num_threads(1);
  describe<D>(scene, body, summary);
  summary.wall_setup = setup.seconds();
  RunLoop<D> loop = in_scene(scene, [&] { return RunLoop<D>(scene, options, body, summary); });
  const auto write = [&] {
    summary.peak_memory_bytes = memory_status("VmHWM:");
    if (options.out.empty()) return;
    make_output_directory(options.out);
    write_text_file(options.out / "summary.json", summary.json());
  };
  try {
    loop.run();
  } catch (const NumericalError&) {
    write();
    throw;
  }
  write();
}

}  // namespace

Summary run(const Scene& scene, const RunOptions& options) {
  const ThreadCount threads(options.threads > 0 ? options.threads : omp_get_max_threads());
  if (options.threads > 0)
    set_blas_threads(options.threads);
  else if (scene.consistency && !cores_are_free(omp_get_max_threads()))
    set_blas_threads(1);
  Summary summary;
  try {
    in_dimension(scene.dimension, [&]<int D>() { run_in<D>(scene, options, summary); });
  } catch (const Stopped&) {  // in the set-up
    summary = {};
    summary.interrupted = true;
  }
  return summary;
}

std::filesystem::path default_output(const Scene& scene) {
  return std::filesystem::path("out") / std::filesystem::path(scene.file).stem();
}

}  // namespace tlsph
