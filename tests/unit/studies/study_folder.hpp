#pragma once
/// \file
/// A folder for one test, with a scene in it.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace tlsph {

/// A bar that a smooth push sets in motion; elastic enough for a few hundred steps at most.
inline const std::string pushed_bar = R"(dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.1
[material]
law = "linear-elastic"
young = 1e6
poisson = 0.0
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
traction = { curve = "smooth-ramp", amplitude = 1e3, rise = 2e-2 }
[time]
end = 3e-2
)";
inline const std::string with_exact = "[reference]\nexact = \"bar-wave\"\n";
inline const std::string with_probes =
    "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\", \"pk1\"]\n"
    "[[probe]]\nname = \"root\"\nat = [0.0]\nrecord = [\"displacement\"]\n";

class StudyFolder : public testing::Test {
 protected:
  void SetUp() override {
    // A name of its own: builds of the project may be tested at the same time.
    std::string name = testing::TempDir() + "tlsph_study_XXXXXX";
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return folder / name;
  }
  static std::string read(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  std::filesystem::path folder;
};

}  // namespace tlsph
