#include "tlsph/io/matrix_market.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/io/files.hpp"

namespace tlsph {
namespace fs = std::filesystem;
namespace {

/// Text that goes to the file in pieces, so that a large matrix is not held twice.
class Writer {
 public:
  Writer(const fs::path& path, const char* format, const std::string& comment) : file_(path) {
    add(FMT_COMPILE("%%MatrixMarket matrix {} real general\n"), format);
    for (std::size_t begin = 0; begin < comment.size();) {
      const std::size_t end = std::min(comment.find('\n', begin), comment.size());
      add(FMT_COMPILE("% {}\n"), std::string_view(comment).substr(begin, end - begin));
      begin = end + 1;
    }
  }

  template <class Format, class... Values>
  void add(const Format& format, const Values&... values) {
    fmt::format_to(std::back_inserter(text_), format, values...);
    if (text_.size() > (1 << 20)) write();
  }

  void commit() {
    write();
    file_.commit();
  }

 private:
  void write() {
    file_.write(text_.data(), text_.size());
    text_.clear();
  }

  AsideFile file_;
  fmt::memory_buffer text_;
};

struct Entry {
  int row, column, line;
  double value;
};

/// Reads line by line and knows where it is.
class Reader {
 public:
  explicit Reader(const fs::path& path) : path_(path), file_(path) {
    if (!file_) throw InputError(path.string() + ": cannot be read");
  }

  /// The next line that is neither empty nor a comment, cut into words.
  bool next() {
    while (std::getline(file_, text_)) {
      ++line_;
      cut();
      if (!words_.empty() && (line_ == 1 || words_[0][0] != '%')) return true;
    }
    words_.clear();
    ++line_;
    return false;
  }

  [[noreturn]] void fail(const std::string& message, int line = 0) const {
    throw InputError(fmt::format("{}:{}: {}", path_.string(), line > 0 ? line : line_, message));
  }

  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] std::size_t size() const { return words_.size(); }
  [[nodiscard]] std::string lower(std::size_t word) const {
    std::string text(words_[word]);
    std::ranges::transform(text, text.begin(), [](unsigned char c) {
      return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    });
    return text;
  }

  template <class Number>
  [[nodiscard]] Number number(std::size_t word) const {
    std::string_view text = words_[word];
    if (text.starts_with('+')) text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      fail(fmt::format("\"{}\" is not {}", words_[word],
                       std::is_integral_v<Number> ? "an integer of this range" : "a number"));
    return value;
  }

  /// A one-based index into `length` rows or columns.
  [[nodiscard]] int index(std::size_t word, int length, const char* what) const {
    const int value = number<int>(word);
    if (value < 1 || value > length)
      fail(fmt::format("{} {} is outside the matrix, 1 to {} are allowed", what, value, length));
    return value - 1;
  }

 private:
  void cut() {
    words_.clear();
    for (std::size_t begin = 0;;) {
      begin = text_.find_first_not_of(" \t\r", begin);
      if (begin == std::string::npos) return;
      const std::size_t end = std::min(text_.find_first_of(" \t\r", begin), text_.size());
      words_.push_back(std::string_view(text_).substr(begin, end - begin));
      begin = end;
    }
  }

  fs::path path_;
  std::ifstream file_;
  std::string text_;
  std::vector<std::string_view> words_;
  int line_ = 0;
};

void refuse_repeated(std::vector<Entry> entries, const Reader& reader) {
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return std::tie(a.row, a.column, a.line) < std::tie(b.row, b.column, b.line);
  });
  const auto same = std::ranges::adjacent_find(entries, [](const Entry& a, const Entry& b) {
    return a.row == b.row && a.column == b.column;
  });
  if (same != entries.end())
    reader.fail(fmt::format("entry {} {} was given before, in line {}", same->row + 1,
                            same->column + 1, same->line),
                std::next(same)->line);
}

}  // namespace

