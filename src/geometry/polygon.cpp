#include "tlsph/geometry/polygon.hpp"

namespace tlsph {

double signed_area(const Corners& corners) {
  // The fan of triangles about the first corner: a small polygon far from the origin loses no
  // digits.
  double twice = 0.0;
  for (std::size_t k = 2; k < corners.size(); ++k)
    twice += cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
  return 0.5 * twice;
}

Corners clip_half_plane(const Corners& subject, const Vector<2>& normal, double offset) {
  Corners kept;
  kept.reserve(subject.size() + 1);
  for (std::size_t k = 0; k < subject.size(); ++k) {
    const Vector<2>& a = subject[k];
    const Vector<2>& b = subject[(k + 1) % subject.size()];
    const double height_a = normal.dot(a) - offset;
    const double height_b = normal.dot(b) - offset;
    if (height_a <= 0.0) kept.push_back(a);
    if ((height_a < 0.0 && height_b > 0.0) || (height_a > 0.0 && height_b < 0.0))
      kept.push_back(a + height_a / (height_a - height_b) * (b - a));
  }
  if (kept.size() < 3) kept.clear();
  return kept;
}

}  // namespace tlsph
