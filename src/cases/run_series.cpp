#include "run_series.hpp"

#include "tlsph/io/hdf5.hpp"

namespace tlsph {

RunSeries read_series(const std::filesystem::path& directory, const std::string& quantity) {
  const auto file = Hdf5File::open_read_only(directory / "run.h5");
  return {file.read_doubles("series/time").values, file.read_doubles("series/" + quantity).values};
}

}  // namespace tlsph
