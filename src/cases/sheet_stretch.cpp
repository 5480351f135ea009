// A Neo-Hookean sheet drawn out in two directions, and where a nearly incompressible one stops to
// carry waves.
#include <fmt/format.h>

#include <array>

#include "list.hpp"
#include "stretched.hpp"
#include "tlsph/materials/any_law.hpp"
#include "tlsph/materials/waves.hpp"

namespace tlsph {
namespace {

constexpr double young = 200e9;
constexpr double length = 0.015, width = 0.0025;
constexpr std::array formulations = {"thesis", "mirror", "variational", "stress-point"};

/// λ₂ while λ₁ goes from 1 to 6.
struct Path {
  const char* name;
  const char* figure;
  double start;  ///< λ₂ at λ₁ = 1
  double end;    ///< at λ₁ = 6

  [[nodiscard]] double second(double first) const {
    return start + (end - start) * (first - 1) / 5;
  }
};
constexpr std::array paths = {Path{"lambda2 = 1", "thesis, Fig. 5.10", 1.0, 1.0},
                              Path{"lambda2 = 2", "thesis, Fig. 5.11", 2.0, 2.0},
                              Path{"lambda2 from 1 to 2", "thesis, Fig. 5.12", 1.0, 2.0}};

/// Along `path`, λ₁ = 6 at the time `rise`, the run itself to `end`.
CaseScene draw(CaseRun& run, const std::string& label, const std::string& formulation,
               const Path& path, double poisson, double rise, double end,
               const std::string& extra) {
  // A width that stays is held by a constant: a ramp would have to start before the beginning.
  const std::string across =
      path.start == path.end
          ? fmt::format("curve=\"constant\", amplitude={}", width * (path.start - 1))
          : fmt::format("curve=\"ramp\", amplitude={}, rise={}", width * (path.end - 1), rise);
  Settings overrides = {
      "formulation=" + formulation,
      fmt::format("material.poisson={}", poisson),
      fmt::format("boundary[2].displacement.x.rise={}", rise),
      fmt::format("boundary[3].displacement.y={{{}}}", across),
      fmt::format("initial={{displacement={{gradient=[[0.0, 0.0], [0.0, {:.17g}]]}}, "
                  "velocity={{gradient=[[{:.17g}, 0.0], [0.0, {:.17g}]]}}}}",
                  path.start - 1, 5 / rise, (path.end - path.start) / rise),
      fmt::format("time.end={}", end),
      extra};
  // the four nearest neighbours: the sums of the collocated adjoint are exact at the edges then
  if (formulation == "variational") overrides.emplace_back("kernel.support=1.4");
  return run.scene(label, "sheet.toml", overrides);
}

/// Stretches imposed by the edges at the samples of the probes.
struct Imposed {
  std::vector<double> first, stress;  ///< λ₁, and the stress of (5.5) [Pa]
};

Imposed imposed(const CaseScene& scene, const Lame& constants) {
  Imposed result;
  const auto x = scene.probe("corner.displacement_x");
  const auto y = scene.probe("corner.displacement_y");
  for (std::size_t k = 0; k < x.size(); ++k) {
    result.first.push_back(1 + x[k] / length);
    result.stress.push_back(neo_hookean_cauchy(constants, result.first.back(), 1 + y[k] / width));
  }
  return result;
}

/// The largest difference of any component of F from that of the imposed stretches at the end.
double unevenness(const CaseScene& scene, const Path& path) {
  const std::vector<double> F = scene.frame("deformation_gradient", 1).value();
  const std::array expected = {6.0, 0.0, 0.0, path.end};
  double largest = 0.0;
  for (std::size_t k = 0; k < F.size(); ++k)
    largest = std::max(largest, std::abs(F[k] - expected[k % 4]));
  return largest;
}

void follow_law(CaseRun& run, const std::string& formulation) {
  constexpr double rise = 77.57e-6;
  const Claim claim = formulation == "thesis" ? reported() : at_most(1e-6);
  double uneven = 0.0;
  for (const Path& path : paths) {
    const CaseScene scene = draw(run, fmt::format("{}-{}-{}", formulation, path.start, path.end),
                                 formulation, path, 0.3, rise, rise, "output.frames=1");
    const Imposed law = imposed(scene, lame(young, 0.3));
    const double error =
        largest_deviation(law.first, scene.probe("centre.cauchy_xx"), law.stress, 6);
    const Checks check(run, fmt::format(", {}, {}", path.name, formulation));
    check(path.figure, "relative error of the stress up to lambda1 = 6", error, claim);
    if (formulation == "thesis" && path.end > path.start)
      run.check(path.figure, "lambda2 of the centre at lambda1 = 6, it should be 2, thesis",
                scene.probe("centre.deformation_gradient_yy").back(), reported());
    uneven = std::max(uneven, unevenness(scene, path));
  }
  run.check("thesis, sec. 5.4.3",
            "difference of F from the imposed one at lambda1 = 6, all particles, " + formulation,
            uneven, claim);
}

/// λ₁ where the slowest wave stops. Waves along the smaller stretch s are the first:
/// ρc² = μ + (μ + λ(1 − ln J))/s².
double limit_by_formula(const Path& path) {
  const Lame constants = lame(young, 0.49);
  return first_loss([&](double first) {
    const double second = path.second(first);
    const double s = std::min(first, second);
    return constants.mu * (s * s + 1) + constants.lambda * (1 - std::log(first * second));
  });
}

/// The same by the acoustic tensor of the tangent, over all directions.
double limit_by_tangent(const Path& path) {
  const auto law = make_law<2>(LawName::neo_hookean, Assumption::strain, young, 0.49);
  return first_loss([&](double first) {
    Tensor<2> H = Tensor<2>::Zero();
    H(0, 0) = first - 1;
    H(1, 1) = path.second(first) - 1;
    return is_hyperbolic<2>(tangent<2>(law, H)) ? 1.0 : -1.0;
  });
}

void lose_waves(CaseRun& run, const Path& path) {
  constexpr double rise = 775.7e-6;
  const double limit = limit_by_formula(path);
  const std::string source = "slowest wave, rho c^2 = 0";
  run.check(source,
            fmt::format("lambda1 at the loss of hyperbolicity, {}, acoustic tensor", path.name),
            limit_by_tangent(path), relative(limit, 1e-9));
  for (const std::string formulation : {"mirror", "variational", "stress-point"}) {
    const CaseScene scene =
        draw(run, fmt::format("{}-{}-{}-0.49", formulation, path.start, path.end), formulation,
             path, 0.49, rise, (limit + 0.02 - 1) / 5 * rise, "output.energy_every=2");
    const auto& loss = scene.summary.hyperbolicity_lost;
    // the principal stretches are sorted, the largest first
    const std::size_t along = limit > path.second(limit) ? 0 : 1;
    run.check(
        source,
        fmt::format("local lambda1 at the loss of hyperbolicity, {}, {}", path.name, formulation),
        loss ? loss->stretches[along] : std::nan(""), relative(limit, 2e-3));
  }
}

}  // namespace

void sheet_stretch(CaseRun& run) {
  for (const std::string formulation : formulations) follow_law(run, formulation);
  for (const Path& path : paths) lose_waves(run, path);
}

}  // namespace tlsph
