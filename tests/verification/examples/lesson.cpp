#include "lesson.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tlsph/io/hdf5.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph::lessons {
namespace {

std::filesystem::path new_folder() {
  std::string path = testing::TempDir() + "tlsph_lesson_XXXXXX";
  if (mkdtemp(path.data()) == nullptr) throw std::runtime_error("no temporary folder at " + path);
  return path;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
  return result;
}

VectorField<2> field(const Hdf5Array<double>& array) {
  return Eigen::Map<const VectorField<2>>(array.values.data(),
                                          static_cast<Index>(array.values.size() / 2), 2);
}

}  // namespace

double History::lowest() const {
  return *std::min_element(value.begin(), value.end());
}

double History::largest_magnitude() const {
  double largest = 0.0;
  for (const double x : value) largest = std::max(largest, std::abs(x));
  return largest;
}

Lesson::Lesson(const std::string& name, const std::vector<std::string>& overrides)
    : folder_(new_folder()) {
  const std::filesystem::path file =
      std::filesystem::path(TLSPH_SOURCE_DIR) / "examples" / (name + ".toml");
  RunOptions options;
  options.out = folder_;
  options.threads = 1;
  summary_ = run(read_scene(file, overrides), options);
}

Lesson::~Lesson() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

History Lesson::history(const std::string& column) const {
  std::ifstream file(folder_ / "probes.csv");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = cells(line);
  const auto found = std::find(header.begin(), header.end(), column);
  if (found == header.end()) throw std::runtime_error("probes.csv has no column " + column);
  const auto slot = static_cast<std::size_t>(found - header.begin());
  History history;
  while (std::getline(file, line)) {
    const std::vector<std::string> row = cells(line);
    // Not std::stod: it refuses the subnormal numbers far ahead of a front.
    history.time.push_back(std::strtod(row.at(0).c_str(), nullptr));
    history.value.push_back(std::strtod(row.at(slot).c_str(), nullptr));
  }
  return history;
}

VectorField<2> Lesson::nodes() const {
  return field(Hdf5File::open_read_only(folder_ / "run.h5").read_doubles("/particles/X"));
}

VectorField<2> Lesson::last_displacement() const {
  const Hdf5File file = Hdf5File::open_read_only(folder_ / "run.h5");
  const std::string item = "/frames/displacement";
  return field(file.read_rows(item, file.rows(item) - 1, 1));
}

}  // namespace tlsph::lessons
