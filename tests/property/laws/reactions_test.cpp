/// In `mirror` and `thesis` the work and the impulse of supports are those of the stress on the
/// boundary: the books of a body between them close as well as its operators differentiate.

#include "property/bodies.hpp"

namespace tlsph::property {
namespace {

struct Drift {
  double energy = 0.0;   ///< max |E − E₀ − W| over max E
  double impulse = 0.0;  ///< max |p − p₀ − ∫R dt| over the largest Σ m |v|
  double work = 0.0;     ///< max |W| over max E
};

Drift drift_of(const Scene& scene, double share_of_critical) {
  Drift drift;
  discretised(scene, [&]<int D>(const Discretisation<D>& body) {
    State<D> state = make_state<D>(body, VectorField<D>::Zero(body.nodes(), D),
                                   VectorField<D>::Zero(body.nodes(), D));
    evaluate<D>(body, state);
    const double dt = share_of_critical * critical_step<D>(body, state).dt;
    double energy = 0.0, momentum = 0.0;
    march<D>(body, state, dt, static_cast<long>(scene.time.end / dt), 1,
             [&](const State<D>& now, const WorkAndImpulse<D>& ledger) {
               const Balance<D> books = balance<D>({body, now, dt});
               const double has = books.kinetic + books.elastic;
               energy = std::max(energy, has);
               momentum = std::max(momentum, books.momentum_scale);
               drift.work = std::max(drift.work, std::abs(ledger.external_work));
               drift.energy = std::max(drift.energy, std::abs(has - ledger.external_work));
               drift.impulse =
                   std::max(drift.impulse, (books.linear_momentum - ledger.impulse).norm());
             });
    drift.energy /= energy;
    drift.work /= energy;
    drift.impulse /= momentum;
  });
  return drift;
}

/// A bar of 1 m, c = 45 m/s, whose right end is drawn by 5 mm in 20 ms; it swings on.
Scene drawn_bar(const std::string& formulation, int cells, const std::string& law) {
  return read_scene_text("dimension = 1\nformulation = \"" + formulation + "\"\n" + R"(
[body]
shape = { interval = [0.0, 1.0] }
[kernel]
support = 2.5
[material]
assumption = "stress"
young = 2e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
displacement = { x = { curve = "smooth-ramp", amplitude = 5e-3, rise = 0.02 } }
[time]
end = 0.1
)",
                         formulation,
                         {"body.spacing=" + std::to_string(1.0 / cells), "material.law=" + law});
}

/// The forces of `mirror` do the work of its stress, that of a moved edge included: what is left is
/// what a central difference leaves, nothing for a linear law and a share that falls with Δt² for
/// another one. Momentum is booked by the stress at the edge, good to the square of the spacing.
TEST(DrawnBar, OfMirrorHasItsSupportsBooked) {
  for (const char* law : {"linear-elastic", "neo-hookean"}) {
    SCOPED_TRACE(law);
    const bool linear = law[0] == 'l';
    const Drift coarse = drift_of(drawn_bar("mirror", 50, law), 0.5);
    const Drift fine = drift_of(drawn_bar("mirror", 100, law), 0.5);

    EXPECT_GT(fine.work, 0.5);
    EXPECT_LE(coarse.energy, linear ? 1e-12 : 2e-5);
    EXPECT_LE(fine.energy, linear ? 1e-12 : 4e-6);
    EXPECT_LE(fine.impulse, 1e-3);
    EXPECT_GE(coarse.impulse, 3.5 * fine.impulse);
  }
}

/// Those of `thesis` do not: near its edges they are good to the first power of the spacing.
TEST(DrawnBar, OfThesisHasItsSupportsBookedToFirstOrder) {
  for (const char* law : {"linear-elastic", "neo-hookean"}) {
    SCOPED_TRACE(law);
    const Drift coarse = drift_of(drawn_bar("thesis", 50, law), 0.5);
    const Drift fine = drift_of(drawn_bar("thesis", 100, law), 0.5);

    EXPECT_GT(fine.work, 0.5);
    EXPECT_LE(fine.energy, 0.04);
    EXPECT_LE(fine.impulse, 0.035);
    EXPECT_GE(coarse.energy, 1.8 * fine.energy);
    EXPECT_GE(coarse.impulse, 1.8 * fine.impulse);
  }
}

/// The same of a sheet between smooth walls.
TEST(DrawnSheet, OfMirrorHasItsSupportsBooked) {
  const Drift drift = drift_of(read_scene_text(R"(
formulation = "mirror"
[body]
shape = { box = [[0.0, 0.0], [1.0, 0.4]] }
spacing = 0.05
[material]
law = "linear-elastic"
young = 2e6
poisson = 0.3
density = 1000
[[boundary]]
where = "bottom"
symmetry = true
[[boundary]]
where = "top"
symmetry = true
[[boundary]]
where = "left"
fixed = "x"
[[boundary]]
where = "right"
displacement = { x = { curve = "smooth-ramp", amplitude = 5e-3, rise = 0.02 } }
[time]
end = 0.1
)",
                                               "sheet", {}),
                               0.5);

  EXPECT_GT(drift.work, 0.5);
  EXPECT_LE(drift.energy, 1e-12);
  EXPECT_LE(drift.impulse, 0.02);
}

}  // namespace
}  // namespace tlsph::property
