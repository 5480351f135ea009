#pragma once
/// \file
/// Sparse matrices in files that SciPy, Octave and Julia read.

#include <filesystem>
#include <string>

#include "tlsph/core/types.hpp"
#include "tlsph/io/hdf5.hpp"

namespace tlsph {

/// Writes Matrix Market text, `coordinate real general`: every stored entry, stored zeros too, row
/// by row, with 17 significant digits, so that every double is read back bit for bit. Whole or not
/// at all; OutputError on failure.
void write_matrix_market(const std::filesystem::path& path, const SparseMatrix& matrix);

/// Adds the group /<name>/{indptr, indices, data, shape}, compressed rows as
/// scipy.sparse.csr_matrix takes them. A compressed matrix is written from where it is.
void write_compressed_rows(Hdf5File& file, const std::string& name, const SparseMatrix& matrix);

}  // namespace tlsph
