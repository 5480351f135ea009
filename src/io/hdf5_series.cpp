#include <algorithm>
#include <cassert>
#include <numeric>

#include "hdf5_open.hpp"
#include "tlsph/io/hdf5.hpp"

namespace tlsph {
namespace {

constexpr std::size_t wanted_chunk = 256 << 10;  // bytes
constexpr hsize_t most_rows = 64;                // so that few small rows make a small file
constexpr hsize_t largest_chunk = hsize_t{1} << 30;

/// Few, large chunks keep the index of a series in one node (see half_index_node). They cost
/// nothing: chunks are neither compressed nor cached, so any part of one is written and read by
/// itself.
std::vector<hsize_t> chunk_of(const Extents& row_shape, std::size_t chunk_rows) {
  std::vector<hsize_t> chunk{1};
  for (std::size_t length : row_shape) chunk.push_back(std::max<std::size_t>(length, 1));
  const auto row_bytes =
      std::accumulate(chunk.begin(), chunk.end(), hsize_t{8}, std::multiplies<>());
  chunk[0] =
      chunk_rows > 0 ? chunk_rows : std::clamp<hsize_t>(wanted_chunk / row_bytes, 1, most_rows);
  if (row_bytes > largest_chunk && chunk.size() > 1) {  // the library wants less than 4 GiB
    const hsize_t pieces = (row_bytes + largest_chunk - 1) / largest_chunk;
    chunk[0] = 1;
    chunk[1] = std::max<hsize_t>((chunk[1] + pieces - 1) / pieces, 1);
  }
  return chunk;
}

/// Without a chunk cache a row goes straight from the caller's memory to its place in the file: no
/// copy, and a chunk that is not yet full is not rewritten with each row.
Hdf5Id uncached() {
  Hdf5Id list(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  H5Pset_chunk_cache(list, 0, 0, 0.0);
  return list;
}

Hdf5Id open_dataset(hid_t file, const std::string& item) {
  return {H5Dopen2(file, item.c_str(), H5P_DEFAULT), H5Dclose};
}

}  // namespace

std::size_t Hdf5Series::row_size() const {
  return std::accumulate(extent.begin() + 1, extent.end(), std::size_t{1}, std::multiplies<>());
}

void Hdf5File::create_series(const std::string& item, const Extents& row_shape,
                             std::size_t chunk_rows) {
  Hdf5Series created;
  created.extent.push_back(0);
  created.extent.insert(created.extent.end(), row_shape.begin(), row_shape.end());
  std::vector<hsize_t> limit = created.extent;
  limit[0] = H5S_UNLIMITED;
  const auto rank = static_cast<int>(limit.size());
  const std::vector<hsize_t> chunk = chunk_of(row_shape, chunk_rows);
  const Hdf5Id space(H5Screate_simple(rank, created.extent.data(), limit.data()), H5Sclose);
  const Hdf5Id layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(layout, rank, chunk.data());
  H5Pset_fill_time(layout, H5D_FILL_TIME_NEVER);  // a row is written as soon as it is there
  created.dataset = Hdf5Id(H5Dcreate2(open_->file, item.c_str(), H5T_IEEE_F64LE, space,
                                      hdf5_with_groups(), layout, uncached()),
                           H5Dclose);
  if (!created.dataset.valid()) open_->write_failed(item, "create this series");
  open_->series.insert_or_assign(item, std::move(created));
}

void Hdf5File::append(const std::string& item, std::span<const double> values) {
  Hdf5Series& series = open_->series.at(item);
  const std::size_t row_size = series.row_size();
  if (values.empty() && row_size > 0) return;
  assert(row_size == 0 || values.size() % row_size == 0);
  // A row may be empty (no stress points); it counts as one all the same.
  const hsize_t added = row_size == 0 ? 1 : values.size() / row_size;
  std::vector<hsize_t> grown = series.extent;
  grown[0] += added;
  if (H5Dset_extent(series.dataset, grown.data()) < 0)
    open_->write_failed(item, "lengthen this series");
  std::vector<hsize_t> start(grown.size(), 0), count = grown;
  start[0] = series.extent[0];
  count[0] = added;
  series.extent = std::move(grown);
  if (row_size == 0) return;
  const Hdf5Id target(H5Dget_space(series.dataset), H5Sclose);
  H5Sselect_hyperslab(target, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const Hdf5Id source(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                      H5Sclose);
  if (H5Dwrite(series.dataset, H5T_NATIVE_DOUBLE, source, target, H5P_DEFAULT, values.data()) < 0)
    open_->write_failed(item, "write to this series");
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

}  // namespace tlsph
