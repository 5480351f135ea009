#include "tlsph/io/files.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include "support.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

namespace fs = std::filesystem;
using test::in_child;
using test::message_of;
using testing::HasSubstr;

class Files : public test::TemporaryDirectory {};

TEST_F(Files, OutputDirectoryIsMadeWithItsParentsAndLeftEmpty) {
  make_output_directory(directory / "a" / "b");
  make_output_directory(directory / "a" / "b");  // once more is no error

  EXPECT_TRUE(fs::is_directory(directory / "a" / "b"));
  EXPECT_TRUE(fs::is_empty(directory / "a" / "b"));
}

TEST_F(Files, OutputDirectoryBelowAFileIsRefused) {
  test::write_text(directory / "file", "x");

  EXPECT_THROW(make_output_directory(directory / "file"), OutputError);
  const auto message =
      message_of<OutputError>([&] { make_output_directory(directory / "file" / "out"); });

  EXPECT_THAT(message, HasSubstr((directory / "file" / "out").string()));
}

TEST_F(Files, OutputDirectoryWithoutPermissionIsRefused) {
  fs::create_directory(directory / "locked");
  fs::permissions(directory / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  fs::permissions(directory, fs::perms::others_exec | fs::perms::others_read,
                  fs::perm_options::add);

  const int status = in_child([&] {
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(3);  // root may write everywhere
    const auto message =
        message_of<OutputError>([&] { make_output_directory(directory / "locked"); });
    ::_exit(message.find("locked") != std::string::npos ? 0 : 2);
  });
  fs::permissions(directory / "locked", fs::perms::owner_all);

  EXPECT_EQ(status, 0);
}

TEST_F(Files, TextReplacesTheOldOneAndLeavesNothingBeside) {
  write_text_file(directory / "t", "first");
  write_text_file(directory / "t", "second", Durability::machine);

  EXPECT_EQ(test::read_text(directory / "t"), "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory), fs::directory_iterator()), 1);
}

TEST_F(Files, TextThatIsNotCommittedLeavesTheOldOne) {
  write_text_file(directory / "t", "old");

  {
    AsideFile file(directory / "t");
    file.write("half of the new");
  }

  EXPECT_EQ(test::read_text(directory / "t"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory), fs::directory_iterator()), 1);
}

TEST_F(Files, FullDiskIsAnOutputErrorNamingFileAndReason) {
  fs::create_symlink("/dev/full", directory / "full.tmp");  // where the text is written first

  const auto message =
      message_of<OutputError>([&] { write_text_file(directory / "full", "text"); });

  EXPECT_THAT(message, HasSubstr((directory / "full").string()));
  EXPECT_THAT(message, HasSubstr("No space left"));
  EXPECT_FALSE(fs::exists(directory / "full"));
}

TEST_F(Files, DirectoryIsLockedAgainstAnotherRunOnly) {
  {
    const DirectoryLock lock(directory);
    const auto message = message_of<OutputError>([&] { DirectoryLock second(directory); });
    EXPECT_THAT(message, HasSubstr("another run"));
  }

  EXPECT_NO_THROW(DirectoryLock third(directory));
  EXPECT_TRUE(fs::is_empty(directory));
}

TEST_F(Files, LockDiesWithItsProcess) {
  const int status = in_child([&] {
    new DirectoryLock(directory);
    ::raise(SIGKILL);
  });

  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_NO_THROW(DirectoryLock again(directory));
}

}  // namespace
}  // namespace tlsph
