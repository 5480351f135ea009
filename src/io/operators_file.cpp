#include "tlsph/io/operators_file.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

void write_rows(Hdf5File& file, const std::string& name, Index rows, Index columns,
                std::span<const std::int32_t> indptr, std::span<const std::int32_t> indices,
                std::span<const double> data) {
  const std::string group = "/" + name;
  const std::int64_t shape[2] = {rows, columns};
  file.make_group(group);
  file.set_attribute(group, "format", "csr");
  file.write(group + "/indptr", indptr, {indptr.size()});
  file.write(group + "/indices", indices, {indices.size()});
  file.write(group + "/data", data, {data.size()});
  file.write(group + "/shape", std::span<const std::int64_t>(shape), {2});
}

}  // namespace

OperatorsFile::OperatorsFile(const std::filesystem::path& path, const CloudView& particles,
                             const CloudView& points)
    : file_(Hdf5File::create(path)) {
  write_cloud(file_, "/particles", particles);
  write_cloud(file_, "/points", points);
}

void OperatorsFile::write(const std::string& name, const SparseMatrix& matrix) {
  static_assert(sizeof(SparseMatrix::StorageIndex) == sizeof(std::int32_t));
  if (!matrix.isCompressed()) {
    SparseMatrix compressed = matrix;
    compressed.makeCompressed();
    return write(name, compressed);
  }
  const auto rows = static_cast<std::size_t>(matrix.rows());
  const auto entries = static_cast<std::size_t>(matrix.nonZeros());
  write_rows(file_, name, matrix.rows(), matrix.cols(), {matrix.outerIndexPtr(), rows + 1},
             {matrix.innerIndexPtr(), entries}, {matrix.valuePtr(), entries});
}

void OperatorsFile::write_diagonal(const std::string& name, const ScalarField& diagonal) {
  const auto count = static_cast<std::size_t>(diagonal.size());
  std::vector<std::int32_t> numbers(count + 1);
  std::iota(numbers.begin(), numbers.end(), 0);
  write_rows(file_, name, diagonal.size(), diagonal.size(), numbers,
             std::span(numbers).first(count), {diagonal.data(), count});
}

SparseMatrix read_operator(const Hdf5File& file, const std::string& name) {
  const std::string group = "/" + name;
  const auto shape = file.read_integers(group + "/shape").values;
  const auto indptr = file.read_integers(group + "/indptr").values;
  const auto indices = file.read_integers(group + "/indices").values;
  const auto data = file.read_doubles(group + "/data").values;
  const auto limit = std::numeric_limits<SparseMatrix::StorageIndex>::max();
  const bool fits =
      shape.size() == 2 && shape[0] >= 0 && shape[0] < limit && shape[1] >= 0 && shape[1] < limit &&
      static_cast<std::int64_t>(indptr.size()) == shape[0] + 1 && indptr.front() == 0 &&
      indptr.back() == static_cast<std::int64_t>(data.size()) && indices.size() == data.size() &&
      std::ranges::is_sorted(indptr) && std::ranges::all_of(indices, [&](std::int64_t column) {
        return column >= 0 && column < shape[1];
      });
  if (!fits)
    throw InputError(file.path().string() + ":" + group + ": is not a matrix in compressed rows");
  std::vector<Eigen::Triplet<double, int>> triplets;
  triplets.reserve(data.size());
  for (std::size_t row = 0; row + 1 < indptr.size(); ++row)
    for (auto k = static_cast<std::size_t>(indptr[row]);
         k < static_cast<std::size_t>(indptr[row + 1]); ++k)
      triplets.emplace_back(static_cast<int>(row), static_cast<int>(indices[k]), data[k]);
  SparseMatrix matrix(shape[0], shape[1]);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

}  // namespace tlsph
