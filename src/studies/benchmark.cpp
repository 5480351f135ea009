#include "tlsph/studies/benchmark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <thread>
#include <variant>

#include "tlsph/core/cpu_clock.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/thread_count.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/stepping/critical_step.hpp"
#include "tlsph/studies/plain_step.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {
namespace {

constexpr int batches = 7;

/// One body, and how it is stepped.
struct TimedCase {
  std::string name;
  int dimension = 2;
  std::vector<std::string> overrides;
  Index particles = 0;  // 0: the large number
  int threads = 1;
  bool plain = true;  // measured beside it
};

std::vector<TimedCase> timed_cases(int cores) {
  const auto collocated = [](const std::string& support, std::vector<std::string> more = {}) {
    more.insert(more.begin(),
                {"formulation=variational", "kernel.support=" + support, "stabiliser.kind=none"});
    return more;
  };
  const auto irregular = collocated("2.5", {"body.jitter=0.2"});
  const std::vector<std::string> linear = {"material.law=linear-elastic"};
  std::vector<TimedCase> list = {
      {"stress-point, cell stabiliser, lattice", 2, {}},
      {"the same, linear elastic", 2, linear},
      {"the same, Neo-Hookean in plane stress", 2, {"material.assumption=stress"}, 0, 1, false},
      {"collocated, 9 neighbours, lattice", 2, collocated("1.5")},
      {"collocated, 21 neighbours, lattice", 2, collocated("2.5")},
      {"collocated, 21 neighbours, irregular", 2, irregular},
      {"the same, mixed precision", 2, collocated("2.5", {"body.jitter=0.2", "precision=mixed"}), 0,
       1, false},
      {"collocated, 96 neighbours, lattice", 2, collocated("5.5")},
      {"stress-point, cell stabiliser, irregular", 2, {"body.jitter=0.2"}},
      {"bar, stress-point", 1, {}},
      {"collocated, 9 neighbours, 900 particles", 2, collocated("1.5"), 900, 1, false},
      {"stress-point, 225 particles", 2, {}, 225, 1, false},
      {"stress-point, 900 particles", 2, {}, 900, 1, false},
      {"stress-point, 3 000 particles", 2, {}, 3000, 1, false},
      {"stress-point, 20 000 particles", 2, {}, 20'000, 1, false},
  };
  if (cores > 1) {
    list.push_back({"the same, two threads", 2, {}, 20'000, 2, false});
    list.push_back({"stress-point, lattice, two threads", 2, {}, 0, 2, false});
    list.push_back({"collocated, 21, irregular, two threads", 2, irregular, 0, 2, false});
  }
  return list;
}

Scene scene_of(const TimedCase& entry, Index large) {
  const auto particles = static_cast<double>(entry.particles > 0 ? entry.particles : large);
  const double cells = std::round(entry.dimension == 1 ? particles - 1 : std::sqrt(particles) - 1);
  const std::string text = fmt::format(
      "dimension = {}\n[body]\nshape = {{ {} }}\nspacing = {:.17g}\n[material]\nyoung = 2e6\n"
      "poisson = 0.3\ndensity = 1000\n[time]\nend = 1.0\n",
      entry.dimension,
      entry.dimension == 1 ? "interval = [0.0, 1.0]" : "box = [[0.0, 0.0], [1.0, 1.0]]",
      1.0 / cells);
  return read_scene_text(text, entry.name, entry.overrides);
}

/// A smooth motion, small beside one.
template <int D>
VectorField<D> wave(const VectorField<D>& X) {
  VectorField<D> u(X.rows(), D);
  for (Index q = 0; q < X.rows(); ++q)
    for (int i = 0; i < D; ++i) u(q, i) = 1e-6 * std::sin(3.0 * X(q, i) + X.row(q).sum() + i);
  return u;
}

/// CPU seconds of this thread for one call, in batches of so many: the fastest and the median
/// batch. Of a team that is its time on a machine whose cores it has for itself.
template <class Call>
std::array<double, 2> timed(double seconds, const Call& call) {
  call();
  const double first = cpu_seconds();
  call();
  const auto calls =
      std::max<long>(1, std::lround(seconds / std::max(1e-9, cpu_seconds() - first)));
  std::array<double, batches> batch{};
  for (double& each : batch) {
    const double start = cpu_seconds();
    for (long k = 0; k < calls; ++k) call();
    each = (cpu_seconds() - start) / static_cast<double>(calls);
  }
  std::ranges::sort(batch);
  return {batch.front(), batch[batches / 2]};
}

/// Multiply-adds of a law at a point, as it counts them itself.
template <int D>
double law_work(const AnyLaw<D>& any) {
  return std::visit(
      []<class Law>(const Law&) {
        if constexpr (requires { Law::multiply_adds; })
          return Law::multiply_adds;
        else
          return not_known;
      },
      any);
}

template <int D>
BenchmarkRow measure(const TimedCase& entry, const BenchmarkOptions& options,
                     const BenchmarkTable& machine) {
  const Scene scene = scene_of(entry, options.particles);
  const Discretisation<D> body = build<D>(scene);
  State<D> state =
      make_state<D>(body, wave<D>(body.particles.X), VectorField<D>::Zero(body.nodes(), D));
  evaluate<D>(body, state);
  const double dt = 0.5 * critical_step<D>(body, state).dt;
  start<D>(body, state, dt);
  Sweep<D> sweep(body, {entry.threads, scene.precision == Precision::mixed, Instructions::widest});
  BoundaryForces<D> forces(body);

  BenchmarkRow row;
  row.name = entry.name;
  row.particles = body.nodes();
  row.neighbours =
      static_cast<double>(body.gradient.nonzeros()) / static_cast<double>(body.gradient.rows());
  row.threads = entry.threads;
  row.storage = sweep.storage();
  const auto particles = static_cast<double>(body.nodes());
  const auto [fastest, median] =
      timed(options.seconds, [&] { sweep.step(state, dt, state.time + dt, forces); });
  row.ns = fastest * 1e9 / particles;
  row.spread = median / fastest - 1.0;
  if (entry.plain) {
    PlainStep<D> plain(body, state.u);
    const ThreadCount alone(1);  // Eigen shares its products among all there are
    row.plain_ns = timed(0.5 * options.seconds, [&] { plain.step(dt); })[0] * 1e9 / particles;
  }
  const double entries = static_cast<double>(body.gradient.nonzeros()) / particles;
  const double modes = body.hourglass.empty() ? 0.0 : 1.0;
  const double points = static_cast<double>(body.points.size()) / particles;
  row.multiply_adds =
      sweep.stiffness_multiply_adds().value_or(2.0 * entries * (D + modes) * D +
                                               points * law_work<D>(body.regions.front().law)) +
      2.0 * D;
  const double weights =
      row.storage.bytes / particles *
      (scene.precision == Precision::mixed ? (4.0 + 4.0 * D) / (4.0 + 8.0 * D) : 1.0);
  row.bytes = 4.0 * D * sizeof(double) + weights;  // u and v in and out, and what rows read
  row.memory_ns = row.bytes / machine.triad_bytes_per_second * 1e9 / entry.threads;
  row.arithmetic_ns = row.multiply_adds / machine.multiply_adds_per_second * 1e9 / entry.threads;
  return row;
}

double triad() {
  constexpr std::size_t size = 1 << 24;
  std::vector<double> a(size, 1.0), b(size, 2.0), c(size, 3.0);
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < batches; ++k) {
    const double start = cpu_seconds();
    for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 0.5 * c[i];
    best = std::min(best, cpu_seconds() - start);
    b[static_cast<std::size_t>(k)] = a[size - 1];
  }
  return 3.0 * size * sizeof(double) / best;
}

}  // namespace

double BenchmarkRow::share() const {
  return std::max(memory_ns, arithmetic_ns) / ns;
}

BenchmarkTable benchmark(const BenchmarkOptions& options) {
  BenchmarkTable table;
  table.instructions = widest_instructions();
  table.cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  table.triad_bytes_per_second = triad();
  for (int k = 0; k < batches; ++k)
    table.multiply_adds_per_second =
        std::max(table.multiply_adds_per_second, peak_multiply_adds(2'000'000));
  for (const TimedCase& entry : timed_cases(table.cores)) {
    table.interrupted = options.stopped();
    if (table.interrupted) break;
    if (options.before_case) options.before_case(entry.name);
    table.rows.push_back(
        in_dimension(entry.dimension, [&]<int D>() { return measure<D>(entry, options, table); }));
    if (!options.out.empty()) table.write(options.out);
  }
  return table;
}

}  // namespace tlsph
