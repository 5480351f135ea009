// A run that is killed at any of its writes leaves a file from which every finished frame can be
// read and from which the run can go on. The child's writes to the file go through the functions
// below, which end the child at the one that is chosen: before it, or in the middle of it.

#include <gmock/gmock.h>
#include <sys/mman.h>
#include <sys/syscall.h>

#include <csignal>

#include "run_fixture.hpp"

namespace {

enum class Moment { before, middle };

struct Killer {
  long writes_left = -1;  // negative: never
  Moment moment = Moment::before;

  bool strikes() { return writes_left >= 0 && writes_left-- == 0; }
} killer;

}  // namespace

// The HDF5 library writes by these two; a program's own definition is found before the C library's.
extern "C" ssize_t pwrite(int file, const void* bytes, size_t count, off_t offset) {
  if (killer.strikes()) {
    if (killer.moment == Moment::middle) ::syscall(SYS_pwrite64, file, bytes, count / 2, offset);
    ::raise(SIGKILL);
  }
  return ::syscall(SYS_pwrite64, file, bytes, count, offset);
}

extern "C" int ftruncate(int file, off_t length) noexcept {
  if (killer.strikes()) ::raise(SIGKILL);
  return static_cast<int>(::syscall(SYS_ftruncate, file, length));
}

namespace tlsph {
namespace {

constexpr std::size_t all_frames = 5, rows_a_frame = 3;

/// Memory that a killed child leaves to its parent.
struct Progress {
  std::size_t frames = 0;  // written and handed to the system
};

class KilledRun : public test::SmallRun, public testing::WithParamInterface<Moment> {
 public:
  KilledRun(const KilledRun&) = delete;
  KilledRun& operator=(const KilledRun&) = delete;
  ~KilledRun() override { ::munmap(progress, sizeof(Progress)); }

 protected:
  KilledRun()
      : progress(static_cast<Progress*>(::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE,
                                               MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {}

  static void write(RunFile& run, std::size_t first, Progress* progress) {
    for (std::size_t frame = first; frame < all_frames; ++frame) {
      for (std::size_t k = 0; k < rows_a_frame; ++k) write_row(run, rows_a_frame * frame + k);
      write_frame(run, frame);
      if (progress != nullptr) progress->frames = frame + 1;
    }
  }

  /// What a killed run must have left, and that it can go on to the end.
  void expect_whole_frames_and_go_on() {
    if (!std::filesystem::exists(path)) {
      ASSERT_EQ(progress->frames, 0u);
      return;
    }
    std::size_t frames = 0, rows = 0;
    {
      const Hdf5File file = Hdf5File::open_read_only(path);
      frames = file.rows("/frames/time");
      rows = file.rows("/series/time");
    }
    ASSERT_GE(frames, progress->frames);
    ASSERT_GE(rows, rows_a_frame * progress->frames);
    expect_run(frames, rows);
    RunFile run = resume(rows_of(progress->frames, rows_a_frame * progress->frames));
    write(run, progress->frames, nullptr);
    run.close();
    expect_run(all_frames, rows_a_frame * all_frames);
  }

  Progress* progress;
};

TEST_P(KilledRun, LeavesEveryFinishedFrameWhereverItIsKilled) {
  int killed = 0;
  for (bool ended = false; !ended; ++killed) {
    *progress = {};
    std::filesystem::remove(path);
    const int status = test::in_child([&] {
      killer = {killed, GetParam()};
      RunFile run = create();
      write(run, 0, progress);
      run.close();
    });
    ended = !WIFSIGNALED(status);
    ASSERT_TRUE(status == 0 || !ended);
    ASSERT_NO_FATAL_FAILURE(expect_whole_frames_and_go_on()) << "killed at write " << killed;
  }

  EXPECT_GT(killed, static_cast<int>(all_frames) * 4);  // else the functions above were not asked
}

TEST_P(KilledRun, LeavesEveryOldFrameWhereverItIsKilledWhileItResumes) {
  constexpr std::size_t kept = 2;
  int killed = 0;
  for (bool ended = false; !ended; ++killed) {
    {
      RunFile run = create();
      write(run, 0, nullptr);
      run.close();
    }
    *progress = {kept};
    const RunRows checkpoint = rows_of(kept, rows_a_frame * kept);
    const int status = test::in_child([&] {
      killer = {killed, GetParam()};
      RunFile run = resume(checkpoint);
      write(run, kept, progress);
      run.close();
    });
    ended = !WIFSIGNALED(status);
    ASSERT_TRUE(status == 0 || !ended);
    ASSERT_NO_FATAL_FAILURE(expect_whole_frames_and_go_on()) << "killed at write " << killed;
  }

  EXPECT_GT(killed, static_cast<int>(all_frames - kept) * 4);
}

INSTANTIATE_TEST_SUITE_P(Moments, KilledRun, testing::Values(Moment::before, Moment::middle),
                         [](const auto& test) {
                           return test.param == Moment::before ? "BeforeAWrite" : "InAWrite";
                         });

}  // namespace
}  // namespace tlsph
