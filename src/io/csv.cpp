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
#include <fstream>
#include <utility>

#include "system.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t capacity = 1 << 16;
constexpr std::size_t widest_value = 26;  // "-1.2345678901234567e-308," has 25

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
  std::ifstream file(path, std::ios::binary);
  const std::string header = csv_line(columns);
  CheckSum sum;
  std::size_t lines = 0;
  // A last line without its end does not count.
  for (std::string line; lines <= rows.count && std::getline(file, line) && !file.eof(); ++lines) {
    line += '\n';
    if (lines == 0 && line != header) break;
    if (lines > 0) sum.add(line.data(), line.size());
    writer.end_ += static_cast<long long>(line.size());
  }
  if (file.bad()) throw InputError(place, std::string("cannot read: ") + std::strerror(errno));
  if (lines == 0)
    throw InputError(place, "its header is not that of this run, which is \"" +
                                header.substr(0, header.size() - 1) + "\"; start without --resume");
  if (lines <= rows.count)
    throw InputError(
        place, fmt::format("{} rows are needed to go on, {} are there", rows.count, lines - 1));
  if (sum.value() != rows.sum.value())
    throw InputError(place, fmt::format("damaged: the first {} rows are not those that were "
                                        "written; start without --resume",
                                        rows.count));
  writer.rows_ = rows;
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
