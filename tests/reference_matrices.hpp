#pragma once
/// \file
/// Reads the reference operators of matrices/, which are derived independently of this program.

#include <Eigen/Core>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tlsph::reference {

inline const std::filesystem::path folder = std::filesystem::path(TLSPH_SOURCE_DIR) / "matrices";

/// Entries agree to this share of the largest: each is a sum of a few dozen rounded products, held
/// against one rounded once.
inline constexpr double tolerance = 1e-13;

/// One line of index.csv.
struct Entry {
  std::string file, layout, dimension, op, formulation, correction, kernel, support;

  /// Support radius [m]; all layouts have the spacing 1/4.
  [[nodiscard]] double radius() const { return std::stod(support) * 0.25; }
  /// 0 for G_x, 1 for G_y.
  [[nodiscard]] int direction() const { return op.back() == 'y' ? 1 : 0; }
};

inline void PrintTo(const Entry& entry, std::ostream* out) {
  *out << entry.file;
}

inline std::ifstream open(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return file;
}

/// The entries of index.csv that satisfy a predicate, in order.
template <class Predicate>
std::vector<Entry> index(Predicate wanted) {
  std::ifstream file = open(folder / "index.csv");
  std::vector<Entry> entries;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    Entry e;
    for (std::string* cell : {&e.file, &e.layout, &e.dimension, &e.op, &e.formulation,
                              &e.correction, &e.kernel, &e.support})
      std::getline(cells, *cell, ',');
    if (wanted(e)) entries.push_back(e);
  }
  return entries;
}

/// A Matrix Market file, sparse or dense, as a dense matrix.
inline Eigen::MatrixXd matrix(const std::string& name) {
  std::ifstream file = open(folder / name);
  std::string line;
  std::getline(file, line);
  const bool sparse = line.find(" coordinate ") != std::string::npos;
  while (std::getline(file, line) && line.starts_with('%')) {
  }
  std::istringstream size(line);
  Eigen::Index rows = 0, columns = 0, count = 0;
  size >> rows >> columns >> count;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(rows, columns);
  if (sparse) {
    double value = 0;
    for (Eigen::Index i = 0, j = 0; file >> i >> j >> value; --count) A(i - 1, j - 1) = value;
    if (count != 0) throw std::runtime_error(name + ": wrong number of entries");
  } else {
    for (double& value : A.reshaped())
      if (!(file >> value)) throw std::runtime_error(name + ": too few numbers");
  }
  return A;
}

/// Names of the parametrised tests: the file, in characters that GoogleTest accepts.
struct Name {
  template <class Info>
  std::string operator()(const Info& info) const {
    std::string name = info.param.file.substr(0, info.param.file.rfind('.'));
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
  }
};

}  // namespace tlsph::reference
