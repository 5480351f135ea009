#pragma once
// What only tests read of HDF5 files: integers and attributes.

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tlsph/io/hdf5.hpp"

namespace tlsph::test {

/// The file again, by the library alone.
class RawHdf5 {
 public:
  explicit RawHdf5(const Hdf5File& file) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);  // as the file itself, which is still open
    H5Pset_file_locking(access, false, true);
    id = H5Fopen(file.path().c_str(), H5F_ACC_RDONLY, access);
    H5Pclose(access);
  }
  RawHdf5(const RawHdf5&) = delete;
  RawHdf5& operator=(const RawHdf5&) = delete;
  ~RawHdf5() { H5Fclose(id); }

  hid_t id = -1;
};

inline std::vector<std::int64_t> read_integers(const Hdf5File& file, const std::string& item) {
  const RawHdf5 raw(file);
  const hid_t dataset = H5Dopen2(raw.id, item.c_str(), H5P_DEFAULT);
  const hid_t type = H5Dget_type(dataset), space = H5Dget_space(dataset);
  std::vector<std::int64_t> values;
  if (H5Tget_class(type) == H5T_INTEGER) {
    values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  H5Sclose(space);
  H5Tclose(type);
  H5Dclose(dataset);
  return values;
}

inline std::int64_t integer_attribute(const Hdf5File& file, const std::string& item,
                                      const std::string& name) {
  const RawHdf5 raw(file);
  const hid_t id = H5Aopen_by_name(raw.id, item.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  std::int64_t value = 0;
  H5Aread(id, H5T_NATIVE_INT64, &value);
  H5Aclose(id);
  return value;
}

inline std::vector<std::string> texts_attribute(const Hdf5File& file, const std::string& item,
                                                const std::string& name) {
  const RawHdf5 raw(file);
  const hid_t id = H5Aopen_by_name(raw.id, item.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  const hid_t space = H5Aget_space(id), type = H5Aget_type(id);
  std::vector<char*> pointers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Aread(id, type, pointers.data());
  std::vector<std::string> texts(pointers.begin(), pointers.end());
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
  H5Tclose(type);
  H5Sclose(space);
  H5Aclose(id);
  return texts;
}

}  // namespace tlsph::test
