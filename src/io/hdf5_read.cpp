#include <algorithm>

#include "hdf5_open.hpp"
#include "tlsph/io/hdf5.hpp"

namespace tlsph {
namespace {

Hdf5Id open_dataset(hid_t file, const std::string& item) {
  return {H5Dopen2(file, item.c_str(), H5P_DEFAULT), H5Dclose};
}

/// The texts of a data set or attribute of variable-length strings, read by `read` into `pointers`.
template <class Read>
bool read_pointers(hid_t space, Read read, std::vector<std::string>& texts) {
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (count < 0) return false;
  std::vector<char*> pointers(static_cast<std::size_t>(count), nullptr);
  const Hdf5Id type = hdf5_text_type();
  if (count > 0 && read(static_cast<hid_t>(type), pointers.data()) < 0) return false;
  for (const char* pointer : pointers) texts.emplace_back(pointer != nullptr ? pointer : "");
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
  return true;
}

struct Attribute {
  Hdf5Id object, id;
  Attribute(hid_t file, const std::string& item, const std::string& name)
      : object(H5Oopen(file, item.c_str(), H5P_DEFAULT), H5Oclose) {
    if (object.valid()) id = Hdf5Id(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  }
};

template <class Value>
bool read_number(hid_t file, const std::string& item, const std::string& name, hid_t type,
                 Value& value) {
  const Attribute attribute(file, item, name);
  if (!attribute.id.valid()) return false;
  const Hdf5Id space(H5Aget_space(attribute.id), H5Sclose);
  return H5Sget_simple_extent_npoints(space) == 1 && H5Aread(attribute.id, type, &value) >= 0;
}

}  // namespace

bool Hdf5File::exists(const std::string& item) const {
  // The library wants every group on the way to be there before it answers.
  for (std::size_t end = item.find('/', 1);; end = item.find('/', end + 1)) {
    const std::string part = item.substr(0, end);
    if (part != "/" && H5Lexists(open_->file, part.c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> Hdf5File::names(const std::string& group) const {
  std::vector<std::string> found;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  const Hdf5Id id(H5Gopen2(open_->file, group.c_str(), H5P_DEFAULT), H5Gclose);
  if (!id.valid() || H5Literate(id, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &found) < 0)
    open_->read_failed(group, "list this group");
  return found;
}

Extents Hdf5File::shape(const std::string& item) const {
  if (const auto found = open_->series.find(item); found != open_->series.end())
    return {found->second.extent.begin(), found->second.extent.end()};
  const Hdf5Id dataset = open_dataset(open_->file, item);
  if (!dataset.valid()) open_->read_failed(item, "open this data set");
  const auto extent = hdf5_extent(Hdf5Id(H5Dget_space(dataset), H5Sclose));
  return {extent.begin(), extent.end()};
}

std::size_t Hdf5File::rows(const std::string& item) const {
  const Extents lengths = shape(item);
  return lengths.empty() ? 1 : lengths[0];
}

Hdf5Array<double> Hdf5File::read_doubles(const std::string& item) const {
  Hdf5Array<double> array{shape(item), {}};
  array.values.resize(hdf5_count(array.shape));
  const Hdf5Id dataset = open_dataset(open_->file, item);
  if (!array.values.empty() &&
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) < 0)
    open_->read_failed(item, "read this data set");
  return array;
}

Hdf5Array<std::int64_t> Hdf5File::read_integers(const std::string& item) const {
  Hdf5Array<std::int64_t> array{shape(item), {}};
  array.values.resize(hdf5_count(array.shape));
  const Hdf5Id dataset = open_dataset(open_->file, item);
  // The library would turn doubles into integers without a word.
  const Hdf5Id type(H5Dget_type(dataset), H5Tclose);
  if (H5Tget_class(type) != H5T_INTEGER ||
      (!array.values.empty() &&
       H5Dread(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) < 0))
    open_->read_failed(item, "read this data set as integers");
  return array;
}

Hdf5Array<double> Hdf5File::read_rows(const std::string& item, std::size_t first,
                                      std::size_t count) const {
  Hdf5Array<double> array{shape(item), {}};
  if (array.shape.empty() || first > array.shape[0] || count > array.shape[0] - first)
    open_->read_failed(item, "read rows that are not there");
  array.shape[0] = count;
  array.values.resize(hdf5_count(array.shape));
  if (array.values.empty()) return array;
  const Hdf5Id dataset = open_dataset(open_->file, item);
  const std::vector<hsize_t> extent(array.shape.begin(), array.shape.end());
  std::vector<hsize_t> start(extent.size(), 0);
  start[0] = first;
  const Hdf5Id source(H5Dget_space(dataset), H5Sclose);
  H5Sselect_hyperslab(source, H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr);
  const Hdf5Id target(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                      H5Sclose);
  if (H5Dread(dataset, H5T_NATIVE_DOUBLE, target, source, H5P_DEFAULT, array.values.data()) < 0)
    open_->read_failed(item, "read rows of this data set");
  return array;
}

std::vector<std::string> Hdf5File::read_texts(const std::string& item) const {
  std::vector<std::string> texts;
  const Hdf5Id dataset = open_dataset(open_->file, item);
  const auto read = [&](hid_t type, char** pointers) {
    return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers);
  };
  if (!dataset.valid() || !read_pointers(Hdf5Id(H5Dget_space(dataset), H5Sclose), read, texts))
    open_->read_failed(item, "read these texts");
  return texts;
}

bool Hdf5File::has_attribute(const std::string& item, const std::string& name) const {
  return H5Aexists_by_name(open_->file, item.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::texts_attribute(const std::string& item,
                                                   const std::string& name) const {
  std::vector<std::string> texts;
  const Attribute attribute(open_->file, item, name);
  const auto read = [&](hid_t type, char** pointers) {
    return H5Aread(attribute.id, type, pointers);
  };
  if (!attribute.id.valid() ||
      !read_pointers(Hdf5Id(H5Aget_space(attribute.id), H5Sclose), read, texts))
    open_->read_failed(item + "@" + name, "read this attribute");
  return texts;
}

std::string Hdf5File::text_attribute(const std::string& item, const std::string& name) const {
  const auto texts = texts_attribute(item, name);
  if (texts.size() != 1) open_->read_failed(item + "@" + name, "read this attribute as one text");
  return texts[0];
}

double Hdf5File::double_attribute(const std::string& item, const std::string& name) const {
  double value = 0.0;
  if (!read_number(open_->file, item, name, H5T_NATIVE_DOUBLE, value))
    open_->read_failed(item + "@" + name, "read this attribute");
  return value;
}

std::int64_t Hdf5File::integer_attribute(const std::string& item, const std::string& name) const {
  std::int64_t value = 0;
  if (!read_number(open_->file, item, name, H5T_NATIVE_INT64, value))
    open_->read_failed(item + "@" + name, "read this attribute");
  return value;
}

}  // namespace tlsph
