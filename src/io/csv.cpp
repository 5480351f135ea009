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

/// The first lines of a table: how many, their bytes, the check sum of all but the header.
struct Lines {
  std::size_t count = 0;
  off_t end = 0;
  CheckSum sum;
};

Lines read_lines(int descriptor, std::size_t most, const fs::path& path) {
  std::vector<char> block(capacity);
  std::string line;
  Lines lines;
  while (lines.count < most) {
    const off_t begin = lines.end + static_cast<off_t>(line.size());
    const ssize_t got = ::pread(descriptor, block.data(), block.size(), begin);
    if (got < 0)
      throw InputError(Place{path.string(), 0, 0, ""},
                       std::string("cannot read: ") + std::strerror(errno));
    if (got == 0) break;
    std::string_view left(block.data(), static_cast<std::size_t>(got));
    while (lines.count < most) {
      const std::size_t end = left.find('\n');
      line += left.substr(0, end == std::string_view::npos ? end : end + 1);
      if (end == std::string_view::npos) break;
      left.remove_prefix(end + 1);
      if (lines.count++ > 0) lines.sum.add(line.data(), line.size());
      lines.end += static_cast<off_t>(line.size());
      line.clear();
    }
  }
  return lines;
}

std::string csv_field(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (char c : cell) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

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

CsvWriter CsvWriter::open(const fs::path& path, const std::vector<std::string>& columns,
                          const CsvRows& rows) {
  const Place place{path.string(), 0, 0, ""};
  CsvWriter writer(path, columns.size(), ::open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (writer.descriptor_ < 0)
    throw InputError(place, std::string("cannot open to go on with it: ") + std::strerror(errno));
  const std::string header = csv_line(columns);
  std::string found(header.size(), '\0');
  const ssize_t got = ::pread(writer.descriptor_, found.data(), found.size(), 0);
  if (got != static_cast<ssize_t>(found.size()) || found != header)
    throw InputError(place, "its header is not that of this run, which is \"" +
                                header.substr(0, header.size() - 1) + "\"; start without --resume");
  const Lines lines = read_lines(writer.descriptor_, rows.count + 1, path);
  if (lines.count < rows.count + 1)
    throw InputError(place, fmt::format("{} rows are needed to go on, {} are there", rows.count,
                                        lines.count - 1));
  if (lines.sum.value() != rows.sum.value())
    throw InputError(place, fmt::format("damaged: the first {} rows are not those that were "
                                        "written; start without --resume",
                                        rows.count));
  writer.rows_ = rows;
  writer.end_ = lines.end;
  return writer;
}

CsvWriter CsvWriter::resume(const fs::path& path, const std::vector<std::string>& columns,
                            const CsvRows& rows) {
  CsvWriter writer = open(path, columns, rows);
  if (::ftruncate(writer.descriptor_, writer.end_) != 0) output_failed(path, "shorten", errno);
  if (::lseek(writer.descriptor_, writer.end_, SEEK_SET) < 0)
    output_failed(path, "write at the end", errno);
  return writer;
}

void CsvWriter::check(const fs::path& path, const std::vector<std::string>& columns,
                      const CsvRows& rows) {
  (void)open(path, columns, rows);
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
  char* const begin = buffer_.data() + filled_;
  char* next = begin;
  for (double value : values) {
    // As printf's %.17g, at a quarter of its time.
    next = std::to_chars(next, next + widest_value, value, std::chars_format::general, 17).ptr;
    *next++ = ',';
  }
  next[-1] = '\n';
  filled_ = static_cast<std::size_t>(next - buffer_.data());
  ++rows_.count;
  rows_.sum.add(begin, static_cast<std::size_t>(next - begin));
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
