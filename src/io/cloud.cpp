#include "tlsph/io/cloud.hpp"

#include <cassert>

namespace tlsph {

std::string volume_unit(std::size_t dimension) {
  return dimension == 1 ? "m" : "m^" + std::to_string(dimension);
}

void write_cloud(Hdf5File& file, const std::string& group, const CloudView& cloud) {
  const std::size_t count = cloud.size();
  assert(cloud.X.size() == count * cloud.dimension);
  file.write(group + "/X", cloud.X, {count, cloud.dimension});
  file.set_attribute(group + "/X", "unit", "m");
  file.write(group + "/V", cloud.V, {count});
  file.set_attribute(group + "/V", "unit", volume_unit(cloud.dimension));
  if (cloud.tag.empty() && cloud.patches.empty()) return;
  assert(cloud.tag.size() == count);
  file.write(group + "/tag", cloud.tag, {count});
  file.set_attribute(group + "/tag", "unit", "1");
  file.set_attribute(group + "/tag", "patches", cloud.patches);
}

}  // namespace tlsph
