#pragma once
// What the tests of this room share: a directory of their own and children that may die.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace tlsph::test {

/// A directory that is gone when the test is over.
class TemporaryDirectory : public ::testing::Test {
 public:
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory() override { std::filesystem::remove_all(directory); }

 protected:
  TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "tlsph-io-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    directory = name;
  }

  std::filesystem::path directory;
};

/// Runs `body` in a child and returns its wait status; a child that returns from `body` exits with
/// 0, one that throws with 1. Nothing of the child is closed or flushed at its end.
template <class Body>
int in_child(Body body) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      body();
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Doubles of every size, signs and subnormals included, whose last bits all matter.
inline std::vector<double> awkward_doubles(std::size_t count, unsigned seed = 1) {
  std::vector<double> values = {0.0,
                                -0.0,
                                0.1,
                                1.0 / 3.0,
                                4.9406564584124654e-324,
                                -1.7976931348623157e308,
                                1e22,
                                1e23,
                                123456789012345678.0};
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0), exponent(-300.0, 300.0);
  while (values.size() < count)
    values.push_back(mantissa(random) * std::pow(10.0, exponent(random)));
  values.resize(count);
  return values;
}

/// The message of the exception that `body` throws, empty if it throws none.
template <class Error, class Body>
std::string message_of(Body body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace tlsph::test
