#include "tlsph/io/checkpoint.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <limits>

#include "support.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using test::message_of;
using testing::HasSubstr;

class Checkpoints : public test::TemporaryDirectory {
 protected:
  std::filesystem::path path = directory / "checkpoint";
  std::vector<double> u = test::awkward_doubles(1001);
  double time = 0.1;

  [[nodiscard]] CheckpointView view() const {
    return {{{"u", u}, {"time", std::span(&time, 1)}, {"empty", {}}},
            {{"step", -7}, {"large", std::numeric_limits<std::int64_t>::max()}},
            {{"scene", "title = \"x\"\n"}, {"none", ""}}};
  }
};

TEST_F(Checkpoints, ComesBackBitForBit) {
  u[0] = std::bit_cast<double>(0x7FF8000000000123ULL);  // a NaN with something to say
  write_checkpoint(path, view());

  const Checkpoint read = read_checkpoint(path);

  const auto& values = read.array("u", u.size());
  for (std::size_t i = 0; i < u.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(values[i]), std::bit_cast<std::uint64_t>(u[i]));
  EXPECT_EQ(read.number("time"), time);
  EXPECT_TRUE(read.array("empty", 0).empty());
  EXPECT_EQ(read.integer("step"), -7);
  EXPECT_EQ(read.integer("large"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(read.text("scene"), "title = \"x\"\n");
  EXPECT_EQ(read.text("none"), "");
}

TEST_F(Checkpoints, NamesWhatIsMissing) {
  write_checkpoint(path, view());
  const Checkpoint read = read_checkpoint(path);

  EXPECT_THAT(message_of<InputError>([&] { (void)read.number("v"); }), HasSubstr("\"v\""));
  EXPECT_THAT(message_of<InputError>([&] { (void)read.array("u", 5); }), HasSubstr("1001"));
  EXPECT_THROW((void)read.integer("u"), InputError);
  EXPECT_THROW((void)read.text("u"), InputError);
  EXPECT_THROW(read_checkpoint(directory / "none"), InputError);
}

TEST_F(Checkpoints, EveryTornFileIsSeen) {
  u.resize(9);
  write_checkpoint(path, view());
  const std::string whole = test::read_text(path);

  for (std::size_t size = 0; size < whole.size(); ++size) {
    test::write_text(path, whole.substr(0, size));
    ASSERT_THROW(read_checkpoint(path), InputError) << size << " bytes of " << whole.size();
  }
  test::write_text(path, whole + "x");
  EXPECT_THROW(read_checkpoint(path), InputError);
}

TEST_F(Checkpoints, AChangedBitInAnyByteIsSeen) {
  u.resize(9);
  write_checkpoint(path, view());
  const std::string whole = test::read_text(path);

  for (std::size_t byte = 0; byte < whole.size(); ++byte) {
    std::string changed = whole;
    changed[byte] = static_cast<char>(changed[byte] ^ (1 << byte % 8));
    test::write_text(path, changed);
    ASSERT_THROW(read_checkpoint(path), InputError) << "byte " << byte;
  }
}

TEST_F(Checkpoints, OldOneStaysUntilTheNewOneIsWhole) {
  write_checkpoint(path, view());
  time = 0.2;
  std::filesystem::create_directory(directory / "checkpoint.tmp");  // nothing can be written aside

  EXPECT_THROW(write_checkpoint(path, view()), OutputError);

  EXPECT_EQ(read_checkpoint(path).number("time"), 0.1);
}

TEST_F(Checkpoints, FullDiskKeepsTheOldOne) {
  write_checkpoint(path, view());
  time = 0.2;
  std::filesystem::create_symlink("/dev/full", directory / "checkpoint.tmp");

  const auto message = message_of<OutputError>([&] { write_checkpoint(path, view()); });

  EXPECT_THAT(message, HasSubstr("No space left"));
  EXPECT_EQ(read_checkpoint(path).number("time"), 0.1);
}

}  // namespace
}  // namespace tlsph
