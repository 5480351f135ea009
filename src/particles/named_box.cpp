#include <fmt/core.h>

#include <algorithm>

#include "tlsph/particles/boundary_faces.hpp"
#include "tlsph/particles/lattice.hpp"

namespace tlsph {

template <int D>
Particles<D> with_named_box(Particles<D> particles, const std::string& name, const Vector<D>& lower,
                            const Vector<D>& upper, const Place& place) {
  if (particles.find(name))
    throw InputError(place, fmt::format("tag \"{}\" already names a part of the body; choose "
                                        "another name",
                                        name));
  if (!(lower.array() <= upper.array()).all())
    throw InputError(place, fmt::format("the box of tag \"{}\" is upside down: every lower bound "
                                        "must be at most its upper bound",
                                        name));
  const double tolerance = 1e-6 * particles.spacing;
  const auto inside = [&](int node) {
    const Vector<D> x = particles.X.row(node).transpose();
    return ((x - lower).array() >= -tolerance).all() && ((upper - x).array() >= -tolerance).all();
  };
  Patch<D> patch{name, {}, {}};
  for (int node = 0; node < static_cast<int>(particles.size()); ++node)
    if (inside(node)) patch.nodes.push_back(node);
  if (patch.nodes.empty())
    throw InputError(place,
                     fmt::format("tag \"{}\" holds no particles: none lies in its box", name));
  if (const Patch<D>* boundary = particles.find("boundary"))
    std::copy_if(boundary->faces.begin(), boundary->faces.end(), std::back_inserter(patch.faces),
                 [&](const Face<D>& face) {
                   return std::all_of(face.nodes.begin(), face.nodes.end(), inside);
                 });
  particles.patches.push_back(std::move(patch));
  return particles;
}

template Particles<1> with_named_box(Particles<1>, const std::string&, const Vector<1>&,
                                     const Vector<1>&, const Place&);
template Particles<2> with_named_box(Particles<2>, const std::string&, const Vector<2>&,
                                     const Vector<2>&, const Place&);

}  // namespace tlsph
