#pragma once
/// \file
/// What the parts of Hdf5File share: owned HDF5 identifiers and errors with their reason. Not part
/// of the interface.

#include <hdf5.h>

#include <map>
#include <string>
#include <utility>

#include "tlsph/io/hdf5.hpp"

namespace tlsph {

/// An HDF5 identifier that is closed once.
class Hdf5Id {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Id() = default;
  Hdf5Id(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;
  Hdf5Id(Hdf5Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Id& operator=(Hdf5Id&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Id() { release(); }

  operator hid_t() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }
  /// Closes now. The library forgets the reason of a failure with its next call, so it is kept here
  /// over the closing of what the failed function leaves behind.
  herr_t release() {
    if (id_ < 0) return 0;
    const hid_t reasons = H5Eget_num(H5E_DEFAULT) > 0 ? H5Eget_current_stack() : -1;
    const herr_t status = close_(std::exchange(id_, -1));
    if (reasons >= 0) H5Eset_current_stack(reasons);
    return status;
  }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// A series kept open between appends.
struct Hdf5Series {
  Hdf5Id dataset;
  std::vector<hsize_t> extent;  ///< rows, then the shape of a row
  [[nodiscard]] std::size_t row_size() const;
};

struct Hdf5File::Open {
  std::filesystem::path path;
  Hdf5Id file;
  std::map<std::string, Hdf5Series> series;

  /// `types` are those in the file and in memory.
  void set_attribute(const std::string& item, const std::string& name, const void* values,
                     std::pair<hid_t, hid_t> types, const Extents& shape);
  void set_texts(const std::string& item, const std::string& name,
                 std::span<const std::string> texts, const Extents& shape);
  [[noreturn]] void write_failed(const std::string& item, const char* action) const;
  [[noreturn]] void read_failed(const std::string& item, const char* action) const;
};

/// The innermost reason on HDF5's error stack, empty if there is none.
std::string hdf5_reason();
/// Makes the groups on the way to an item.
Hdf5Id hdf5_with_groups();
/// A shape as HDF5 wants it: no directions for a single value.
Hdf5Id hdf5_space(const Extents& shape);
std::vector<hsize_t> hdf5_extent(hid_t space);
std::size_t hdf5_count(const Extents& shape);

}  // namespace tlsph
