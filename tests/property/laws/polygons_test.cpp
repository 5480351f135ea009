/// Lattices fill every polygon that is not too thin for their spacing, and what is filled is right.
///
/// TLSPH_POLYGONS in the environment sets the number of random polygons (default: 200).

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <set>

#include "boundary_distance.hpp"
#include "property/polygons.hpp"
#include "tlsph/filling/fitted.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/boundary_faces.hpp"

namespace tlsph::property {
namespace {

int count_of_polygons() {
  const char* value = std::getenv("TLSPH_POLYGONS");
  return value == nullptr ? 200 : std::atoi(value);
}

std::string text_of(const Corners& corners) {
  std::string text;
  for (const auto& x : corners)
    text += fmt::format("{}[{:.17g}, {:.17g}]", text.empty() ? "" : ", ", x.x(), x.y());
  return "[" + text + "]";
}

/// The least corner Jacobian and the least sine of a corner.
std::array<double, 2> least_corner(const Particles<2>& body) {
  double jacobian = 1e300, sine = 1.0;
  for (const auto& cell : body.cells)
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector<2> here = body.X.row(cell[k]).transpose();
      const Vector<2> e = body.X.row(cell[(k + 1) % 4]).transpose() - here;
      const Vector<2> f = body.X.row(cell[(k + 3) % 4]).transpose() - here;
      jacobian = std::min(jacobian, cross(e, f));
      sine = std::min(sine, cross(e, f) / (e.norm() * f.norm()));
    }
  return {jacobian, sine};
}

double longest_edge(const Particles<2>& body) {
  double longest = 0.0;
  for (const auto& cell : body.cells)
    for (std::size_t k = 0; k < 4; ++k)
      longest = std::max(longest, (body.X.row(cell[k]) - body.X.row(cell[(k + 1) % 4])).norm());
  return longest;
}

TEST(Polygons, AreFilledWithConvexCells) {
  Random random(5);
  double least_jacobian = 1.0, least_sine = 1.0, longest = 0.0;
  for (int k = 0; k < count_of_polygons(); ++k) {
    Corners corners = random_polygon(random);
    const double spacing = std::exp(3.0 * random());  // [m]
    for (auto& corner : corners) corner *= spacing;
    SCOPED_TRACE(fmt::format("spacing = {:.17g}, polygon = {}", spacing, text_of(corners)));
    const Shape<2> shape = make_polygon(corners);
    Particles<2> body;
    ASSERT_NO_THROW(body = fitted(shape, spacing));

    const auto [jacobian, sine] = least_corner(body);
    least_jacobian = std::min(least_jacobian, jacobian / (spacing * spacing));
    least_sine = std::min(least_sine, sine);
    longest = std::max(longest, longest_edge(body) / spacing);
    EXPECT_GE(jacobian, 0.0999 * spacing * spacing);
    EXPECT_GE(sine, 0.0999);
    EXPECT_LE(longest_edge(body), 4.0 * spacing);
    EXPECT_NEAR(body.V.sum(), area(shape), 1e-10 * area(shape));
    EXPECT_GT(body.V.minCoeff(), 0.0);
    const Tensor<2> first = body.B.transpose() * body.X;
    EXPECT_LE((first - area(shape) * Tensor<2>::Identity()).norm(), 1e-10 * area(shape));
    for (const auto& corner : corners)
      EXPECT_LE((body.X.rowwise() - corner.transpose()).rowwise().norm().minCoeff(),
                1e-9 * spacing);
    const auto& nodes = body.find("boundary")->nodes;
    const std::set<int> boundary(nodes.begin(), nodes.end());
    for (int q = 0; q < static_cast<int>(body.size()); ++q) {
      const double depth = signed_distance(shape, Vector<2>(body.X.row(q).transpose()));
      if (boundary.contains(q))
        EXPECT_NEAR(depth, 0.0, 1e-9 * spacing);
      else
        EXPECT_GT(depth, 0.0);
    }
  }
  fmt::print("least Jacobian {:.3f} spacings², least sine {:.3f}, longest edge {:.2f} spacings\n",
             least_jacobian, least_sine, longest);
}

/// A patch test: G is exact for affine fields, and the constant stress that follows is in balance
/// with its tractions, f_q = −P B_q. And the step is not eaten up by bad cells.
TEST(Polygons, HoldConstantStressAtAUsableStep) {
  Random random(6);
  double least_step = 1.0;
  for (int k = 0; k < count_of_polygons() / 10; ++k) {
    const Corners corners = random_polygon(random);
    const Scene scene = read_scene_text(
        fmt::format("dimension = 2\nformulation = \"stress-point\"\n[body]\nshape = {{ polygon = "
                    "{} }}\nspacing = 1.0\n[material]\nlaw = \"linear-elastic\"\nyoung = 2e6\n"
                    "poisson = 0.3\ndensity = 1000\n[time]\nend = 1.0\n",
                    text_of(corners)),
        "polygon", {});
    SCOPED_TRACE(text_of(corners));
    const Discretisation<2> body = build<2>(scene);
    const Tensor<2> A = random.tensor<2>(0.1);
    const State<2> state = evaluated<2>(body, affine<2>(body.particles.X, A, Vector<2>(0.3, -0.2)));

    for (Index s = 0; s < state.H.rows(); ++s)
      EXPECT_LE((tensor_at<2>(state.H, s) - A).cwiseAbs().maxCoeff(), 1e-12);
    const Tensor<2> P = tensor_at<2>(state.P, 0);
    const VectorField<2> balanced = -body.particles.B * P.transpose();
    EXPECT_LE((state.f - balanced).cwiseAbs().maxCoeff(), 1e-11 * P.norm());
    const double step = critical_step<2>(body, state).scaled;
    least_step = std::min(least_step, step);
    EXPECT_GE(step, 0.1);
  }
  fmt::print("least critical step {:.3f} spacings/c_p\n", least_step);
}

}  // namespace
}  // namespace tlsph::property
