#pragma once
/// \file
/// Tables of numbers as comma-separated values: one header line, 17 significant digits, so that
/// every double is read back bit for bit.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tlsph {

/// Writes rows into a buffer and the buffer into the file when it is full, on `flush` and on
/// `close`. Failures throw OutputError naming the file.
class CsvWriter {
 public:
  /// Starts the table anew: whatever the file held is gone.
  CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& columns);
  /// Reopens a table and cuts it after `rows` rows, a last line without its end included. Throws
  /// InputError if the header is not that of `columns` or fewer rows are there.
  static CsvWriter resume(const std::filesystem::path& path,
                          const std::vector<std::string>& columns, std::size_t rows);
  CsvWriter(CsvWriter&& other) noexcept;
  CsvWriter(const CsvWriter&) = delete;
  CsvWriter& operator=(const CsvWriter&) = delete;
  CsvWriter& operator=(CsvWriter&&) = delete;
  /// Writes what is buffered; a failure is silent here, so call `close` where it matters.
  ~CsvWriter();

  /// One row of as many values as there are columns. Allocates no memory.
  void row(std::span<const double> values);
  /// Rows in the table, those that stood there on `resume` included.
  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Cuts the table after `rows` rows. Throws InputError if it has fewer.
  void truncate_after(std::size_t rows);
  void flush();
  void close();

 private:
  CsvWriter(std::filesystem::path path, std::size_t columns, int descriptor);

  std::filesystem::path path_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  int descriptor_ = -1;
  std::vector<char> buffer_;  // its size is the capacity, filled_ of it are in use
  std::size_t filled_ = 0;
};

/// `cell` as one field of a row: in quotes if it holds a comma, a quote or a line end.
std::string csv_field(const std::string& cell);
/// Texts as one row with its line end, each a field.
std::string csv_line(std::span<const std::string> cells);
/// A number as a field: 17 significant digits, nothing where it is no finite number.
std::string csv_number(double value);

}  // namespace tlsph
