#pragma once
// A small run in one or two dimensions whose values tell where they belong.

#include <array>

#include "support.hpp"
#include "tlsph/io/run_file.hpp"

namespace tlsph::test {

class SmallRun : public TemporaryDirectory {
 protected:
  std::filesystem::path path = directory / "run.h5";

  static RunLayout layout(std::size_t dimension = 2) {
    return {dimension,
            3,
            2,
            {{"displacement", Site::particles, Rank::vector, "m"},
             {"pk1", Site::points, Rank::tensor, "Pa"},
             {"damage", Site::points, Rank::scalar, "1"}},
            {{"kinetic", 1, "J"}, {"linear_momentum", dimension, "kg m/s"}}};
  }

  RunFile create(std::size_t dimension = 2) const {
    return RunFile(path, layout(dimension), start(dimension));
  }
  /// Of a run that has written so much.
  RunRows rows_of(std::size_t frames, std::size_t rows) const {
    RunFile run = RunFile(directory / "same.h5", layout(), start());
    for (std::size_t row = 0; row < rows; ++row) write_row(run, row);
    for (std::size_t frame = 0; frame < frames; ++frame) write_frame(run, frame);
    run.flush();
    return run.rows();
  }
  RunFile resume(const RunRows& rows) const {
    return RunFile::resume(path, layout(), start(), rows);
  }

  static RunStart start(std::size_t dimension = 2) {
    static const std::vector<double> X{0.0, 0.25, 0.5, 0.75, 1.0, 1.25}, V(3, 1.0), point_V(2, 1.5);
    static const std::vector<std::int64_t> tag{1, 2, 3};
    return {"s.toml",
            "title = \"x\"",
            "1.2.3",
            {dimension, std::span(X).first(3 * dimension), V, tag, {"left", "right"}},
            {dimension, std::span(X).first(2 * dimension), point_V, {}, {}}};
  }

  /// The same run, its two points being cells of nodes: 0-1 and 1-2, or 0-1-2-2 and 1-2-0-0.
  static RunLayout layout_of_cells(std::size_t dimension = 2) {
    RunLayout result = layout(dimension);
    result.points_are_cells = true;
    return result;
  }
  static RunStart start_of_cells(std::size_t dimension = 2) {
    static const std::vector<std::int32_t> line{0, 1, 1, 2}, plane{0, 1, 2, 2, 1, 2, 0, 0};
    RunStart result = start(dimension);
    result.cells = dimension == 1 ? line : plane;
    return result;
  }

  /// The values of field `f` in frame `frame`.
  static std::vector<double> field(std::size_t f, std::size_t frame, std::size_t dimension = 2) {
    const RunLayout shape = layout(dimension);
    std::vector<double> values(shape.rows(shape.fields[f]) * shape.components(shape.fields[f]));
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = 1000.0 * static_cast<double>(frame) + 100.0 * static_cast<double>(f) +
                  static_cast<double>(i) / 3.0;
    return values;
  }

  static void write_frame(RunFile& run, std::size_t frame, std::size_t dimension = 2) {
    const std::array values{field(0, frame, dimension), field(1, frame, dimension),
                            field(2, frame, dimension)};
    const std::array<std::span<const double>, 3> spans{values[0], values[1], values[2]};
    run.write_frame(0.5 * static_cast<double>(frame), spans);
  }

  static void write_row(RunFile& run, std::size_t row, std::size_t dimension = 2) {
    std::vector<double> values(1 + dimension);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = 10.0 * static_cast<double>(row) + static_cast<double>(i);
    run.write_series(0.125 * static_cast<double>(row), values);
  }

  /// What `frames` frames and `rows` rows must have left behind.
  void expect_run(std::size_t frames, std::size_t rows, std::size_t dimension = 2) const {
    const Hdf5File file = Hdf5File::open_read_only(path);
    ASSERT_EQ(file.rows("/frames/time"), frames);
    ASSERT_EQ(file.rows("/series/time"), rows);
    const RunLayout shape = layout(dimension);
    for (std::size_t f = 0; f < shape.fields.size(); ++f) {
      const std::string item = "/frames/" + shape.fields[f].name;
      ASSERT_GE(file.rows(item), frames);
      for (std::size_t frame = 0; frame < frames; ++frame)
        ASSERT_EQ(file.read_rows(item, frame, 1).values, field(f, frame, dimension))
            << item << " " << frame;
    }
    const auto times = file.read_doubles("/frames/time").values;
    for (std::size_t frame = 0; frame < frames; ++frame)
      ASSERT_EQ(times[frame], 0.5 * static_cast<double>(frame));
    const auto series_times = file.read_doubles("/series/time").values;
    const auto kinetic = file.read_rows("/series/kinetic", 0, rows).values;
    const auto momentum = file.read_rows("/series/linear_momentum", 0, rows).values;
    for (std::size_t row = 0; row < rows; ++row) {
      ASSERT_EQ(series_times[row], 0.125 * static_cast<double>(row));
      ASSERT_EQ(kinetic[row], 10.0 * static_cast<double>(row));
      for (std::size_t a = 0; a < dimension; ++a)
        ASSERT_EQ(momentum[row * dimension + a],
                  10.0 * static_cast<double>(row) + 1.0 + static_cast<double>(a));
    }
  }
};

}  // namespace tlsph::test
