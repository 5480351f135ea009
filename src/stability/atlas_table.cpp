// An atlas on the screen and in its files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <set>

#include "tlsph/io/files.hpp"
#include "tlsph/io/table.hpp"
#include "tlsph/stability/atlas.hpp"

namespace tlsph {
namespace {

// Of each verdict, in the order of its values.
constexpr std::array verdict_names = {"refused", "material", "negative",
                                      "growing", "soft",     "stable"};
constexpr std::string_view verdict_letters = "RmNGs.";

std::string short_number(double value) {
  if (std::isnan(value)) return "-";
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  return size >= 1e-2 && size < 1e4 ? fmt::format("{:.3f}", value) : fmt::format("{:.1e}", value);
}

/// The range of a quantity over the rows of a method.
template <class Quantity>
std::string range_of(const std::vector<const AtlasRow*>& rows, const Quantity& quantity) {
  std::set<double> values;
  for (const AtlasRow* row : rows)
    if (const double value = quantity(*row); std::isfinite(value)) values.insert(value);
  if (values.empty()) return short_number(not_known);
  const std::string low = short_number(*values.begin());
  return values.size() == 1 ? low : fmt::format("{} - {}", low, short_number(*values.rbegin()));
}

/// A letter a state: the stretches of one layout and Poisson ratio side by side.
std::string letters(const std::vector<const AtlasRow*>& rows) {
  std::string text;
  const AtlasRow* last = rows.front();
  for (const AtlasRow* row : rows) {
    if (row->jitter != last->jitter)
      text += " | ";
    else if (row->poisson != last->poisson)
      text += ' ';
    text += verdict_letters.at(static_cast<std::size_t>(row->verdict));
    last = row;
  }
  return text;
}

/// The values of the scene, each once.
std::set<double> values_of(const std::vector<AtlasRow>& rows, double AtlasRow::*value) {
  std::set<double> values;
  for (const AtlasRow& row : rows)
    if (row.body == "scene") values.insert(row.*value);
  return values;
}

/// The states of a method, or of a method on another body.
struct MethodStates {
  std::string name;
  std::vector<const AtlasRow*> rows;
};

std::vector<MethodStates> methods_of(const std::vector<AtlasRow>& rows) {
  std::vector<MethodStates> methods;
  for (const AtlasRow& row : rows) {
    const std::string name = row.body == "scene" ? row.method : row.method + ", " + row.body;
    if (methods.empty() || methods.back().name != name) methods.push_back({name, {}});
    methods.back().rows.push_back(&row);
  }
  return methods;
}

Table<MethodStates> method_table() {
  const auto step = [](const AtlasRow& row) { return row.stretch == 1.0 ? row.bound : not_known; };
  const auto share = [](const AtlasRow& row) {
    return row.verdict == Verdict::material ? not_known : row.bound / row.limit;
  };
  using Row = MethodStates;
  return {
      {"", &Row::name, {"method", "<40"}},
      {"", [=](const Row& row) { return range_of(row.rows, step); }, {"c_p dt_crit/Δ", " >15"}},
      {"", [=](const Row& row) { return range_of(row.rows, share); }, {"of true limit", " >15"}},
      {"", [](const Row& row) { return letters(row.rows); }, {"states", "  <"}},
  };
}

/// −1 stands for a count that is not known.
template <class Row, class Count>
auto known(Count Row::*count) {
  return [count](const Row& row) { return row.*count < 0 ? Json(nullptr) : Json(row.*count); };
}

Table<PerturbedRun> run_table() {
  using Row = PerturbedRun;
  return {
      {"label", &Row::label},
      {"dt_ratio", &Row::ratio},
      {"growth_expected", &Row::expected},
      {"growth_seen", &Row::seen},
      {"amplitude", &Row::amplitude},
      {"energy_drift", &Row::energy_drift},
      {"steps", &Row::steps},
      {"lost_at", known(&Row::lost_at)},
  };
}

Table<AtlasRow> state_table() {
  using Row = AtlasRow;
  return {
      {"name", &Row::name},
      {"method", &Row::method},
      {"formulation", &Row::formulation},
      {"kernel", &Row::kernel},
      {"support", &Row::support},
      {"body", &Row::body},
      {"jitter", &Row::jitter},
      {"poisson", &Row::poisson},
      {"stretch", &Row::stretch},
      {"particles", known(&Row::particles)},
      {"verdict",
       [](const Row& row) { return verdict_names.at(static_cast<std::size_t>(row.verdict)); }},
      {"refusal", &Row::refusal},
      {"acoustic", &Row::acoustic},
      {"imbalance", &Row::imbalance},
      {"unrest", &Row::drift},
      {"critical_step", &Row::bound},
      {"true_limit", &Row::limit},
      {"soft_modes", known(&Row::zero_energy_modes)},
      {"excursion", &Row::excursion},
      {"negative", known(&Row::negative)},
      {"growth", &Row::growth},
      {"runs", [](const Row& row) { return run_table().json(row.runs); }, Medium::json},
  };
}

Table<WaveRow> wave_table() {
  using Row = WaveRow;
  return {
      {"method", &Row::method, {"method", "<40"}},
      {"poisson", &Row::poisson},
      {"transverse", &Row::transverse, {"transverse", " >10", short_number}},
      {"longitudinal", &Row::longitudinal, {"longitudinal", " >12", short_number}},
      {"anisotropy", &Row::anisotropy, {"anisotropy", " >10", short_number}},
      {"slowest", &Row::slowest, {"slowest", " >9", short_number}},
      {"zero_energy_waves", &Row::zero_energy, {"zero energy", " >11"}},
  };
}

Table<ContrastRow> contrast_table() {
  using Row = ContrastRow;
  return {
      {"dimension", &Row::dimension},
      {"stress", &Row::stress, {"stress [ρc²]", ">12g"}},
      {"growth_expected", &Row::expected, {"expected [c/Δ]", " >16", short_number}},
      {"growth_seen", &Row::seen, {"seen", " >10", short_number}},
      {"amplitude", &Row::amplitude, {"largest energy/first", " >22", short_number}},
  };
}

Table<CompressionRow> compression_table() {
  using Row = CompressionRow;
  const auto speed = [](double value) { return fmt::format("{:g}c", value); };
  const auto percent = [](double share) { return fmt::format("{:.1f}%", 100.0 * share); };
  const auto lost = [](const Row& row) { return row.failure.empty() ? "" : "lost"; };
  return {
      {"method", &Row::method, {"method", "<26"}},
      {"particles", &Row::particles, {"particles", " >9"}},
      {"motion", &Row::motion, {"motion", " <8"}},
      {"speed", &Row::speed, {"edge", " >6", speed}},
      {"follow", &Row::step, {"step", " <15"}},
      {"safety", &Row::safety},
      {"steps", &Row::steps, {"steps", " >7"}},
      {"looks", &Row::looks, {"looks", " >7"}},
      {"bounds", &Row::bounds, {"bounds", " >7"}},
      {"estimates", &Row::estimates, {"estimates", " >10"}},
      {"share", &Row::share, {"share", " >9", percent}},
      {"closest", &Row::closest, {"dt/dt_crit <=", " >14", short_number}},
      {"smallest_det_F", &Row::smallest, {"det F", " >7", short_number}},
      {"failure", &Row::failure},
      {"", lost, {"", "  <"}},
  };
}

Table<Failure> failure_table() {
  using Row = Failure;
  return {
      {"where", &Row::where},     {"what", &Row::what},     {"why", &Row::why},
      {"cure", &Row::cure},       {"states", &Row::states}, {"evidence", &Row::run},
      {"cured", &Row::cured_run},
  };
}

/// A line a run; a state without runs has one line too.
std::string states_csv(const std::vector<AtlasRow>& rows) {
  struct Line {
    AtlasRow state;
    PerturbedRun run;
  };
  std::vector<Line> lines;
  for (const AtlasRow& row : rows) {
    if (row.runs.empty()) lines.push_back({row, {}});
    for (const PerturbedRun& run : row.runs) lines.push_back({row, run});
  }
  return (state_table().of(&Line::state) + run_table().of(&Line::run)).csv(lines);
}

/// A line a wave vector.
std::string maps_csv(const Atlas& atlas) {
  struct Line {
    std::string method;
    double poisson;
    std::vector<double> values;
  };
  std::vector<Line> lines;
  for (const WaveRow& row : atlas.waves)
    for (const std::vector<double>& values : row.map)
      lines.push_back({row.method, row.poisson, values});
  std::vector<std::string> names = {"k_x", "k_y", "transverse", "longitudinal"};
  if (atlas.dimension == 1) names = {"k_x", "longitudinal"};
  Table<Line> table = {{"method", &Line::method}, {"poisson", &Line::poisson}};
  for (std::size_t c = 0; c < names.size(); ++c)
    table.add({names[c], [c](const Line& line) { return line.values[c]; }});
  return table.csv(lines);
}

std::string states_text(const Atlas& atlas) {
  return fmt::format(
             "States: a letter each, stretches {:g} side by side, then Poisson ratios {:g}, then "
             "layouts (jitter {:g});\nnot every method has all of them.  . stable  m material not "
             "hyperbolic  N ω² < 0  G growing  s modes without energy  R refused\n\n",
             fmt::join(values_of(atlas.rows, &AtlasRow::stretch), " "),
             fmt::join(values_of(atlas.rows, &AtlasRow::poisson), " "),
             fmt::join(values_of(atlas.rows, &AtlasRow::jitter), " ")) +
         method_table().text(methods_of(atlas.rows));
}

/// A table below a line of what it holds; nothing where it has no rows.
template <class Row>
std::string titled(const std::string& title, const Table<Row>& table,
                   const std::vector<Row>& rows) {
  return rows.empty() ? "" : "\n" + title + "\n\n" + table.text(rows);
}

}  // namespace

std::string Atlas::text() const {
  std::string text = rows.empty() ? "" : states_text(*this);
  text += titled(
      "Waves on the lattice, 8 spacings long: |c/c0 - 1| and its spread over directions; slowest "
      "c/c0 and waves without energy of the zone",
      wave_table(), waves);
  text += titled(fmt::format("Updated Lagrangian, {}D, cubic spline, support 2.4", dimension),
                 contrast_table(), contrast);
  text += titled("Compression to a stretch of 0.2 at 0.95 of the critical step",
                 compression_table(), compression);
  const Safety safe = safety();
  if (safe.stable_states > 0)
    text += fmt::format(
        "\nThe computed critical step is {:.3f} to {:.3f} of the true limit; of {} states that are "
        "stable below it, {} were lost at 0.95 of it.\n",
        safe.smallest_share, safe.largest_share, safe.stable_states, safe.lost_runs);
  for (const Failure& failure : failures)
    text += fmt::format(
        "\n{} ({} state{})\n  fails: {}\n  why:   {}\n  cure:  {}\n  run:   {}\n  "
        "cured: {}\n",
        failure.where, failure.states, failure.states == 1 ? "" : "s", failure.what, failure.why,
        failure.cure, failure.run, failure.cured_run);
  return text + fmt::format("\n{} states, {} methods' waves, {:.0f} s{}\n", rows.size(),
                            waves.size(), seconds, interrupted ? ", interrupted" : "");
}

void Atlas::write(const std::filesystem::path& directory) const {
  make_output_directory(directory);
  write_text_file(directory / "stability.csv", states_csv(rows));
  write_text_file(directory / "waves.csv", maps_csv(*this));
  Json json;
  json.set("scene", scene);
  json.set("version", version);
  json.set("dimension", dimension);
  json.set("seconds", seconds);
  json.set("interrupted", interrupted);
  const Safety step = safety();
  json.set("step.smallest_share", step.smallest_share);
  json.set("step.largest_share", step.largest_share);
  json.set("step.stable_states", step.stable_states);
  json.set("step.lost_runs", step.lost_runs);
  json.set("failures", failure_table().json(failures));
  json.set("waves", wave_table().json(waves));
  json.set("contrast", contrast_table().json(contrast));
  json.set("crush", compression_table().json(compression));
  json.set("rows", state_table().json(rows));
  json.write(directory / "stability.json");
}

}  // namespace tlsph
