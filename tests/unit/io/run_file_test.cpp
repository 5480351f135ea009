#include "tlsph/io/run_file.hpp"

#include <gmock/gmock.h>

#include "hdf5_reading.hpp"
#include "run_fixture.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using test::message_of;
using testing::ElementsAre;
using testing::HasSubstr;

class RunFiles : public test::SmallRun {};

class RunFilesInDimensions : public RunFiles, public testing::WithParamInterface<std::size_t> {};

TEST_P(RunFilesInDimensions, HoldEverythingWritten) {
  const std::size_t d = GetParam();
  RunFile run = create(d);
  for (std::size_t frame = 0; frame < 4; ++frame) {
    for (std::size_t row = 3 * frame; row < 3 * frame + 3; ++row) write_row(run, row, d);
    write_frame(run, frame, d);
  }
  write_row(run, 12, d);
  run.close();

  expect_run(4, 13, d);
  EXPECT_THAT(run.frame_times(), ElementsAre(0.0, 0.5, 1.0, 1.5));
  const Hdf5File file = Hdf5File::open_read_only(path);
  EXPECT_THAT(file.shape("/frames/displacement"), ElementsAre(4, 3, d));
  EXPECT_THAT(file.shape("/frames/pk1"), ElementsAre(4, 2, d * d));
  EXPECT_THAT(file.shape("/frames/damage"), ElementsAre(4, 2));
  EXPECT_THAT(file.shape("/series/kinetic"), ElementsAre(13));
  EXPECT_THAT(file.shape("/particles/X"), ElementsAre(3, d));
  EXPECT_THAT(file.shape("/points/V"), ElementsAre(2));
}

INSTANTIATE_TEST_SUITE_P(Dimensions, RunFilesInDimensions, testing::Values(1, 2));

TEST_P(RunFilesInDimensions, HoldTheNodesOfCells) {
  const std::size_t d = GetParam();
  RunFile(path, layout_of_cells(d), start_of_cells(d)).close();

  const Hdf5File file = Hdf5File::open_read_only(path);

  const auto cells = test::read_integers(file, "/points/cells");
  EXPECT_THAT(file.shape("/points/cells"), ElementsAre(2, d == 1 ? 2 : 4));
  if (d == 1)
    EXPECT_THAT(cells, ElementsAre(0, 1, 1, 2));
  else
    EXPECT_THAT(cells, ElementsAre(0, 1, 2, 2, 1, 2, 0, 0));
}

TEST_F(RunFiles, KeepCellsWhenResumed) {
  RunFile first = RunFile(path, layout_of_cells(), start_of_cells());
  write_frame(first, 0);
  const RunRows rows = first.rows();
  first.close();

  RunFile::resume(path, layout_of_cells(), start_of_cells(), rows).close();

  const Hdf5File file = Hdf5File::open_read_only(path);
  EXPECT_THAT(test::read_integers(file, "/points/cells"), ElementsAre(0, 1, 2, 2, 1, 2, 0, 0));
}

TEST_F(RunFiles, HoldNoCellsWherePointsAreNone) {
  create().close();

  EXPECT_FALSE(Hdf5File::open_read_only(path).exists("/points/cells"));
}

TEST_F(RunFiles, SayWhatTheyHold) {
  create().close();

  const Hdf5File file = Hdf5File::open_read_only(path);

  EXPECT_THAT(test::texts_attribute(file, "/scene", "text"), ElementsAre("title = \"x\""));
  EXPECT_THAT(test::texts_attribute(file, "/scene", "version"), ElementsAre("1.2.3"));
  EXPECT_THAT(test::texts_attribute(file, "/frames/pk1", "unit"), ElementsAre("Pa"));
  EXPECT_THAT(test::texts_attribute(file, "/frames/pk1", "site"), ElementsAre("points"));
  EXPECT_THAT(test::texts_attribute(file, "/frames/pk1", "components"),
              ElementsAre("xx", "xy", "yx", "yy"));
  EXPECT_THAT(test::texts_attribute(file, "/series/time", "unit"), ElementsAre("s"));
  EXPECT_THAT(test::texts_attribute(file, "/series/linear_momentum", "unit"),
              ElementsAre("kg m/s"));
  EXPECT_THAT(test::texts_attribute(file, "/particles/tag", "patches"),
              ElementsAre("left", "right"));
}

TEST_F(RunFiles, TakeTheirNameWithTheFirstFrame) {
  test::write_text(path, "an older run");
  RunFile run = create();
  EXPECT_EQ(test::read_text(path), "an older run");

  write_frame(run, 0);

  expect_run(1, 0);
  EXPECT_FALSE(std::filesystem::exists(directory / "run.h5.tmp"));
}

TEST_F(RunFiles, SeriesLongerThanTheBuffer) {
  RunFile run = create();
  for (std::size_t row = 0; row < 3000; ++row) write_row(run, row);
  run.close();

  expect_run(0, 3000);
}

// Frames and rows of the checkpoint.
class ResumedRunFiles : public RunFiles,
                        public testing::WithParamInterface<std::pair<std::size_t, std::size_t>> {};

TEST_P(ResumedRunFiles, HoldWhatAnUnbrokenRunHolds) {
  const auto [frames, rows] = GetParam();
  RunFile first = create();
  for (std::size_t frame = 0; frame < 6; ++frame) {
    write_row(first, 2 * frame);
    write_row(first, 2 * frame + 1);
    // Frames after the checkpoint differ, so that one left behind would be seen.
    write_frame(first, frame < frames ? frame : frame + 77);
  }
  first.close();
  const RunRows checkpoint = rows_of(frames, rows);

  RunFile second = resume(checkpoint);
  EXPECT_EQ(second.rows().frames, frames);
  EXPECT_EQ(second.rows().series, rows);
  EXPECT_EQ(second.rows().check_sum, checkpoint.check_sum);
  EXPECT_EQ(second.frame_times().size(), frames);
  for (std::size_t row = rows; row < 14; ++row) write_row(second, row);
  for (std::size_t frame = frames; frame < 8; ++frame) write_frame(second, frame);
  second.close();

  expect_run(8, 14);
}

INSTANTIATE_TEST_SUITE_P(Checkpoints, ResumedRunFiles,
                         testing::Values(std::pair{0, 0}, std::pair{1, 3}, std::pair{5, 10},
                                         std::pair{6, 12}));

TEST_F(RunFiles, ResumeRefusesOtherRuns) {
  RunFile run = create();
  write_frame(run, 0);
  const RunRows rows = run.rows();
  run.close();
  RunLayout other_size = layout(), other_field = layout();
  other_size.particles = 4;
  other_field.fields[0].name = "velocity";

  EXPECT_THROW(RunFile::resume(directory / "none.h5", layout(), start(), {}), InputError);
  EXPECT_THROW(RunFile::resume(path, other_field, start(), rows), InputError);
  EXPECT_THAT(message_of<InputError>([&] { RunFile::resume(path, other_size, start(), rows); }),
              HasSubstr("/frames/displacement"));
  EXPECT_THAT(message_of<InputError>([&] {
                resume({1, 0, rows.check_sum + 1});
              }),
              HasSubstr("damaged: its first 1 frames"));
  EXPECT_THAT(message_of<InputError>([&] {
                resume({2, 0, rows.check_sum});
              }),
              HasSubstr("2 rows are needed to go on, 1 are there"));
  expect_run(1, 0);
  EXPECT_FALSE(std::filesystem::exists(directory / "run.h5.tmp"));
}

}  // namespace
}  // namespace tlsph
