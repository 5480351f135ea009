#include "tlsph/io/checkpoint.hpp"

#include <bit>
#include <cstring>
#include <fstream>
#include <system_error>

#include "tlsph/core/error.hpp"
#include "tlsph/io/check_sum.hpp"
#include "tlsph/io/files.hpp"

namespace tlsph {
namespace fs = std::filesystem;
namespace {

constexpr char magic[8] = {'T', 'L', 'S', 'P', 'H', 'C', 'K', 'P'};
constexpr std::uint64_t version = 4;

class Writer {
 public:
  explicit Writer(const fs::path& path) : file_(path) {}
  void bytes(const void* data, std::size_t count) {
    sum_.add(data, count);
    file_.write(data, count);
  }
  void number(std::uint64_t value) { bytes(&value, sizeof value); }
  void entry(std::span<const double> values) {
    number(values.size());
    bytes(values.data(), values.size_bytes());
  }
  void entry(std::int64_t value) { number(std::bit_cast<std::uint64_t>(value)); }
  void entry(const std::string& value) {
    number(value.size());
    bytes(value.data(), value.size());
  }
  void entries(const auto& map) {
    number(map.size());
    for (const auto& [name, value] : map) {
      entry(name);
      entry(value);
    }
  }
  void commit() {
    number(sum_.value());
    file_.commit(Durability::machine);
  }

 private:
  AsideFile file_;
  CheckSum sum_;
};

class Reader {
 public:
  explicit Reader(const fs::path& path) : path_(path), file_(path, std::ios::binary) {
    std::error_code error;
    left_ = fs::file_size(path, error);
    if (!file_ || error) fail("cannot be read");
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(Place{path_.string(), 0, 0, ""}, message + "; start without --resume");
  }
  void bytes(void* data, std::size_t count) {
    // Asked before any memory is taken: a damaged length must not ask for all of it.
    need(count);
    file_.read(static_cast<char*>(data), static_cast<std::streamsize>(count));
    if (!file_) fail("cannot be read");
    sum_.add(data, count);
    left_ -= count;
  }
  void need(std::uint64_t count) const {
    if (count > left_) fail("is a torn checkpoint");
  }
  std::uint64_t number() {
    std::uint64_t value = 0;
    bytes(&value, sizeof value);
    return value;
  }
  void entry(std::string& value) {
    const std::uint64_t count = number();
    need(count);
    value.resize(count);
    bytes(value.data(), count);
  }
  void entry(std::vector<double>& values) {
    const std::uint64_t count = number();
    need(count);  // so that the product below cannot overflow
    need(count * sizeof(double));
    values.resize(count);
    bytes(values.data(), count * sizeof(double));
  }
  void entry(std::int64_t& value) { value = std::bit_cast<std::int64_t>(number()); }
  void entries(auto& map) {
    for (std::uint64_t left = number(); left > 0; --left) {
      std::string name;
      entry(name);
      entry(map[name]);
    }
  }
  void finish() {
    const std::uint64_t computed = sum_.value();
    if (number() != computed || left_ != 0) fail("is a damaged checkpoint");
  }

 private:
  fs::path path_;
  std::ifstream file_;
  std::uint64_t left_ = 0;
  CheckSum sum_;
};

template <class Map>
const auto& find(const Map& map, const std::string& name, const fs::path& path) {
  const auto found = map.find(name);
  if (found == map.end())
    throw InputError(
        Place{path.string(), 0, 0, ""},
        "has no \"" + name + "\"; it is another run's checkpoint, start without --resume");
  return found->second;
}

}  // namespace

void write_checkpoint(const fs::path& path, const CheckpointView& checkpoint) {
  Writer writer(path);
  writer.bytes(magic, sizeof magic);
  writer.number(version);
  writer.entries(checkpoint.arrays);
  writer.entries(checkpoint.integers);
  writer.entries(checkpoint.texts);
  writer.commit();
}

Checkpoint read_checkpoint(const fs::path& path) {
  Reader reader(path);
  char found[8];
  reader.bytes(found, sizeof found);
  if (std::memcmp(found, magic, sizeof magic) != 0) reader.fail("is not a checkpoint");
  if (reader.number() != version) reader.fail("is a checkpoint of another version or machine");
  Checkpoint checkpoint;
  checkpoint.path = path;
  reader.entries(checkpoint.arrays);
  reader.entries(checkpoint.integers);
  reader.entries(checkpoint.texts);
  reader.finish();
  return checkpoint;
}

const std::vector<double>& Checkpoint::array(const std::string& name) const {
  return find(arrays, name, path);
}

const std::vector<double>& Checkpoint::array(const std::string& name, std::size_t size) const {
  const auto& values = array(name);
  if (values.size() != size)
    throw InputError(Place{path.string(), 0, 0, ""},
                     "\"" + name + "\" holds " + std::to_string(values.size()) +
                         " values, the run needs " + std::to_string(size) +
                         "; it is another run's checkpoint, start without --resume");
  return values;
}

std::int64_t Checkpoint::integer(const std::string& name) const {
  return find(integers, name, path);
}

const std::string& Checkpoint::text(const std::string& name) const {
  return find(texts, name, path);
}

}  // namespace tlsph
