/// Each row of the table of formulations against what is built of it.

#include <gtest/gtest.h>

#include "tlsph/dynamics/state.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

Scene strip(const std::string& keys) {
  return read_scene_text(keys + R"(
[body]
shape = { box = [[0.0, 0.0], [0.4, 0.2]] }
spacing = 0.02
[material]
young = 2e6
poisson = 0.25
density = 1000
[[boundary]]
where = "left"
fixed = "x"
[[boundary]]
where = "right"
traction = { curve = "ramp", amplitude = 1e3, rise = 1e-3 }
[[boundary]]
where = "top"
symmetry = true
[[boundary]]
where = "bottom"
symmetry = true
[time]
end = 1e-3
)",
                         "strip.toml");
}

Scene bar(const std::string& keys) {
  return read_scene_text("dimension = 1\n" + keys + R"(
[body]
shape = { interval = [0.0, 0.4] }
spacing = 0.02
[material]
young = 2e6
poisson = 0.25
density = 1000
[[boundary]]
where = "left"
displacement = { x = { curve = "smooth-ramp", amplitude = 1e-3, rise = 1e-3 } }
[[boundary]]
where = "right"
traction = { curve = "ramp", amplitude = 1e3, rise = 1e-3 }
[time]
end = 1e-3
)",
                         "bar.toml");
}

std::string formulation(const FormulationTraits& row) {
  return "formulation = \"" + std::string(row.name) + "\"\n";
}

TEST(FormulationTable, SaysWhatIsBuilt) {
  for (const FormulationTraits& row : formulation_table) {
    SCOPED_TRACE(std::string(row.name));
    const Scene scene = strip(formulation(row));
    const auto body = build<2>(scene);
    const bool natural = row.closure == Closure::natural;

    EXPECT_EQ(scene.formulation, row.formulation);
    EXPECT_EQ(body.points.size(), row.sites == StressSites::nodes ? body.nodes() : Index{20 * 10});
    EXPECT_EQ(body.adjoint, natural);
    EXPECT_EQ(body.signals.empty(), natural);
    EXPECT_EQ(body.ghosts != nullptr, row.closure == Closure::ghosts);
    EXPECT_EQ(body.consistency.has_value(), row.corrected == Corrected::always);
    EXPECT_EQ(body.hourglass.empty(), row.stabiliser[1] != StabiliserKind::cell);
    EXPECT_EQ(body.stiffness.nonZeros() > 0, row.stabiliser[1] == StabiliserKind::pair);
  }
}

TEST(FormulationTable, ListsTheNamesOfRows) {
  EXPECT_EQ(formulations_where([](const auto&) { return true; }),
            "thesis, mirror, variational, consistent or stress-point");
  EXPECT_EQ(formulations_where([](const auto& row) { return row.closure == Closure::ghosts; }),
            "thesis");
  EXPECT_EQ(adjoint_formulations(), "variational, consistent or stress-point");
}

/// Two steps, a copy, ten steps of both, one after the other and in turns.
template <int D>
void expect_copies_go_on_alike(const Scene& scene) {
  const auto body = build<D>(scene);
  const InitialState<D> initial = build_initial<D>(scene, body);
  const double dt = 0.1 * body.spacing / body.wave_speed();
  const auto step = [&](State<D>& state) {
    evaluate<D>(body, state);
    advance<D>(body, state, dt, state.time + dt);
  };
  State<D> state = make_state<D>(body, initial.displacement, initial.velocity);
  evaluate<D>(body, state);
  start<D>(body, state, dt);
  for (int n = 0; n < 2; ++n) step(state);

  State<D> copy = state;
  State<D> assigned = make_state<D>(body, initial.displacement, initial.velocity);
  assigned = state;
  for (int n = 0; n < 10; ++n) {
    step(state);
    step(copy);
  }
  for (int n = 0; n < 10; ++n) step(assigned);

  EXPECT_GT(state.u.cwiseAbs().maxCoeff(), 0.0);
  for (const State<D>* other : {&copy, &assigned}) {
    EXPECT_EQ(other->step, state.step);
    EXPECT_TRUE((other->u.array() == state.u.array()).all());
    EXPECT_TRUE((other->v.array() == state.v.array()).all());
    EXPECT_TRUE((other->P.array() == state.P.array()).all());
  }
}

TEST(State, IsAValue) {
  for (const FormulationTraits& row : formulation_table) {
    SCOPED_TRACE(std::string(row.name));
    expect_copies_go_on_alike<1>(bar(formulation(row)));
    expect_copies_go_on_alike<2>(strip(formulation(row)));
  }
  for (const char* closure : {"as-printed", "eta"}) {
    SCOPED_TRACE(closure);
    expect_copies_go_on_alike<1>(
        bar("formulation = \"thesis\"\nboundary_treatment = \"" + std::string(closure) + "\"\n"));
  }
}

}  // namespace
}  // namespace tlsph
