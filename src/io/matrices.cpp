#include "tlsph/io/matrices.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <iterator>
#include <span>

#include "tlsph/io/files.hpp"

namespace tlsph {

void write_matrix_market(const std::filesystem::path& path, const SparseMatrix& matrix) {
  AsideFile file(path);
  fmt::memory_buffer text;
  // In pieces, so that a large matrix is not held twice.
  const auto write = [&] {
    file.write(text.data(), text.size());
    text.clear();
  };
  const auto add = [&](const auto& format, const auto&... values) {
    fmt::format_to(std::back_inserter(text), format, values...);
    if (text.size() > (1 << 20)) write();
  };
  add(FMT_COMPILE("%%MatrixMarket matrix coordinate real general\n{} {} {}\n"), matrix.rows(),
      matrix.cols(), matrix.nonZeros());
  for (Index row = 0; row < matrix.rows(); ++row)
    for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry)
      add(FMT_COMPILE("{} {} {:.17g}\n"), row + 1, entry.col() + 1, entry.value());
  write();
  file.commit();
}

void write_compressed_rows(Hdf5File& file, const std::string& name, const SparseMatrix& matrix) {
  static_assert(sizeof(SparseMatrix::StorageIndex) == sizeof(std::int32_t));
  if (!matrix.isCompressed()) {
    SparseMatrix compressed = matrix;
    compressed.makeCompressed();
    return write_compressed_rows(file, name, compressed);
  }
  const std::string group = "/" + name;
  const auto rows = static_cast<std::size_t>(matrix.rows());
  const auto entries = static_cast<std::size_t>(matrix.nonZeros());
  const std::array<std::int64_t, 2> shape = {matrix.rows(), matrix.cols()};
  file.make_group(group);
  file.set_attribute(group, "format", "csr");
  file.write(group + "/indptr", std::span(matrix.outerIndexPtr(), rows + 1), {rows + 1});
  file.write(group + "/indices", std::span(matrix.innerIndexPtr(), entries), {entries});
  file.write(group + "/data", std::span(matrix.valuePtr(), entries), {entries});
  file.write(group + "/shape", shape, {2});
}

}  // namespace tlsph
