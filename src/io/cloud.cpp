#include "tlsph/io/cloud.hpp"

#include <cassert>

namespace tlsph {

void write_cloud(Hdf5File& file, const std::string& group, const CloudView& cloud) {
  const std::size_t count = cloud.size(), d = cloud.dimension;
  assert(cloud.X.size() == count * d);
  file.write(group + "/X", cloud.X, {count, d}, "m");
  file.write(group + "/V", cloud.V, {count}, d == 1 ? "m" : "m^" + std::to_string(d));
  if (cloud.tag.empty() && cloud.patches.empty()) return;
  assert(cloud.tag.size() == count);
  file.write(group + "/tag", cloud.tag, {count}, "1");
  file.set_attribute(group + "/tag", "patches", cloud.patches);
}

}  // namespace tlsph
