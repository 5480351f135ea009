#include <fmt/format.h>

#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/studies/benchmark.hpp"

namespace tlsph {
namespace {

std::string particles_text(Index count) {
  return count < 10'000 ? fmt::format("{}", count)
                        : fmt::format("{:.0f}k", static_cast<double>(count) * 1e-3);
}

}  // namespace

std::string BenchmarkTable::text() const {
  std::string text = fmt::format(
      "one core: triad {:.1f} GB/s, {:.1f} G multiply-adds/s with {} instructions; {} cores\n\n"
      "{:<44} {:>9} {:>10} {:>7} {:>9} {:>10} {:>8} {:>6} {:>7}  {}\n",
      triad_bytes_per_second * 1e-9, multiply_adds_per_second * 1e-9, instructions, cores, "",
      "particles", "neighbours", "threads", "ns", "plain ns", "ratio", "bytes", "share", "limit");
  for (const BenchmarkRow& row : rows) {
    const std::string plain = row.plain_ns > 0 ? fmt::format("{:.1f}", row.plain_ns) : "";
    const std::string ratio = row.plain_ns > 0 ? fmt::format("{:.1f}", row.plain_ns / row.ns) : "";
    text += fmt::format(
        "{:<44} {:>9} {:>10.1f} {:>7} {:>9.2f} {:>10} {:>8} {:>6.0f} {:>6.0f} %  {}\n", row.name,
        particles_text(row.particles), row.neighbours, row.threads, row.ns, plain, ratio, row.bytes,
        100.0 * row.share(), row.memory_binds() ? "memory" : "arithmetic");
  }
  text +=
      "\nns, plain ns: CPU time of a thread per particle and step, the fastest of seven batches; "
      "plain: sparse products of Eigen\nbytes: per particle and step, u and v in and out and the "
      "weights of rows without a "
      "stencil\nshare: what the binding limit alone would take of the time\n";
  return text;
}

void BenchmarkTable::write(const std::filesystem::path& directory) const {
  make_output_directory(directory);
  Json tree;
  tree.set("triad_bytes_per_second", triad_bytes_per_second);
  tree.set("multiply_adds_per_second", multiply_adds_per_second);
  tree.set("instructions", instructions);
  tree.set("cores", cores);
  std::string csv =
      "case,particles,neighbours,threads,stencil_rows,distinct_stencils,general_rows,ns,spread,"
      "plain_ns,bytes,multiply_adds,memory_ns,arithmetic_ns\n";
  tree.make_list("rows");
  for (const BenchmarkRow& row : rows) {
    Json entry;
    entry.set("case", row.name);
    entry.set("particles", row.particles);
    entry.set("neighbours", row.neighbours);
    entry.set("threads", row.threads);
    entry.set("ns_per_particle_step", row.ns);
    entry.set("spread", row.spread);
    if (row.plain_ns > 0)
      entry.set("plain_ns_per_particle_step", row.plain_ns);
    else
      entry.set("plain_ns_per_particle_step", nullptr);
    entry.set("bytes", row.bytes);
    entry.set("multiply_adds", row.multiply_adds);
    entry.set("share_of_limit", row.share());
    entry.set("limit", row.memory_binds() ? "memory" : "arithmetic");
    tree.append("rows", entry);
    csv += fmt::format(
        "\"{}\",{},{:.6g},{},{},{},{},{:.6g},{:.3g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", row.name,
        row.particles, row.neighbours, row.threads, row.storage.stencil_rows,
        row.storage.distinct_stencils, row.storage.general_rows, row.ns, row.spread, row.plain_ns,
        row.bytes, row.multiply_adds, row.memory_ns, row.arithmetic_ns);
  }
  write_text_file(directory / "benchmark.csv", csv);
  write_text_file(directory / "benchmark.json", tree.dump() + '\n');
}

}  // namespace tlsph
