#include "run_output.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "flat.hpp"
#include "tlsph/particles/delaunay.hpp"
#include "tlsph/simulation/version.hpp"

namespace tlsph {
namespace {

const std::filesystem::path& prepared(const std::filesystem::path& directory) {
  make_output_directory(directory);
  return directory;
}

/// Columns of a series in run.h5, in the order of `RunLoop::write_series`.
template <int D>
std::vector<SeriesQuantity> series_layout() {
  const std::string per = "/m^" + std::to_string(3 - D),
                    per_length = " per m^" + std::to_string(3 - D);
  return {{"kinetic", 1, "J" + per},
          {"elastic", 1, "J" + per},
          {"external_work", 1, "J" + per},
          {"dissipated", 1, "J" + per},
          {"linear_momentum", D, "kg m/s" + per_length},
          {"angular_momentum", 1, "kg m^2/s" + per_length},
          {"dt", 1, "s"}};
}

template <int D>
RunLayout layout_of(const Scene& scene, const Discretisation<D>& body) {
  RunLayout layout;
  layout.dimension = D;
  layout.particles = static_cast<std::size_t>(body.nodes());
  layout.points = static_cast<std::size_t>(body.points.size());
  for (const std::string& name : scene.output.fields) {
    const Quantity<D>& quantity = quantity_named<D>(name);
    layout.fields.push_back({name, quantity.site, quantity.rank, std::string(quantity.unit)});
  }
  layout.series = series_layout<D>();
  layout.points_are_cells =
      !body.particles.cells.empty() && layout.points == body.particles.cells.size();
  layout.triangles = body.particles.triangles.size();
  layout.points_are_nodes = is_collocated(scene.formulation);
  return layout;
}

/// The nodes of cells or triangles, one after the other.
template <class Corners>
std::vector<std::int32_t> corners(const std::vector<Corners>& elements) {
  std::vector<std::int32_t> nodes;
  for (const Corners& element : elements) nodes.insert(nodes.end(), element.begin(), element.end());
  return nodes;
}

/// Ends and neighbours of their edges.
std::vector<std::int32_t> edges(const std::vector<Triangle>& triangles) {
  std::vector<std::int32_t> nodes;
  for (const auto& [a, b, left, right] : edges_of(triangles))
    nodes.insert(nodes.end(), {a, b, left, right});
  return nodes;
}

}  // namespace

template <int D>
RunOutput<D>::RunOutput(const std::filesystem::path& directory, const Scene& scene,
                        const Discretisation<D>& body, const ProbeHistories& probes,
                        const std::optional<OutputCounts>& resumed)
    : directory_(directory), layout_(layout_of<D>(scene, body)), lock_(prepared(directory)) {
  const PatchTags tags = patch_tags<D>(body.particles);
  RunStart start;
  start.scene_file = scene.file;
  start.scene_text = scene.text;
  start.version = version();
  start.particles = {D, flat(body.particles.X), flat(body.particles.V), tags.bits, tags.names};
  start.points = {D, flat(body.points.X), flat(body.points.V)};
  std::vector<std::int32_t> cells;
  if (layout_.points_are_cells) start.cells = cells = corners(body.particles.cells);
  const std::vector<std::int32_t> surface = corners(body.particles.triangles);
  start.triangles = surface;
  start.line = body.particles.line;
  std::vector<std::int32_t> sides;
  if (!layout_.points_are_nodes) start.edges = sides = edges(body.particles.triangles);
  const auto with_time = [](const std::vector<std::string>& names) {
    std::vector<std::string> columns = {"time"};
    columns.insert(columns.end(), names.begin(), names.end());
    return columns;
  };
  const std::vector<std::string> columns = with_time(probes.computed.names);
  const std::vector<std::string> known = with_time(probes.exact.names);
  const bool has_exact = !probes.exact.names.empty();
  const auto run_path = directory / "run.h5";
  const auto probes_path = directory / "probes.csv";
  const auto exact_path = directory / "probes_exact.csv";
  if (!resumed) {
    run_file_.emplace(run_path, layout_, start);
    probe_file_.emplace(probes_path, columns);
    if (has_exact) exact_file_.emplace(exact_path, known);
    return;
  }
  CsvWriter::check(probes_path, columns, resumed->probes);
  if (has_exact) CsvWriter::check(exact_path, known, resumed->exact);
  run_file_.emplace(RunFile::resume(run_path, layout_, start, resumed->run));
  probe_file_.emplace(CsvWriter::resume(probes_path, columns, resumed->probes));
  if (has_exact) exact_file_.emplace(CsvWriter::resume(exact_path, known, resumed->exact));
}

template <int D>
std::span<const double> RunOutput<D>::field(const std::string& name, const Instant<D>& now) {
  if (name == "displacement") return flat(now.u());  // as they are, without a copy
  if (name == "pk1") return flat(now.P());
  const Quantity<D>& quantity = quantity_named<D>(name);
  const bool moves = quantity.site == Site::particles;
  const Index rows = moves ? now.body.nodes() : now.body.points.size();
  std::vector<double>& out = scratch_[name];
  out.clear();
  out.reserve(static_cast<std::size_t>(rows) * component_count(quantity.rank, D));
  for (Index row = 0; row < rows; ++row) {
    const Observed<D> seen = moves ? observed_particle<D>(now, row) : observed_point<D>(now, row);
    for_components<D>(quantity.rank, false,
                      [&](int i, int j) { out.push_back(quantity.value(seen, i, j)); });
  }
  return out;
}

template <int D>
void RunOutput<D>::write_frame(const Instant<D>& now) {
  std::vector<std::span<const double>> fields;
  for (const FrameField& entry : layout_.fields) fields.push_back(field(entry.name, now));
  run_file_->write_frame(now.time(), fields);
  scratch_.clear();  // rather than keep a field that is wanted once in many steps
  const std::filesystem::path document = directory_ / "run.xdmf";
  if (const std::size_t frames = run_file_->frame_times().size(); frames > views_) {
    views_ = std::bit_ceil(std::max(frames, std::size_t{16}));  // some ahead, for frames to come
    write_views(view_file_of(document), layout_, views_);
  }
  write_xdmf(document, layout_, run_file_->frame_times());
}

template <int D>
void RunOutput<D>::flush() {
  run_file_->flush();
  probe_file_->flush();
  if (exact_file_) exact_file_->flush();
}

template <int D>
OutputCounts RunOutput<D>::counts() const {
  return {run_file_->rows(), probe_file_->rows(), exact_file_ ? exact_file_->rows() : CsvRows{}};
}

template class RunOutput<1>;
template class RunOutput<2>;

}  // namespace tlsph
