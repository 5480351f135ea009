#pragma once
/// \file
/// operators.h5: every operator of a run as compressed rows, beside the particles and points it
/// maps between.
///
///     /<operator>/{indptr, indices, data, shape}    as scipy.sparse.csr_matrix takes them
///     /particles/{X, V, tag}    /points/{X, V}

#include <filesystem>
#include <string>

#include "tlsph/core/types.hpp"
#include "tlsph/io/cloud.hpp"
#include "tlsph/io/hdf5.hpp"

namespace tlsph {

class OperatorsFile {
 public:
  /// A new file in place of any old one.
  OperatorsFile(const std::filesystem::path& path, const CloudView& particles,
                const CloudView& points);
  /// Adds the group `name`. A compressed matrix is written from where it is.
  void write(const std::string& name, const SparseMatrix& matrix);
  /// Adds a diagonal matrix.
  void write_diagonal(const std::string& name, const ScalarField& diagonal);
  void close() { file_.close(); }

 private:
  Hdf5File file_;
};

/// The matrix in the group `name`; throws InputError if there is none or its arrays do not fit
/// together.
SparseMatrix read_operator(const Hdf5File& file, const std::string& name);

}  // namespace tlsph
