#include "tlsph/io/hdf5.hpp"

#include <cassert>
#include <functional>
#include <numeric>
#include <type_traits>

#include "hdf5_open.hpp"
#include "system.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

/// Half the number of chunks that one node of a chunk index can hold. An index that fits into one
/// node is updated by one write; its rare splits are the only moment at which a killed program
/// could leave it half written. The library's default of 32 would split after 64 chunks.
constexpr unsigned half_index_node = 256;

herr_t keep_innermost(unsigned depth, const H5E_error2_t* error, void* reason) {
  if (depth == 0) *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

/// Errors are thrown, so the library prints nothing; readers may look at a file that is being
/// written, which the library's own lock would forbid. Files are closed by their owners: the
/// library's own clean-up at the end of the program is not needed and crashes after a full disk.
Hdf5Id access() {
  [[maybe_unused]] static const herr_t no_clean_up = H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Hdf5Id list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fclose_degree(list, H5F_CLOSE_STRONG);
  H5Pset_file_locking(list, false, true);
  return list;
}

/// How a number lies in the file, little-endian so that it does not depend on the machine, and in
/// memory.
template <class Value>
std::pair<hid_t, hid_t> types_of() {
  if constexpr (std::is_same_v<Value, double>)
    return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE};
  else if constexpr (std::is_same_v<Value, std::int32_t>)
    return {H5T_STD_I32LE, H5T_NATIVE_INT32};
  else
    return {H5T_STD_I64LE, H5T_NATIVE_INT64};
}

}  // namespace

std::string hdf5_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  // Of a failed system call only what the system said is of use to the user.
  const std::string mark = "error message = '";
  const std::size_t begin = reason.find(mark);
  if (begin == std::string::npos) return reason;
  const std::size_t end = reason.find('\'', begin + mark.size());
  return reason.substr(begin + mark.size(), end - begin - mark.size());
}

Hdf5Id hdf5_with_groups() {
  Hdf5Id list(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(list, 1);
  return list;
}

Hdf5Id hdf5_space(const Extents& shape) {
  if (shape.empty()) return {H5Screate(H5S_SCALAR), H5Sclose};
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  return {H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose};
}

std::vector<hsize_t> hdf5_extent(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> extent(rank > 0 ? static_cast<std::size_t>(rank) : 0);
  if (rank > 0) H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return extent;
}

std::size_t hdf5_count(const Extents& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

void Hdf5File::Open::write_failed(const std::string& item, const char* action) const {
  const std::string reason = hdf5_reason();
  throw OutputError(path.string() + (item.empty() ? "" : ":" + item) + ": cannot " + action +
                    (reason.empty() ? "" : ": " + reason));
}

void Hdf5File::Open::read_failed(const std::string& item, const char* action) const {
  const std::string reason = hdf5_reason();
  throw InputError(Place{path.string() + (item.empty() ? "" : ":" + item), 0, 0, ""},
                   std::string("cannot ") + action + (reason.empty() ? "" : ": " + reason));
}

Hdf5File::Hdf5File(std::unique_ptr<Open> open) : open_(std::move(open)) {}
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;
Hdf5File::~Hdf5File() = default;

Hdf5File Hdf5File::create(const std::filesystem::path& path) {
  auto open = std::make_unique<Open>();
  open->path = path;
  const Hdf5Id list = access();
  const Hdf5Id creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_istore_k(creation, half_index_node);
  open->file = Hdf5Id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, list), H5Fclose);
  if (!open->file.valid()) open->write_failed("", "create this file");
  return Hdf5File(std::move(open));
}

Hdf5File Hdf5File::open_read_only(const std::filesystem::path& path) {
  auto open = std::make_unique<Open>();
  open->path = path;
  open->file = Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access()), H5Fclose);
  if (!open->file.valid()) open->read_failed("", "open this file");
  return Hdf5File(std::move(open));
}

const std::filesystem::path& Hdf5File::path() const {
  return open_->path;
}

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

void Hdf5File::make_group(const std::string& item) {
  const Hdf5Id group(
      H5Gcreate2(open_->file, item.c_str(), hdf5_with_groups(), H5P_DEFAULT, H5P_DEFAULT),
      H5Gclose);
  if (!group.valid()) open_->write_failed(item, "make this group");
}

