/// Loads on part of the boundary: a named box cuts faces where it ends.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tlsph/filling/cloud.hpp"
#include "tlsph/filling/fitted.hpp"
#include "tlsph/filling/jitter.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/boundary_faces.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {
namespace {

const Shape<2> sheet = make_box<2>({0.0, 0.0}, {1.0, 0.2});

struct Filling {
  const char* name;
  Particles<2> (*fill)();
};

Particles<2> lattice() {
  return make_lattice(sheet, 0.025);
}

class PartOfAnEdge : public testing::TestWithParam<Filling> {};

/// ∫ t dA and ∫ X × t dA over 0.51 … 0.71 of the top, and over boxes drawn at random, between nodes
/// and within one face.
TEST_P(PartOfAnEdge, CarriesItsResultantAndItsMoment) {
  const Particles<2> body = GetParam().fill();
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int k = 0; k < 40; ++k) {
    double from = 0.51, to = 0.71;
    if (k > 0) std::tie(from, to) = std::minmax({uniform(generator), uniform(generator)});
    if (k == 1) to = from + 1e-3;
    const auto cut = with_named_box<2>(body, "part", {from, 0.199}, {to, 0.201}, {}, &sheet);
    const Patch<2>& part = *cut.find("part");

    double force = 0.0, moment = 0.0;
    for (const Face<2>& face : part.faces)
      for (std::size_t end = 0; end < 2; ++end) {
        force += face.share[end] * face.area.y();
        moment += face.share[end] * face.area.y() * body.X(face.nodes[end], 0);
        EXPECT_GE(face.share[end], -1e-12);
        EXPECT_NEAR(face.area.x(), 0.0, 1e-15);
      }

    EXPECT_NEAR(patch_extent(part), to - from, 1e-12) << from << " … " << to;
    EXPECT_NEAR(force, to - from, 1e-12);
    if (body.placement == NodePlacement::on_boundary) {
      EXPECT_NEAR(moment, 0.5 * (to * to - from * from), 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Fillings, PartOfAnEdge,
    testing::Values(Filling{"lattice", lattice},
                    Filling{"cell_centred",
                            [] { return make_lattice(sheet, 0.025, NodePlacement::cell_centred); }},
                    Filling{"jittered", [] { return jittered<2>(lattice(), 0.3, 4); }},
                    Filling{"hexagonal", [] { return hexagonal_lattice(sheet, 0.025); }},
                    Filling{"cloud",
                            [] {
                              return make_cloud<2>(jittered<2>(lattice(), 0.3, 4).X, sheet, 0.0,
                                                   [](Index) { return Place{}; });
                            }}),
    [](const auto& filling) { return std::string(filling.param.name); });

/// The shares that make a quadrature exact over whole edges are not those of a part of one.
TEST(NamedBox, KeepsItsResultantBesideExactMoments) {
  Particles<2> body = with_named_box<2>(lattice(), "part", {0.51, 0.199}, {0.71, 0.201});
  body = with_named_box<2>(std::move(body), "end", {0.999, -1.0}, {2.0, 1.0});
  body = with_named_box<2>(std::move(body), "corner", {0.99, 0.19}, {1.0, 0.2});
  const auto exact = with_exact_moments<2>(std::move(body), {2, 3});

  const auto total = [&](const char* name) {
    Vector<2> sum = Vector<2>::Zero();
    for (const Face<2>& face : exact.find(name)->faces)
      sum += (face.share[0] + face.share[1]) * face.area;
    return sum;
  };
  EXPECT_NEAR((total("part") - Vector<2>(0.0, 0.2)).norm(), 0.0, 1e-13);
  EXPECT_NEAR((total("corner") - Vector<2>(0.01, 0.01)).norm(), 0.0, 1e-13);
  // All of the right edge in a box is that edge, with 1 mm of both next to it.
  EXPECT_NEAR((total("end") - total("right")).norm(), 0.0, 1e-13);
  const auto& end = exact.find("end")->faces;
  for (const Face<2>& face : exact.find("right")->faces) {
    const auto twin = std::ranges::find(end, face.nodes, &Face<2>::nodes);
    ASSERT_NE(twin, end.end());
    EXPECT_EQ(twin->share, face.share);
    EXPECT_FALSE(twin->cut);
  }
}

/// A box around one node loads what of the edges next to it lies in the box.
TEST(NamedBox, AroundACornerHoldsOneNodeAndPartsOfTwoEdges) {
  const auto body = with_named_box<2>(lattice(), "tip", {0.999, 0.199}, {1.001, 0.201});
  const Patch<2>& tip = *body.find("tip");

  ASSERT_EQ(tip.nodes.size(), 1U);
  EXPECT_NEAR((body.X.row(tip.nodes[0]) - Eigen::RowVector2d(1.0, 0.2)).norm(), 0.0, 1e-15);
  EXPECT_EQ(tip.faces.size(), 2U);
  EXPECT_NEAR(patch_extent(tip), 0.002, 1e-14);
}

TEST(NamedBox, BetweenTwoNodesHoldsBoundaryWithoutNodes) {
  const auto body = with_named_box<2>(lattice(), "gap", {0.51, 0.2}, {0.52, 0.2});

  EXPECT_TRUE(body.find("gap")->nodes.empty());
  EXPECT_NEAR(patch_extent(*body.find("gap")), 0.01, 1e-14);
}

/// The normal resultant over a cap of a circle is its chord, whichever way the nodes lie.
TEST(NamedBox, CutsArcsWhereTheyMeetItsBounds) {
  const Shape<2> disc = make_disc({0.3, -0.2}, 1.0);
  const Particles<2> bodies[] = {fitted(make_lattice(disc, 0.1), disc),
                                 hexagonal_lattice(disc, 0.1)};
  for (const Particles<2>& body : bodies)
    for (const double height : {-0.9, -0.35, 0.0, 0.31, 0.6, 0.97, 0.999}) {
      const double half = std::sqrt(1.0 - height * height);
      const auto cut = with_named_box<2>(body, "cap", {-2.0, -0.2 + height}, {2.0, 2.0}, {}, &disc);
      Vector<2> force = Vector<2>::Zero();
      for (const Face<2>& face : cut.find("cap")->faces)
        force += (face.share[0] + face.share[1]) * face.area;

      EXPECT_NEAR((force - Vector<2>(0.0, 2.0 * half)).norm(), 0.0, 1e-12) << height;
      const double arc = 2.0 * std::acos(height);
      EXPECT_NEAR(patch_extent(*cut.find("cap")), arc, 1e-3 * arc) << height;
    }
  // What it leaves out above is cut on both sides of one face.
  const auto slice = with_named_box<2>(bodies[0], "slice", {-2.0, 0.0}, {2.0, 0.799}, {}, &disc);
  Vector<2> force = Vector<2>::Zero();
  for (const Face<2>& face : slice.find("slice")->faces) force += face.area;
  EXPECT_NEAR(force.x(), 0.0, 1e-12);
  EXPECT_NEAR(force.y(), 2.0 * (std::sqrt(1.0 - 0.04) - std::sqrt(1.0 - 0.999 * 0.999)), 1e-12);
}

}  // namespace
}  // namespace tlsph
