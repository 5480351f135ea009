#pragma once
/// \file
/// Sparse matrices and vectors as Matrix Market text, which SciPy, Octave and Julia read. 17
/// significant digits, so that every double is read back bit for bit.

#include <filesystem>
#include <string>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// Writes `coordinate real general`: every stored entry, stored zeros too, row by row. `comment`
/// becomes % lines below the header. Whole or not at all; OutputError on failure.
void write_matrix_market(const std::filesystem::path& path, const SparseMatrix& matrix,
                         const std::string& comment = "");
/// Writes the square matrix with `diagonal` on its diagonal and nothing else.
void write_matrix_market_diagonal(const std::filesystem::path& path, const ScalarField& diagonal,
                                  const std::string& comment = "");
/// Writes a column vector as `array real general`.
void write_matrix_market_vector(const std::filesystem::path& path, const ScalarField& vector,
                                const std::string& comment = "");

/// Reads `coordinate` or `array`, `real` or `integer`, `general` or `symmetric` (both triangles are
/// filled in). Throws InputError with file and line for anything else, entries outside the matrix,
/// entries given twice, and a wrong number of entries.
SparseMatrix read_matrix_market(const std::filesystem::path& path);

}  // namespace tlsph
