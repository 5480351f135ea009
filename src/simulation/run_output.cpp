#include "run_output.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "tlsph/dynamics/measures.hpp"
#include "tlsph/particles/delaunay.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/version.hpp"

namespace tlsph {
namespace {

std::span<const double> flat(const auto& matrix) {
  return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

const std::filesystem::path& prepared(const std::filesystem::path& directory) {
  make_output_directory(directory);
  return directory;
}

FrameField frame_field(const std::string& name) {
  const auto quantity = from_name<Quantity>(name);
  switch (quantity.value_or(Quantity::displacement)) {
    case Quantity::velocity:
      return {name, Site::particles, Rank::vector, "m/s"};
    case Quantity::acceleration:
      return {name, Site::particles, Rank::vector, "m/s^2"};
    case Quantity::deformation_gradient:
      return {name, Site::points, Rank::tensor, "1"};
    case Quantity::pk1:
    case Quantity::cauchy:
      return {name, Site::points, Rank::tensor, "Pa"};
    case Quantity::pressure:
    case Quantity::von_mises:
      return {name, Site::points, Rank::scalar, "Pa"};
    case Quantity::displacement:
      break;
  }
  return {name, Site::particles, Rank::vector, "m"};
}

template <int D>
RunLayout layout_of(const Scene& scene, const Discretisation<D>& disc) {
  RunLayout layout;
  layout.dimension = D;
  layout.particles = static_cast<std::size_t>(disc.nodes());
  layout.points = static_cast<std::size_t>(disc.points.size());
  for (const std::string& name : scene.output.fields) layout.fields.push_back(frame_field(name));
  layout.series = series_layout<D>();
  layout.points_are_cells =
      !disc.particles.cells.empty() && layout.points == disc.particles.cells.size();
  layout.triangles = disc.particles.triangles.size();
  layout.points_are_nodes = is_collocated(scene.formulation);
  return layout;
}

/// Their nodes, cell by cell.
template <int D>
std::vector<std::int32_t> corners(const std::vector<Cell<D>>& cells) {
  std::vector<std::int32_t> nodes;
  nodes.reserve(cells.size() << D);
  for (const Cell<D>& cell : cells) nodes.insert(nodes.end(), cell.begin(), cell.end());
  return nodes;
}

/// Their nodes, three a triangle.
std::vector<std::int32_t> corners(const std::vector<Triangle>& triangles) {
  std::vector<std::int32_t> nodes;
  nodes.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles)
    nodes.insert(nodes.end(), triangle.begin(), triangle.end());
  return nodes;
}

/// Ends and neighbours of their edges.
std::vector<std::int32_t> edges(const std::vector<Triangle>& triangles) {
  std::vector<std::int32_t> nodes;
  for (const auto& [a, b, left, right] : edges_of(triangles))
    nodes.insert(nodes.end(), {a, b, left, right});
  return nodes;
}

/// Columns of probes_exact.csv: what an ExactSolution can answer.
bool has_exact(Quantity quantity) {
  return quantity == Quantity::displacement || quantity == Quantity::velocity ||
         quantity == Quantity::pk1 || quantity == Quantity::cauchy;
}

}  // namespace

template <int D>
std::vector<SeriesQuantity> series_layout() {
  return {{"kinetic", 1, "J/m^" + std::to_string(3 - D)},
          {"elastic", 1, "J/m^" + std::to_string(3 - D)},
          {"external_work", 1, "J/m^" + std::to_string(3 - D)},
          {"dissipated", 1, "J/m^" + std::to_string(3 - D)},
          {"linear_momentum", D, "kg m/s per m^" + std::to_string(3 - D)},
          {"angular_momentum", 1, "kg m^2/s per m^" + std::to_string(3 - D)},
          {"dt", 1, "s"}};
}

template <int D>
RunOutput<D>::RunOutput(const std::filesystem::path& directory, const Scene& scene,
                        const Discretisation<D>& disc, const Probes<D>& probes,
                        const ExactSolution<D>& exact, const std::optional<OutputCounts>& resumed)
    : directory_(directory),
      layout_(layout_of<D>(scene, disc)),
      lock_(prepared(directory)),
      probes_(&probes),
      exact_(&exact),
      requests_(scene.probes) {
  std::vector<std::int64_t> tags(static_cast<std::size_t>(disc.nodes()), 0);
  RunStart start;
  start.scene_file = scene.file;
  start.scene_text = scene.text;
  start.version = version();
  start.particles = {D, flat(disc.particles.X), flat(disc.particles.V), tags, {}};
  start.points = {D, flat(disc.points.X), flat(disc.points.V)};
  std::vector<std::int32_t> cells;
  if (layout_.points_are_cells) start.cells = cells = corners<D>(disc.particles.cells);
  const std::vector<std::int32_t> surface = corners(disc.particles.triangles);
  start.triangles = surface;
  start.line = disc.particles.line;
  std::vector<std::int32_t> sides;
  if (!layout_.points_are_nodes) start.edges = sides = edges(disc.particles.triangles);
  for (std::size_t bit = 0; bit < disc.particles.patches.size() && bit < 63; ++bit) {
    start.particles.patches.push_back(disc.particles.patches[bit].name);
    for (const int node : disc.particles.patches[bit].nodes)
      tags[static_cast<std::size_t>(node)] |= std::int64_t{1} << bit;
  }
  std::vector<std::string> columns = {"time"};
  columns.insert(columns.end(), probes.columns().begin(), probes.columns().end());
  probe_row_.resize(columns.size());
  exact_row_.resize(columns.size());
  std::vector<std::string> known;  // of probes_exact.csv; empty: there is none
  if (exact.displacement && !scene.probes.empty()) {
    known = {"time"};
    for (const std::string& column : probes.columns()) {
      const std::string stem = column.substr(column.rfind('.') + 1);
      for (const Quantity quantity :
           {Quantity::displacement, Quantity::velocity, Quantity::pk1, Quantity::cauchy})
        if (stem.starts_with(name_of(quantity))) known.push_back(column);
    }
  }
  const auto run_path = directory / "run.h5";
  const auto probes_path = directory / "probes.csv";
  const auto exact_path = directory / "probes_exact.csv";
  if (!resumed) {
    run_file_.emplace(RunFile::create(run_path, layout_, start));
    probe_file_.emplace(probes_path, columns);
    if (!known.empty()) exact_file_.emplace(exact_path, known);
    return;
  }
  CsvWriter::check(probes_path, columns, resumed->probes);
  if (!known.empty()) CsvWriter::check(exact_path, known, resumed->exact);
  run_file_.emplace(RunFile::resume(run_path, layout_, start, resumed->run));
  probe_file_.emplace(CsvWriter::resume(probes_path, columns, resumed->probes));
  if (!known.empty()) exact_file_.emplace(CsvWriter::resume(exact_path, known, resumed->exact));
}

template <int D>
std::span<const double> RunOutput<D>::field(const std::string& name, const Discretisation<D>& disc,
                                            const State<D>& state, double dt) {
  if (name == "displacement") return flat(state.u);
  if (name == "pk1") return flat(state.P);
  const auto quantity = from_name<Quantity>(name).value_or(Quantity::displacement);
  std::vector<double>& out = scratch_[name];
  out.clear();
  if (quantity == Quantity::velocity || quantity == Quantity::acceleration) {
    out.reserve(static_cast<std::size_t>(state.v.size()));
    for (Index dof = 0; dof < state.v.size(); ++dof) {
      const NodalMotion motion = motion_of<D>(disc, state, dt, dof);
      out.push_back(quantity == Quantity::velocity ? motion.velocity : motion.acceleration);
    }
    return out;
  }
  const bool scalar = quantity == Quantity::pressure || quantity == Quantity::von_mises;
  out.reserve(static_cast<std::size_t>(disc.points.size() * (scalar ? 1 : D * D)));
  for (Index s = 0; s < disc.points.size(); ++s) {
    const Tensor<D> H = tensor_at<D>(state.H, s);
    const StressMeasures<D> stress =
        stress_measures<D>(disc.regions[region_of<D>(disc, s)], H, tensor_at<D>(state.P, s));
    const Tensor<D> F = Tensor<D>::Identity() + H;
    if (quantity == Quantity::pressure)
      out.push_back(stress.pressure);
    else if (quantity == Quantity::von_mises)
      out.push_back(stress.von_mises);
    else
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          out.push_back(quantity == Quantity::cauchy ? stress.cauchy(i, j) : F(i, j));
  }
  return out;
}

template <int D>
void RunOutput<D>::write_frame(const Discretisation<D>& disc, const State<D>& state, double dt) {
  std::vector<std::span<const double>> fields;
  for (const FrameField& entry : layout_.fields)
    fields.push_back(field(entry.name, disc, state, dt));
  run_file_->write_frame(state.time, fields);
  scratch_.clear();  // rather than keep a field that is wanted once in many steps
  const std::filesystem::path document = directory_ / "run.xdmf";
  if (const std::size_t frames = run_file_->frame_times().size(); frames > views_) {
    views_ = std::bit_ceil(std::max(frames, std::size_t{16}));  // some ahead, for frames to come
    write_views(view_file_of(document), layout_, views_);
  }
  write_xdmf(document, layout_, run_file_->frame_times());
}

template <int D>
void RunOutput<D>::write_probes(const Discretisation<D>& disc, const State<D>& state, double dt,
                                bool evaluated) {
  probe_row_[0] = state.time;
  probes_->sample(disc, state, dt, std::span(probe_row_).subspan(1));
  row_waits_ = true;
  if (evaluated) keep_probes();
}

template <int D>
void RunOutput<D>::keep_probes() {
  if (!row_waits_) return;
  row_waits_ = false;
  probe_file_->row(probe_row_);
  if (exact_file_) write_exact(probe_row_[0]);
}

template <int D>
void RunOutput<D>::write_exact(double time) {
  std::size_t out = 0;
  exact_row_[out++] = time;
  for (const ProbeScene& probe : requests_) {
    const Vector<D> X = Eigen::Map<const Vector<D>>(probe.at.data());
    for (const Quantity quantity : probe.record) {
      if (!has_exact(quantity)) continue;
      if (quantity == Quantity::displacement || quantity == Quantity::velocity) {
        const Vector<D> value = quantity == Quantity::displacement ? exact_->displacement(X, time)
                                                                   : exact_->velocity(X, time);
        for (int i = 0; i < D; ++i) exact_row_[out++] = value[i];
      } else {
        const Tensor<D> value = exact_->stress(X, time);
        for (int i = 0; i < D; ++i)
          for (int j = quantity == Quantity::cauchy ? i : 0; j < D; ++j)
            exact_row_[out++] = value(i, j);
      }
    }
  }
  exact_file_->row(std::span<const double>(exact_row_).first(out));
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
template std::vector<SeriesQuantity> series_layout<1>();
template std::vector<SeriesQuantity> series_layout<2>();

}  // namespace tlsph
