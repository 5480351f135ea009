#include <fmt/format.h>

#include <cmath>

#include "tlsph/io/files.hpp"
#include "tlsph/io/table.hpp"
#include "tlsph/studies/benchmark.hpp"

namespace tlsph {
namespace {

std::string particles_words(double count) {
  return count < 10'000 ? fmt::format("{:.0f}", count) : fmt::format("{:.0f}k", count * 1e-3);
}

/// Nothing where there is no number.
std::string one_digit(double value) {
  return std::isfinite(value) ? fmt::format("{:.1f}", value) : "";
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100.0 * share);
}

Table<BenchmarkRow> row_table() {
  using Row = BenchmarkRow;
  const auto limit = [](const Row& row) { return row.memory_binds() ? "memory" : "arithmetic"; };
  return {
      {"case", &Row::name, {"", "<44"}},
      {"particles", &Row::particles, {"particles", " >9", particles_words}},
      {"neighbours", &Row::neighbours, {"neighbours", " >10.1f"}},
      {"threads", &Row::threads, {"threads", " >7"}},
      {"stencil_rows", [](const Row& row) { return row.storage.stencil_rows; }},
      {"distinct_stencils", [](const Row& row) { return row.storage.distinct_stencils; }},
      {"general_rows", [](const Row& row) { return row.storage.general_rows; }},
      {"ns", &Row::ns, {"ns", " >9.2f"}},
      {"spread", &Row::spread},
      {"plain_ns", &Row::plain_ns, {"plain ns", " >10", one_digit}},
      {"", [](const Row& row) { return row.plain_ns / row.ns; }, {"ratio", " >8", one_digit}},
      {"bytes", &Row::bytes, {"bytes", " >6.0f"}},
      {"multiply_adds", &Row::multiply_adds},
      {"memory_ns", &Row::memory_ns},
      {"arithmetic_ns", &Row::arithmetic_ns},
      {"share_of_limit", &Row::share, {"share", " >8", percent}},
      {"limit", limit, {"limit", "  <"}},
  };
}

}  // namespace

std::string BenchmarkTable::text() const {
  return fmt::format(
             "one core: triad {:.1f} GB/s, {:.1f} G multiply-adds/s with {} instructions; {} "
             "cores\n\n",
             triad_bytes_per_second * 1e-9, multiply_adds_per_second * 1e-9, instructions, cores) +
         row_table().text(rows) +
         "\nns, plain ns: CPU time of a thread per particle and step, the fastest of seven "
         "batches; plain: sparse products of Eigen\nbytes: per particle and step, u and v in and "
         "out and the weights of rows without a stencil\nshare: what the binding limit alone would "
         "take of the time\n";
}

void BenchmarkTable::write(const std::filesystem::path& directory) const {
  make_output_directory(directory);
  Json tree;
  tree.set("triad_bytes_per_second", triad_bytes_per_second);
  tree.set("multiply_adds_per_second", multiply_adds_per_second);
  tree.set("instructions", instructions);
  tree.set("cores", cores);
  tree.set("rows", row_table().json(rows));
  tree.write(directory / "benchmark.json");
  write_text_file(directory / "benchmark.csv", row_table().csv(rows));
}

}  // namespace tlsph
