#include "tlsph/io/run_file.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <numeric>

#include "system.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

constexpr std::size_t buffered_rows = 256;
constexpr std::size_t series_chunk_rows = 4096;

std::string frames_of(const FrameField& field) {
  return "/frames/" + field.name;
}
std::string series_of(const SeriesQuantity& quantity) {
  return "/series/" + quantity.name;
}

/// A data set that grows row by row.
struct Series {
  std::string item;
  Extents row_shape;
  std::string unit;
  bool is_field = false;  ///< else its rows are small

  [[nodiscard]] std::size_t rows(const RunRows& written) const {
    return item.starts_with("/frames/") ? written.frames : written.series;
  }
};

std::vector<Series> series_in(const RunLayout& layout) {
  std::vector<Series> all = {{"/frames/time", {}, "s"}, {"/series/time", {}, "s"}};
  for (const FrameField& field : layout.fields) {
    Extents shape{layout.rows(field)};
    if (field.rank != Rank::scalar) shape.push_back(layout.components(field));
    all.push_back({frames_of(field), std::move(shape), field.unit, true});
  }
  for (const SeriesQuantity& quantity : layout.series)
    all.push_back({series_of(quantity),
                   quantity.components == 1 ? Extents{} : Extents{quantity.components},
                   quantity.unit});
  return all;
}

/// Positions in three dimensions and the number of each vertex: what viewers want of points.
void write_vertices(Hdf5File& file, const std::string& group, const CloudView& cloud) {
  std::vector<double> positions(3 * cloud.size(), 0.0);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (std::size_t a = 0; a < cloud.dimension; ++a)
      positions[3 * i + a] = cloud.X[cloud.dimension * i + a];
  std::vector<std::int32_t> vertices(cloud.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  file.write(group + "/positions", positions, {cloud.size(), 3}, "m");
  file.write(group + "/vertices", vertices, {cloud.size(), 1});
}

/// Numbers of nodes or lines, `width` for each of `count`; nothing where there are none.
void write_numbers(Hdf5File& file, const std::string& item, std::span<const std::int32_t> numbers,
                   std::size_t count, std::size_t width) {
  if (numbers.empty()) return;
  assert(numbers.size() == count * width);
  file.write(item, numbers, width == 1 ? Extents{count} : Extents{count, width}, "1");
}

void expect_shape(const Hdf5File& file, const std::string& item, const Extents& row_shape,
                  std::size_t least) {
  const Place place{file.path().string() + ":" + item, 0, 0, ""};
  if (!file.exists(item))
    throw InputError(place, "is not there; this is another run's file, start without --resume");
  const Extents shape = file.shape(item);
  if (shape.empty() ||
      !std::equal(shape.begin() + 1, shape.end(), row_shape.begin(), row_shape.end()))
    throw InputError(place, "has the shape of another run; start without --resume");
  if (shape[0] < least)
    throw InputError(place, std::to_string(least) + " rows are needed to go on, " +
                                std::to_string(shape[0]) + " are there");
}

std::uint64_t total(const std::map<std::string, CheckSum>& sums) {
  CheckSum sum;
  for (const auto& [item, own] : sums) {
    const std::uint64_t value = own.value();
    sum.add(&value, sizeof value);
  }
  return sum.value();
}

void add(std::map<std::string, CheckSum>& sums, const std::string& item,
         std::span<const double> values) {
  if (!values.empty()) sums[item].add(values.data(), values.size_bytes());
}

}  // namespace

std::size_t RunLayout::rows(const FrameField& field) const {
  return field.site == Site::particles ? particles : points;
}

std::size_t RunLayout::components(const FrameField& field) const {
  return component_count(field.rank, dimension);
}

