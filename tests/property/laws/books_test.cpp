/// The books of a linear run close: what is gained or lost is what crossed the boundary or was
/// damped.

#include "property/bodies.hpp"

namespace tlsph::property {
namespace {

struct Entry {
  double energy = 0.0;       ///< kinetic and elastic
  double lagging = 0.0;      ///< ¼ Δt v·C v of the velocity half a step back
  double unexplained = 0.0;  ///< E − E₀ − W + dissipated
  double impulse_error = 0.0;
  double angular_error = 0.0;
  double work = 0.0;
  double dissipated = 0.0;
};

/// The books of every step of a run, from the scene's initial state.
std::vector<Entry> books_of(const Scene& scene, double share_of_critical, long steps) {
  std::vector<Entry> entries;
  discretised(scene, [&]<int D>(const Discretisation<D>& body) {
    InitialState<D> initial = build_initial<D>(scene, body);
    State<D> state = make_state<D>(body, initial.displacement, initial.velocity);
    evaluate<D>(body, state);
    const double dt = share_of_critical * critical_step<D>(body, state).dt;
    Balance<D> first;
    double gravity = 0.0;
    march<D>(body, state, dt, steps, 1, [&](const State<D>& now, const WorkAndImpulse<D>& ledger) {
      const Balance<D> books = balance<D>({body, now, dt});
      if (now.step == 0) {
        first = books;
        gravity = books.gravity;
      }
      Entry entry;
      entry.energy = books.kinetic + books.elastic;
      if (body.viscosity.nonZeros() > 0)
        entry.lagging = 0.25 * dt * now.viscous.cwiseProduct(now.v).sum();
      entry.work = ledger.external_work + books.gravity - gravity;
      entry.dissipated = ledger.dissipated;
      entry.unexplained =
          entry.energy - first.kinetic - first.elastic - entry.work + entry.dissipated;
      entry.impulse_error = (books.linear_momentum - first.linear_momentum - ledger.impulse).norm();
      entry.angular_error =
          std::abs(books.angular_momentum - first.angular_momentum - ledger.angular_impulse);
      entries.push_back(entry);
    });
  });
  return entries;
}

double largest(const std::vector<Entry>& entries, double Entry::*value) {
  double most = 0.0;
  for (const Entry& entry : entries) most = std::max(most, std::abs(entry.*value));
  return most;
}

class Books : public testing::TestWithParam<Variant> {};

std::string initial_velocity(const Variant& variant) {
  return variant.one_dimensional() ? "initial.velocity={constant=[0.1], gradient=[[0.6]]}"
                                   : "initial.velocity={gradient=[[2.0, 1.0], [-0.5, -1.5]]}";
}

Scene damped_scene(const Variant& variant) {
  return scene_of(variant, {"stabiliser.kind=" + variant.stabiliser(), "stabiliser.as=viscosity",
                            initial_velocity(variant)});
}

/// What viscosity takes is what is missing, to round-off, at the largest step the scene may choose.
TEST_P(Books, ViscosityAccountsForAllLostEnergy) {
  const auto entries = books_of(damped_scene(GetParam()), 0.9, 400);

  EXPECT_LE(largest(entries, &Entry::unexplained), 1e-10 * entries.front().energy);
  EXPECT_GT(entries.back().dissipated, 0.0);
}

/// With viscous forces half a step late, E_n + ¼ Δt v_{n−½}ᵀ C v_{n−½} falls in each step by
/// ¼ Δt (v_{n−½} + v_{n+½})ᵀ C (v_{n−½} + v_{n+½}), whatever the step.
TEST_P(Books, ViscosityNeverAddsEnergy) {
  const auto entries = books_of(damped_scene(GetParam()), 0.9, 1000);

  const double slack = 1e-13 * entries.front().energy;
  for (std::size_t n = 1; n < entries.size(); ++n)
    ASSERT_LE(entries[n].energy + entries[n].lagging,
              entries[n - 1].energy + entries[n - 1].lagging + slack)
        << "step " << n;
  EXPECT_LT(entries.back().energy, entries.front().energy * (1.0 - 1e-6));
}

/// A body drawn at one end, held at the other, loaded and heavy: all work and impulse is booked.
TEST_P(Books, MovedSupportsAndLoadsAccountForAllWork) {
  const bool bar = GetParam().one_dimensional();
  const std::string moved = "displacement={x={curve=\"smooth-ramp\", amplitude=1e-3, rise=2e-3}}";
  std::string boundary = "boundary=[{where=\"right\", " + moved + "}";
  if (!bar) boundary += ", {where=\"left\", fixed=true}, {where=\"top\", traction=-2e3}";
  const auto entries = books_of(
      scene_of(GetParam(), {boundary + "]", bar ? "gravity=[-9.81]" : "gravity=[1.0, -9.81]"}), 0.9,
      600);

  const double energy = largest(entries, &Entry::energy);
  EXPECT_GT(largest(entries, &Entry::work), 0.1 * energy);
  EXPECT_LE(largest(entries, &Entry::unexplained), 1e-10 * energy);
  const double velocity = std::sqrt(2.0 * energy / density);  // of a square metre
  EXPECT_LE(largest(entries, &Entry::impulse_error), 1e-10 * density * velocity);
  if (GetParam().linear_exact()) {
    EXPECT_LE(largest(entries, &Entry::angular_error), 1e-10 * density * velocity);
  }
}

std::vector<Variant> boxes() {
  std::vector<Variant> chosen;
  for (const Variant& variant : adjoint_variants())
    if (variant.layout != "disc" && variant.layout != "hole" && !variant.on_triangles())
      chosen.push_back(variant);
  return chosen;
}

INSTANTIATE_TEST_SUITE_P(, Books, testing::ValuesIn(boxes()), ByName());

}  // namespace
}  // namespace tlsph::property
