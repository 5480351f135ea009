#pragma once
/// \file
/// Random bodies of scattered points as a user would bring them: even divisions of the outline, and
/// points inside that are a shaken lattice or as far apart as chance leaves them.

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "property/bodies.hpp"
#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph::property {

/// A shape, as a scene writes it, and points in it.
struct RandomCloud {
  std::string name;
  std::string shape;
  std::vector<Vector<2>> points;
};

namespace clouds {

inline std::string text_of(const std::vector<Vector<2>>& corners) {
  std::string text = "{ polygon = [";
  for (const Vector<2>& x : corners) text += fmt::format("[{}, {}], ", x.x(), x.y());
  return text + "] }";
}

inline std::string box_of(double width, double height) {
  return fmt::format("{{ box = [[0.0, 0.0], [{}, {}]] }}", width, height);
}

inline std::string without_disc(double width, double height, const Vector<2>& centre,
                                double radius) {
  return fmt::format("{{ difference = [ {}, {{ disc = {{ centre = [{}, {}], radius = {} }} }} ] }}",
                     box_of(width, height), centre.x(), centre.y(), radius);
}

/// Boxes, wedges of 20° … 70°, trapezia, plates with a hole, boxes with a shallow arc, discs; each
/// about one in size.
inline std::pair<std::string, std::string> random_shape(int kind, Random& random) {
  const auto between = [&](double a, double b) { return a + 0.5 * (b - a) * (random() + 1.0); };
  switch (kind) {
    case 0:
      return {"box", box_of(1.0, between(0.5, 1.0))};
    case 1: {
      const double angle = between(20.0, 70.0) * std::numbers::pi / 180.0;
      const double length = between(0.7, 1.3);
      return {"wedge", text_of({{0.0, 0.0},
                                {1.2, 0.0},
                                {1.2 * length * std::cos(angle), 1.2 * length * std::sin(angle)}})};
    }
    case 2:
      return {"trapezium", text_of({{0.0, 0.0},
                                    {1.0, 0.0},
                                    {between(0.5, 0.9), 1.0},
                                    {between(-0.2, 0.3), between(0.7, 1.0)}})};
    case 3: {
      const double radius = between(0.12, 0.25);
      return {"hole", without_disc(1.0, 1.0, {between(0.4, 0.6), between(0.4, 0.6)}, radius)};
    }
    case 4: {
      const double radius = std::pow(10.0, between(0.0, 3.0));
      return {"arc", without_disc(1.0, 0.8, {0.5, between(0.05, 0.15) - radius}, radius)};
    }
    default:
      return {"disc", fmt::format("{{ disc = {{ centre = [0.1, -0.2], radius = {} }} }}",
                                  between(0.4, 0.6))};
  }
}

}  // namespace clouds

/// The body with that number, the same on every machine: 150 to 500 points.
inline RandomCloud random_cloud(int number) {
  Random random(static_cast<std::uint64_t>(1000 + number));
  RandomCloud cloud;
  const auto [kind, shape_text] = clouds::random_shape(number % 6, random);
  cloud.shape = shape_text;
  const Scene scene = read_scene_text(
      "dimension = 2\n[body]\nspacing = 0.1\nshape = " + cloud.shape +
          "\n[material]\nlaw = \"linear-elastic\"\nyoung = 1.0\npoisson = 0.3\ndensity = "
          "1.0\n[time]\nend = 1.0\n",
      "shape");
  const auto& shape = std::get<Shape<2>>(scene.body.shape);
  const double distance = std::sqrt(area(shape) / (150.0 + 175.0 * (random() + 1.0)));
  for (const OutlineLoop& loop : outline_loops(shape))
    for (const OutlinePiece& piece : loop) {
      const int parts = std::max(1, static_cast<int>(std::lround(piece.length() / distance)));
      for (int k = 0; k < parts; ++k) cloud.points.push_back(piece.at(double(k) / parts));
    }
  const Box<2> box = bounding_box(shape);
  const bool shaken = number / 6 % 2 == 0;
  cloud.name = fmt::format("{}_{}_{}", kind, shaken ? "shaken" : "scattered", number);
  const double clear = shaken ? 0.55 : 0.7;  // of that, between points
  const auto add = [&](const Vector<2>& x) {
    if (depth(shape, x) < 0.5 * clear * distance) return false;
    for (const Vector<2>& other : cloud.points)
      if ((x - other).norm() < clear * distance) return false;
    cloud.points.push_back(x);
    return true;
  };
  if (shaken) {
    for (double x = box.lower.x(); x < box.upper.x(); x += distance)
      for (double y = box.lower.y(); y < box.upper.y(); y += distance)
        add({x + 0.3 * distance * random(), y + 0.3 * distance * random()});
  } else {
    for (int misses = 0; misses < 3000;) {
      const Vector<2> half = 0.5 * (box.upper - box.lower);
      const Vector<2> x = box.lower + half + half.cwiseProduct(Vector<2>(random(), random()));
      misses = add(x) ? 0 : misses + 1;
    }
  }
  return cloud;
}

/// The scene of that body with default settings but for what `settings` says.
inline Scene scene_of(const RandomCloud& cloud, const std::string& formulation,
                      const std::vector<std::string>& settings = {}) {
  struct PointsFile {
    PointsFile() = default;
    PointsFile(const PointsFile&) = delete;
    PointsFile& operator=(const PointsFile&) = delete;
    ~PointsFile() { std::filesystem::remove(path); }
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("tlsph_random_{}.csv", ::getpid());
  };
  static const PointsFile points;
  const std::filesystem::path& file = points.path;
  std::ofstream out(file);
  out << "x,y\n";
  for (const Vector<2>& x : cloud.points) out << fmt::format("{},{}\n", x.x(), x.y());
  out.close();
  return read_scene_text("dimension = 2\nformulation = \"" + formulation +
                             "\"\n[body]\nshape = " + cloud.shape + "\ncloud = \"" + file.string() +
                             "\"\n[material]\nlaw = \"linear-elastic\"\nyoung = 2e6\npoisson = "
                             "0.3\ndensity = 1000\n[time]\nend = 1.0\n[output]\nframes = 0\n",
                         cloud.name, settings);
}

}  // namespace tlsph::property
