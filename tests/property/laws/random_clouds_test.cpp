/// Random bodies of scattered points build with default operators: 24 in the suite,
/// TLSPH_RANDOM_CLOUDS=500 for as many as that.

#include <cstdlib>

#include "property/random_clouds.hpp"

namespace tlsph::property {
namespace {

/// Critical steps of the square lattice with the same operators are 0.92 (consistent) and 1.3
/// (variational) spacings/c_p; a cloud keeps this share of them.
constexpr double least_share = 0.3;

int clouds_to_build() {
  const char* wanted = std::getenv("TLSPH_RANDOM_CLOUDS");
  return wanted == nullptr ? 24 : std::atoi(wanted);
}

/// The scaled critical step of the body at rest.
double step_of(const Discretisation<2>& body) {
  return critical_step<2>(body, evaluated<2>(body, VectorField<2>::Zero(body.nodes(), 2))).scaled;
}

Discretisation<2> built(const RandomCloud& cloud, const std::string& formulation) {
  return build<2>(scene_of(cloud, formulation, {}));
}

TEST(RandomClouds, BuildWithSmallResidualsAndAFairStep) {
  for (int number = 0; number < clouds_to_build(); ++number) {
    const RandomCloud cloud = random_cloud(number);
    SCOPED_TRACE(cloud.name);
    const Discretisation<2> consistent = built(cloud, "consistent");
    ASSERT_TRUE(consistent.consistency);
    EXPECT_LE(consistent.consistency->row, 1e-10);
    EXPECT_LE(consistent.consistency->column, 1e-10);
    EXPECT_GT(consistent.particles.V.minCoeff(), 0.0);
    EXPECT_GE(step_of(consistent), least_share * 0.92);
    EXPECT_GE(step_of(built(cloud, "variational")), least_share * 1.3);
  }
}

}  // namespace
}  // namespace tlsph::property
