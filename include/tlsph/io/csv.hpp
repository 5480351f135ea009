#pragma once
/// \file
/// Tables of numbers as comma-separated values: one header line, 17 significant digits, so that
/// every double is read back bit for bit.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tlsph/io/check_sum.hpp"

namespace tlsph {

/// The rows of a table so far.
struct CsvRows {
  std::size_t count = 0;
  CheckSum sum;  ///< of their text, row by row
};

/// Writes rows into a buffer and the buffer into the file when it is full, on `flush` and on
/// `close`. Failures throw OutputError naming the file.
class CsvWriter {
 public:
  /// Starts the table anew: whatever the file held is gone.
  CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& columns);
  /// Reopens a table and cuts it after `rows`, a last line without its end included. Throws
  /// InputError if the header is not that of `columns`, or rows are missing or not as they were.
  static CsvWriter resume(const std::filesystem::path& path,
                          const std::vector<std::string>& columns, const CsvRows& rows);
  /// Throws what `resume` would; changes nothing.
  static void check(const std::filesystem::path& path, const std::vector<std::string>& columns,
                    const CsvRows& rows);
  CsvWriter(CsvWriter&& other) noexcept;
  CsvWriter(const CsvWriter&) = delete;
  CsvWriter& operator=(const CsvWriter&) = delete;
  CsvWriter& operator=(CsvWriter&&) = delete;
  /// Writes what is buffered; a failure is silent here, so call `close` where it matters.
  ~CsvWriter();

  /// One row of as many values as there are columns. Allocates no memory.
  void row(std::span<const double> values);
  /// Rows in the table, those that stood there on `resume` included.
  [[nodiscard]] const CsvRows& rows() const { return rows_; }
  void flush();
  void close();

 private:
  CsvWriter(std::filesystem::path path, std::size_t columns, int descriptor);
  static CsvWriter open(const std::filesystem::path& path, const std::vector<std::string>& columns,
                        const CsvRows& rows);

  std::filesystem::path path_;
  std::size_t columns_ = 0;
  CsvRows rows_;
  long long end_ = 0;  // bytes of what it begins with on resume
  int descriptor_ = -1;
  std::vector<char> buffer_;  // its size is the capacity, filled_ of it are in use
  std::size_t filled_ = 0;
};

/// Texts as one row with its line end, each a field: in quotes if it holds a comma, a quote or a
/// line end.
std::string csv_line(std::span<const std::string> cells);
/// A number as a field: 17 significant digits, nothing where it is no finite number.
std::string csv_number(double value);

}  // namespace tlsph