void write_matrix_market(const fs::path& path, const SparseMatrix& matrix,
                         const std::string& comment) {
  Writer writer(path, "coordinate", comment);
  writer.add(FMT_COMPILE("{} {} {}\n"), matrix.rows(), matrix.cols(), matrix.nonZeros());
  for (Index row = 0; row < matrix.rows(); ++row)
    for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry)
      writer.add(FMT_COMPILE("{} {} {:.17g}\n"), row + 1, entry.col() + 1, entry.value());
  writer.commit();
}

void write_matrix_market_diagonal(const fs::path& path, const ScalarField& diagonal,
                                  const std::string& comment) {
  Writer writer(path, "coordinate", comment);
  writer.add(FMT_COMPILE("{0} {0} {0}\n"), diagonal.size());
  for (Index row = 0; row < diagonal.size(); ++row)
    writer.add(FMT_COMPILE("{0} {0} {1:.17g}\n"), row + 1, diagonal[row]);
  writer.commit();
}

void write_matrix_market_vector(const fs::path& path, const ScalarField& vector,
                                const std::string& comment) {
  Writer writer(path, "array", comment);
  writer.add(FMT_COMPILE("{} 1\n"), vector.size());
  for (double value : vector) writer.add(FMT_COMPILE("{:.17g}\n"), value);
  writer.commit();
}

SparseMatrix read_matrix_market(const fs::path& path) {
  Reader reader(path);
  reader.next();
  if (reader.size() != 5 || reader.lower(0) != "%%matrixmarket" || reader.lower(1) != "matrix")
    reader.fail("must be \"%%MatrixMarket matrix <format> <field> <symmetry>\"");
  const std::string format = reader.lower(2), field = reader.lower(3), symmetry = reader.lower(4);
  if (format != "coordinate" && format != "array")
    reader.fail("format must be coordinate or array");
  if (field != "real" && field != "integer") reader.fail("field must be real or integer");
  if (symmetry != "general" && symmetry != "symmetric")
    reader.fail("symmetry must be general or symmetric");
  const bool coordinate = format == "coordinate", symmetric = symmetry == "symmetric";

  if (!reader.next() || reader.size() != (coordinate ? 3 : 2))
    reader.fail(coordinate ? "rows, columns and number of entries are missing"
                           : "rows and columns are missing");
  const int rows = reader.number<int>(0), columns = reader.number<int>(1);
  if (rows < 0 || columns < 0) reader.fail("rows and columns must not be negative");
  if (symmetric && rows != columns) reader.fail("a symmetric matrix must be square");
  const long long count = coordinate  ? reader.number<long long>(2)
                          : symmetric ? 1LL * rows * (rows + 1) / 2
                                      : 1LL * rows * columns;

  std::vector<Entry> entries;
  const auto add = [&](int row, int column, double value) {
    entries.push_back({row, column, reader.line(), value});
    if (symmetric && row != column) entries.push_back({column, row, reader.line(), value});
  };
  int row = 0, column = 0;  // of an array, which goes down its columns
  for (long long k = 0; k < count; ++k) {
    if (!reader.next())
      reader.fail(fmt::format("{} entries are announced, {} are there", count, k));
    if (reader.size() != (coordinate ? 3 : 1))
      reader.fail(coordinate ? "must be \"row column value\"" : "must be one value");
    if (coordinate) {
      row = reader.index(0, rows, "row");
      column = reader.index(1, columns, "column");
    }
    add(row, column, reader.number<double>(coordinate ? 2 : 0));
    if (!coordinate && ++row == rows) row = symmetric ? ++column : (++column, 0);
  }
  if (reader.next()) reader.fail(fmt::format("{} entries are announced, here is one more", count));

  SparseMatrix matrix(rows, columns);
  std::vector<Eigen::Triplet<double, int>> triplets;
  triplets.reserve(entries.size());
  for (const auto& entry : entries) triplets.emplace_back(entry.row, entry.column, entry.value);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  if (matrix.nonZeros() != static_cast<Index>(entries.size())) refuse_repeated(entries, reader);
  return matrix;
}

}  // namespace tlsph
