#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct BadShape {
  const char* name;
  Shape<2> shape;
  const char* says;
};

class Refused : public testing::TestWithParam<BadShape> {};

TEST_P(Refused, WithPlaceAndReason) {
  try {
    validate(GetParam().shape, Place{"plate.toml", 7, 3, "body.shape"});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("plate.toml:7:3: body.shape: "));
    EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().says));
  }
}

Shape<2> unit() {
  return make_box<2>({0, 0}, {1, 1});
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Refused,
    testing::Values(
        BadShape{"flat_box", make_box<2>({0, 1}, {1, 1}), "upper bound 1 in y"},
        BadShape{"inverted_box", make_box<2>({2, 0}, {1, 1}), "in x"},
        BadShape{"infinite_box", make_box<2>({0, 0}, {1, infinite}), "finite"},
        BadShape{"no_radius", make_disc({0, 0}, 0.0), "greater than 0, not 0"},
        BadShape{"negative_radius", make_disc({0, 0}, -1.0), "greater than 0, not -1"},
        BadShape{"nan_disc", make_disc({0, std::nan("")}, 1.0), "finite"},
        BadShape{"two_corners", make_polygon({{0, 0}, {1, 0}}), "at least 3 corners, not 2"},
        BadShape{"infinite_corner", make_polygon({{0, 0}, {1, 0}, {0, infinite}}), "finite"},
        BadShape{"repeated_corner", make_polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
                 "corners 2 and 3 of the polygon coincide"},
        BadShape{"closed_by_hand", make_polygon({{0, 0}, {1, 0}, {0, 1}, {0, 0}}),
                 "corners 4 and 1 of the polygon coincide"},
        BadShape{"bow_tie", make_polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), "edges 1 and 3"},
        BadShape{"touching_corner", make_polygon({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}),
                 "cross or touch"},
        BadShape{"collinear", make_polygon({{0, 0}, {1, 1}, {2, 2}}), "no area"},
        BadShape{"spike", make_polygon({{0, 0}, {1, 0}, {2, 0}, {1.5, 0}, {1, 1}}),
                 "cross or touch"},
        BadShape{"fold", make_polygon({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), "cross or touch"},
        BadShape{"no_base", Shape<2>{std::shared_ptr<const Difference<2>>()}, "needs a base"},
        BadShape{"no_holes", make_difference(unit(), {}), "at least one hole"},
        BadShape{"bad_base", make_difference(make_disc({0, 0}, -2.0), {unit()}), "not -2"},
        BadShape{"bad_hole", make_difference(unit(), {make_disc({0, 0}, -3.0)}), "not -3"},
        BadShape{"swallowed", make_difference(unit(), {make_disc({0.5, 0.5}, 2.0)}),
                 "hole 1 swallows the whole body"},
        BadShape{"the_same_box", make_difference(unit(), {unit()}), "swallows"},
        BadShape{"hole_outside", make_difference(unit(), {make_disc({5, 5}, 1.0)}),
                 "hole 1 lies outside the body"},
        BadShape{"nothing_left",
                 make_difference(unit(),
                                 {make_box<2>({-1, -1}, {0.5, 2}), make_box<2>({0.5, -1}, {2, 2})}),
                 "together leave nothing"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Validate, RefusesEmptyIntervals) {
  EXPECT_THROW(validate(make_interval(1.0, 1.0)), InputError);
  EXPECT_THROW(validate(make_interval(1.0, 0.0)), InputError);
  EXPECT_THROW(validate(make_interval(0.0, infinite)), InputError);
  EXPECT_NO_THROW(validate(make_interval(0.0, 1e-9)));
}

TEST(Validate, AcceptsBodiesOfEverySizeAndSense) {
  for (const double size : {1e-6, 1.0, 1e5}) {
    const Vector<2> corner = Vector<2>::Constant(size);
    EXPECT_NO_THROW(validate(make_box<2>(-corner, corner)));
    EXPECT_NO_THROW(validate(make_disc(corner, size)));
    EXPECT_NO_THROW(validate(make_polygon({{0, 0}, {0, size}, {size, 0}})));  // clockwise
    EXPECT_NO_THROW(
        validate(make_difference(make_box<2>({0, 0}, corner), {make_disc(corner, size / 3)})));
  }
  EXPECT_NO_THROW(validate(make_polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})));
}

}  // namespace
}  // namespace tlsph