namespace {

Hdf5File create_file(const std::filesystem::path& path, const RunLayout& layout,
                     const RunStart& start) {
  assert(start.particles.size() == layout.particles && start.points.size() == layout.points);
  Hdf5File file = Hdf5File::create(path);
  file.make_group("/scene");
  file.set_attribute("/scene", "text", start.scene_text);
  file.set_attribute("/scene", "file", start.scene_file);
  file.set_attribute("/scene", "version", start.version);
  file.set_attribute("/scene", "dimension", static_cast<std::int64_t>(layout.dimension));
  write_cloud(file, "/particles", start.particles);
  write_cloud(file, "/points", start.points);
  write_vertices(file, "/xdmf/particles", start.particles);
  write_numbers(file, "/points/cells", start.cells, layout.points,
                std::size_t{1} << layout.dimension);
  write_numbers(file, "/particles/triangles", start.triangles, layout.triangles, 3);
  write_numbers(file, "/points/edges", start.edges, layout.points, 4);
  write_numbers(file, "/particles/line", start.line, layout.particles, 1);
  if (!layout.points_are_cells) write_vertices(file, "/xdmf/points", start.points);
  for (const auto& [item, row_shape, unit, is_field] : series_in(layout)) {
    file.create_series(item, row_shape, is_field ? 0 : series_chunk_rows);
    file.set_attribute(item, "unit", unit);
  }
  for (const FrameField& field : layout.fields) {
    file.set_attribute(frames_of(field), "site",
                       field.site == Site::particles ? "particles" : "points");
    if (field.rank != Rank::scalar)
      file.set_attribute(frames_of(field), "components",
                         component_names(field.rank, layout.dimension));
  }
  return file;
}

/// Hands `rows` of the file at `path` to `take`, series by series.
void read_series(const std::filesystem::path& path, const RunLayout& layout, const RunRows& rows,
                 const std::function<void(const std::string&, std::span<const double>)>& take) {
  const Hdf5File file = Hdf5File::open_read_only(path);
  const std::vector<Series> all = series_in(layout);
  for (const Series& series : all)
    expect_shape(file, series.item, series.row_shape, series.rows(rows));
  for (const Series& series : all) {
    const std::size_t count = series.rows(rows), at_once = series.is_field ? 1 : buffered_rows;
    for (std::size_t first = 0; first < count; first += at_once)
      take(series.item,
           file.read_rows(series.item, first, std::min(at_once, count - first)).values);
  }
}

/// InputError unless the file at `path` can be read and holds what was written.
void check_rows(const std::filesystem::path& path, const RunLayout& layout, const RunRows& rows) {
  try_reading(path, [&] {
    std::map<std::string, CheckSum> sums;
    read_series(path, layout, rows, [&](const std::string& item, std::span<const double> values) {
      add(sums, item, values);
    });
    if (total(sums) != rows.check_sum)
      throw InputError(Place{path.string(), 0, 0, ""},
                       "damaged: its first " + std::to_string(rows.frames) +
                           " frames are not those that were written; start without --resume");
  });
}

}  // namespace

RunFile::RunFile(const std::filesystem::path& path, const RunLayout& layout, const RunStart& start)
    : path_(path), file_(create_file(path.string() + ".tmp", layout, start)), layout_(layout) {
  series_time_.reserve(buffered_rows);
  series_values_.resize(layout_.series.size());
  for (std::size_t q = 0; q < layout_.series.size(); ++q)
    series_values_[q].reserve(buffered_rows * layout_.series[q].components);
}

RunFile RunFile::resume(const std::filesystem::path& path, const RunLayout& layout,
                        const RunStart& start, const RunRows& rows) {
  check_rows(path, layout, rows);
  RunFile run(path, layout, start);
  read_series(path, layout, rows, [&](const std::string& item, std::span<const double> values) {
    run.append(item, values);
    if (item == "/frames/time")
      run.frame_times_.insert(run.frame_times_.end(), values.begin(), values.end());
  });
  run.series_rows_ = rows.series;
  run.flush();
  return run;
}

RunRows RunFile::rows() const {
  return {frame_times_.size(), series_rows_, total(sums_)};
}

void RunFile::append(const std::string& item, std::span<const double> values) {
  file_.append(item, values);
  add(sums_, item, values);
}

void RunFile::write_frame(double time, std::span<const std::span<const double>> fields) {
  assert(fields.size() == layout_.fields.size());
  for (std::size_t f = 0; f < fields.size(); ++f) {
    assert(fields[f].size() ==
           layout_.rows(layout_.fields[f]) * layout_.components(layout_.fields[f]));
    append(frames_of(layout_.fields[f]), fields[f]);
  }
  commit(std::span(&time, 1));
  frame_times_.push_back(time);
}

void RunFile::write_series(double time, std::span<const double> values) {
  if (series_time_.size() == buffered_rows) flush();
  series_time_.push_back(time);
  for (std::size_t q = 0; q < layout_.series.size(); ++q) {
    const auto own = values.first(layout_.series[q].components);
    series_values_[q].insert(series_values_[q].end(), own.begin(), own.end());
    values = values.subspan(own.size());
  }
  assert(values.empty());
  ++series_rows_;
}

void RunFile::commit(std::span<const double> frame_time) {
  for (std::size_t q = 0; q < layout_.series.size(); ++q) {
    append(series_of(layout_.series[q]), series_values_[q]);
    series_values_[q].clear();
  }
  // Two flushes: a single one may hand over `time` before the rest.
  file_.flush();
  append("/frames/time", frame_time);
  append("/series/time", series_time_);
  series_time_.clear();
  file_.flush();
  if (file_.path() != path_) file_.rename(path_);
}

void RunFile::flush() {
  commit({});
}

void RunFile::close() {
  flush();
  file_.close();
}

}  // namespace tlsph
