#pragma once
/// \file
/// HDF5 files: named arrays of numbers with attributes, and series that grow row by row.
/// The only door to the HDF5 library, whose types stay behind it. Default file format, so that
/// every reader opens the files; arrays are row-major.
///
/// A failure to create, write or flush is an OutputError, a failure to open or read an InputError;
/// both name the file, the path in it and the innermost reason HDF5 gives.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <ranges>
#include <span>
#include <string>
#include <vector>

namespace tlsph {

/// Lengths of an array along its directions; empty for a single value.
using Extents = std::vector<std::size_t>;

/// A whole array read from a file.
template <class Value>
struct Hdf5Array {
  Extents shape;
  std::vector<Value> values;
};

/// Part of a data set, `count` entries from `start` on along each of its directions. `file` is
/// relative to the file that speaks of it.
struct Hdf5Part {
  std::string file, item;
  Extents shape, start, count;
};

class Hdf5File {
 public:
  /// A new file in place of any old one.
  static Hdf5File create(const std::filesystem::path& path);
  static Hdf5File open_read_only(const std::filesystem::path& path);
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;
  /// Closes; a failure is silent here, so call `close` where it matters.
  ~Hdf5File();

  [[nodiscard]] const std::filesystem::path& path() const;
  /// Whether `item` is a group or data set of the file.
  [[nodiscard]] bool exists(const std::string& item) const;
  /// Names in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> names(const std::string& group) const;

  // Groups on the way to an item are made as needed; an item that is there already is an error.
  void make_group(const std::string& item);
  /// `values` are doubles or integers of 32 or 64 bits; a `unit` becomes an attribute.
  template <std::ranges::contiguous_range Values>
  void write(const std::string& item, const Values& values, const Extents& shape,
             const std::string& unit = "") {
    write_array(item, std::span<const std::ranges::range_value_t<Values>>(values), shape);
    if (!unit.empty()) set_attribute(item, "unit", unit);
  }

  /// A virtual data set of doubles: its first `count` entries along each direction are those of
  /// `part`, which need not be there yet, all others 0.
  void write_view(const std::string& item, const Extents& shape, const Extents& count,
                  const Hdf5Part& part);

  // An attribute of a group or data set; an old one of that name is replaced.
  void set_attribute(const std::string& item, const std::string& name, const std::string& text);
  void set_attribute(const std::string& item, const std::string& name, std::int64_t value);
  void set_attribute(const std::string& item, const std::string& name,
                     const std::vector<std::string>& texts);

  /// A series: 0 rows, each an array of doubles of `row_shape`. Rows are stored in chunks of
  /// `chunk_rows` (0: as many as make 256 KiB, 1 to 64).
  void create_series(const std::string& item, const Extents& row_shape, std::size_t chunk_rows = 0);
  /// Adds rows, `values` holding a whole number of them. Goes from `values` to the file, no copy.
  void append(const std::string& item, std::span<const double> values);
  /// Hands all that was written to the system: from here on it outlives the program, however it
  /// ends.
  void flush();
  /// Gives the file another name, in place of any file of that name, while it is open.
  void rename(const std::filesystem::path& path);
  /// Flushes and closes. The object can only be destroyed or assigned to afterwards.
  void close();

  /// First length of the shape of `item`.
  [[nodiscard]] std::size_t rows(const std::string& item) const;
  [[nodiscard]] Extents shape(const std::string& item) const;
  /// `count` rows of doubles from row `first` on; the shape is that of these rows.
  [[nodiscard]] Hdf5Array<double> read_rows(const std::string& item, std::size_t first,
                                            std::size_t count) const;
  /// All rows.
  [[nodiscard]] Hdf5Array<double> read_doubles(const std::string& item) const {
    return read_rows(item, 0, rows(item));
  }

 private:
  struct Open;
  explicit Hdf5File(std::unique_ptr<Open> open);
  template <class Value>
  void write_array(const std::string& item, std::span<const Value> values, const Extents& shape);
  std::unique_ptr<Open> open_;
};

}  // namespace tlsph