template <class Value>
void Hdf5File::write_array(const std::string& item, std::span<const Value> values,
                           const Extents& shape) {
  assert(values.size() == hdf5_count(shape));
  const auto [stored, in_memory] = types_of<Value>();
  const Hdf5Id dataset(H5Dcreate2(open_->file, item.c_str(), stored, hdf5_space(shape),
                                  hdf5_with_groups(), H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose);
  if (!dataset.valid() || (!values.empty() && H5Dwrite(dataset, in_memory, H5S_ALL, H5S_ALL,
                                                       H5P_DEFAULT, values.data()) < 0))
    open_->write_failed(item, "write this data set");
}

template void Hdf5File::write_array(const std::string&, std::span<const double>, const Extents&);
template void Hdf5File::write_array(const std::string&, std::span<const std::int32_t>,
                                    const Extents&);
template void Hdf5File::write_array(const std::string&, std::span<const std::int64_t>,
                                    const Extents&);

void Hdf5File::write_view(const std::string& item, const Extents& shape, const Extents& count,
                          const Hdf5Part& part) {
  const auto selected = [](const Extents& all, const Extents& start, const Extents& some) {
    Hdf5Id space = hdf5_space(all);
    const std::vector<hsize_t> from(start.begin(), start.end()), many(some.begin(), some.end());
    if (hdf5_count(some) > 0)
      H5Sselect_hyperslab(space, H5S_SELECT_SET, from.data(), nullptr, many.data(), nullptr);
    return space;
  };
  const Hdf5Id layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const Extents origin(shape.size(), 0);
  const bool mapped =
      hdf5_count(count) == 0 ||
      H5Pset_virtual(layout, selected(shape, origin, count), part.file.c_str(), part.item.c_str(),
                     selected(part.shape, part.start, part.count)) >= 0;
  const Hdf5Id dataset(H5Dcreate2(open_->file, item.c_str(), H5T_IEEE_F64LE, hdf5_space(shape),
                                  hdf5_with_groups(), layout, H5P_DEFAULT),
                       H5Dclose);
  if (!mapped || !dataset.valid()) open_->write_failed(item, "write this view");
}

void Hdf5File::Open::set_attribute(const std::string& item, const std::string& name,
                                   const void* values, std::pair<hid_t, hid_t> types,
                                   const Extents& shape) {
  const auto [stored, in_memory] = types;
  const Hdf5Id object(H5Oopen(file, item.c_str(), H5P_DEFAULT), H5Oclose);
  const auto replace = [&] {
    if (H5Aexists(object, name.c_str()) > 0 && H5Adelete(object, name.c_str()) < 0) return false;
    const Hdf5Id attribute(
        H5Acreate2(object, name.c_str(), stored, hdf5_space(shape), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    return attribute.valid() && H5Awrite(attribute, in_memory, values) >= 0;
  };
  if (!object.valid() || !replace()) write_failed(item + "@" + name, "write this attribute");
}

void Hdf5File::Open::set_texts(const std::string& item, const std::string& name,
                               std::span<const std::string> texts, const Extents& shape) {
  const Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  set_attribute(item, name, pointers.data(), {type, type}, shape);
}

void Hdf5File::set_attribute(const std::string& item, const std::string& name,
                             const std::string& text) {
  open_->set_texts(item, name, std::span(&text, 1), {});
}

void Hdf5File::set_attribute(const std::string& item, const std::string& name,
                             const std::vector<std::string>& texts) {
  open_->set_texts(item, name, texts, {texts.size()});
}

void Hdf5File::set_attribute(const std::string& item, const std::string& name, std::int64_t value) {
  open_->set_attribute(item, name, &value, types_of<std::int64_t>(), {});
}

void Hdf5File::flush() {
  if (H5Fflush(open_->file, H5F_SCOPE_GLOBAL) < 0) open_->write_failed("", "flush this file");
}

void Hdf5File::rename(const std::filesystem::path& path) {
  replace_file(open_->path, path);
  open_->path = path;
}

void Hdf5File::close() {
  open_->series.clear();
  const bool flushed = H5Fflush(open_->file, H5F_SCOPE_GLOBAL) >= 0;
  const std::string reason = flushed ? "" : hdf5_reason();
  const bool closed = open_->file.release() >= 0;
  if (!flushed || !closed)
    throw OutputError(open_->path.string() + ": cannot close this file" +
                      (reason.empty() ? "" : ": " + reason));
}

}  // namespace tlsph
