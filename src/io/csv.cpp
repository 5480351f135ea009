#include "tlsph/io/csv.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "system.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t capacity = 1 << 16;
constexpr std::size_t widest_value = 26;  // "-1.2345678901234567e-308," has 25

/// Bytes up to and including the end of line number `lines`; `found` counts the lines seen.
off_t end_of_line(int descriptor, std::size_t lines, std::size_t& found, const fs::path& path) {
  std::vector<char> block(capacity);
  off_t offset = 0;
  for (found = 0; found < lines;) {
    const ssize_t got = ::pread(descriptor, block.data(), block.size(), offset);
    if (got < 0) throw InputError(path.string() + ": cannot read: " + std::strerror(errno));
    if (got == 0) break;
    const char* next = block.data();
    const char* last = next + got;
    while (found < lines) {
      next =
          static_cast<const char*>(std::memchr(next, '\n', static_cast<std::size_t>(last - next)));
      if (next == nullptr) break;
      ++next, ++found;
    }
    offset += next != nullptr ? next - block.data() : got;
  }
  return offset;
}

}  // namespace

std::string csv_field(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (char c : cell) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

std::string csv_line(std::span<const std::string> cells) {
  assert(!cells.empty());
  std::string line;
  for (const std::string& cell : cells) line += csv_field(cell) + ',';
  line.back() = '\n';
  return line;
}

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "";
}

CsvWriter::CsvWriter(fs::path path, std::size_t columns, int descriptor)
    : path_(std::move(path)), columns_(columns), descriptor_(descriptor) {
  buffer_.resize(std::max(capacity, columns * widest_value));
}

CsvWriter::CsvWriter(const fs::path& path, const std::vector<std::string>& columns)
    : CsvWriter(path, columns.size(),
                ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) output_failed(path_, "create", errno);
  const std::string header = csv_line(columns);
  write_all(descriptor_, header.data(), header.size(), path_);
}

CsvWriter CsvWriter::resume(const fs::path& path, const std::vector<std::string>& columns,
                            std::size_t rows) {
  CsvWriter writer(path, columns.size(), ::open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (writer.descriptor_ < 0)
    throw InputError(path.string() + ": cannot open to go on with it: " + std::strerror(errno));
  const std::string header = csv_line(columns);
  std::string found(header.size(), '\0');
  const ssize_t got = ::pread(writer.descriptor_, found.data(), found.size(), 0);
  if (got != static_cast<ssize_t>(found.size()) || found != header)
    throw InputError(path.string() + ": its header is not that of this run, which is \"" +
                     header.substr(0, header.size() - 1) + "\"; start without --resume");
  writer.rows_ = rows;  // truncate_after proves it
  writer.truncate_after(rows);
  return writer;
}

CsvWriter::CsvWriter(CsvWriter&& other) noexcept
    : path_(std::move(other.path_)),
      columns_(other.columns_),
      rows_(other.rows_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)),
      filled_(std::exchange(other.filled_, 0)) {}

CsvWriter::~CsvWriter() {
  try {
    close();
  } catch (const OutputError&) {  // told by close() to those who call it
  }
}

void CsvWriter::row(std::span<const double> values) {
  assert(values.size() == columns_);
  if (filled_ + values.size() * widest_value > buffer_.size()) flush();
  char* next = buffer_.data() + filled_;
  for (double value : values) {
    // As printf's %.17g, at a quarter of its time.
    next = std::to_chars(next, next + widest_value, value, std::chars_format::general, 17).ptr;
    *next++ = ',';
  }
  next[-1] = '\n';
  filled_ = static_cast<std::size_t>(next - buffer_.data());
  ++rows_;
}

void CsvWriter::truncate_after(std::size_t rows) {
  flush();
  std::size_t found = 0;
  const off_t end = end_of_line(descriptor_, rows + 1, found, path_);
  if (found < rows + 1)
    throw InputError(fmt::format("{}: {} rows are needed to go on, {} are there", path_.string(),
                                 rows, found > 0 ? found - 1 : 0));
  if (::ftruncate(descriptor_, end) != 0) output_failed(path_, "shorten", errno);
  if (::lseek(descriptor_, end, SEEK_SET) < 0) output_failed(path_, "write at the end", errno);
  rows_ = rows;
}

void CsvWriter::flush() {
  // Forget the rows even if writing fails: the destructor must not try again and again.
  write_all(descriptor_, buffer_.data(), std::exchange(filled_, 0), path_);
}

void CsvWriter::close() {
  if (descriptor_ < 0) return;
  const int descriptor = descriptor_;
  try {
    flush();
  } catch (...) {
    ::close(descriptor);
    descriptor_ = -1;
    throw;
  }
  descriptor_ = -1;
  if (::close(descriptor) != 0) output_failed(path_, "close", errno);
}

}  // namespace tlsph
