#pragma once
/// \file
/// run.h5, what a run leaves behind: the scene, the reference configuration, frames of full fields
/// and series of totals.
///
///     /scene                    attributes text (TOML, as run), file, version, dimension
///     /particles/{X, V, tag}    /points/{X, V}
///     /points/cells             M×2^d numbers of nodes, if the points are the cells between them
///     /particles/line           N lines of the file that listed the particles, if one did: they
///                               may stand in another order here
///     /particles/triangles      K×3 numbers of nodes, if triangles of them fill the body
///     /points/edges             M×4, if the points are their edges: nodes at the ends, on the left
///                               and, or −1, on the right
///     /frames/time              T [s]
///     /frames/<field>           T×N×d^rank, the components of a tensor in the order xx xy yx yy
///     /series/time              S [s]
///     /series/<quantity>        S, or S×c for a vector
///     /xdmf                     positions in space and vertex numbers, for run.xdmf only
///
/// Every data set says its unit. Each frame is handed to the system when it is written, `time`
/// last: a reader that takes as many rows as /frames/time (/series/time) has never sees half a
/// frame, even of a run that was killed. The file gets its name with the first frame; until then it
/// is `<name>.tmp`.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tlsph/core/field.hpp"
#include "tlsph/io/check_sum.hpp"
#include "tlsph/io/cloud.hpp"
#include "tlsph/io/hdf5.hpp"

namespace tlsph {

struct FrameField {
  std::string name;
  Site site = Site::particles;
  Rank rank = Rank::vector;
  std::string unit;
};

struct SeriesQuantity {
  std::string name;
  std::size_t components = 1;
  std::string unit;
};

/// The shape of a run's output; the same for the run and its resumption.
struct RunLayout {
  std::size_t dimension = 2;
  std::size_t particles = 0, points = 0;
  std::vector<FrameField> fields;
  std::vector<SeriesQuantity> series;
  bool points_are_cells = false;  ///< each point stands for a cell of 2^d nodes
  std::size_t triangles = 0;      ///< of nodes, that fill the body
  bool points_are_nodes = false;  ///< each point is the node of its number

  /// Rows of a field: particles or points.
  [[nodiscard]] std::size_t rows(const FrameField& field) const;
  /// Components of a field: d^rank.
  [[nodiscard]] std::size_t components(const FrameField& field) const;
};

/// What is written once, at the start.
struct RunStart {
  std::string scene_file, scene_text, version;
  CloudView particles, points;
  std::span<const std::int32_t> cells =
      {};  ///< points×2^d nodes, counter-clockwise; empty if points are no cells
  std::span<const std::int32_t> triangles = {};  ///< triangles×3 nodes, counter-clockwise
  std::span<const std::int32_t> edges = {};      ///< points×4; empty if points are no edges
  std::span<const std::int32_t> line = {};       ///< particles; empty if no file lists them
};

/// What a run has written so far.
struct RunRows {
  std::size_t frames = 0, series = 0;
  std::uint64_t check_sum = 0;  ///< of all their values
};

class RunFile {
 public:
  /// A new file, complete but for its frames; it replaces an old one with the first frame or flush.
  /// Write the series row of t = 0 before that.
  RunFile(const std::filesystem::path& path, const RunLayout& layout, const RunStart& start);
  /// A file that goes on after the first `rows` of the one at `path`, and replaces it. They are
  /// copied into a new one: to shorten series in place would put all of them at risk while it
  /// lasts. Throws InputError if the old file holds fewer, is not of this layout, or not what was
  /// written; it is left as it is then.
  static RunFile resume(const std::filesystem::path& path, const RunLayout& layout,
                        const RunStart& start, const RunRows& rows);

  /// Adds a frame at `time` [s]; `fields` are the row-major arrays in the order of the layout. They
  /// are written from where they are, not copied.
  void write_frame(double time, std::span<const std::span<const double>> fields);
  /// Adds a row to every series; `values` are the components of all quantities in the order of the
  /// layout, one after the other. Kept in memory until the buffer is full or the next flush or
  /// frame; in between it allocates nothing.
  void write_series(double time, std::span<const double> values);
  /// What `flush` has handed over.
  [[nodiscard]] RunRows rows() const;
  /// Times of the frames so far [s].
  [[nodiscard]] const std::vector<double>& frame_times() const { return frame_times_; }
  void flush();
  void close();

 private:
  void append(const std::string& item, std::span<const double> values);
  void commit(std::span<const double> frame_time);

  std::filesystem::path path_;  // the name it is to have
  Hdf5File file_;
  RunLayout layout_;
  std::size_t series_rows_ = 0;
  std::map<std::string, CheckSum> sums_;  // of every series in the file
  std::vector<double> frame_times_;
  std::vector<double> series_time_;                 // pending rows
  std::vector<std::vector<double>> series_values_;  // the same, a vector per quantity
};

}  // namespace tlsph
