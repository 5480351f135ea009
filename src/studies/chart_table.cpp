// A chart on the screen and in its files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/studies/chart.hpp"
#include "tlsph/studies/chart_search.hpp"

namespace tlsph {
namespace {

std::string name_of(const ChartPoint& point) {
  return point.peer.empty() ? point.family : point.peer;
}

std::string range_of(const ChartPoint& point) {
  if (point.seconds.size() < 2) return "";
  const auto [least, most] = std::ranges::minmax(point.seconds);
  return fmt::format("{:.2g}-{:.2g}", least, most);
}

/// Points of quantity q that count, fastest first.
std::vector<const ChartPoint*> sorted(const ChartTable& table, std::size_t q, auto wanted) {
  std::vector<const ChartPoint*> points;
  for (const ChartPoint& point : table.points)
    if (point.failure.empty() && std::isfinite(point.judged[q]) && wanted(point))
      points.push_back(&point);
  std::ranges::sort(points, {}, [](const ChartPoint* point) { return point->time(); });
  return points;
}

/// When this program is as near as `error`, by the straight line in logarithms between the points
/// of its own front; not a number beyond their ends.
double time_for(const std::vector<const ChartPoint*>& front, std::size_t q, double error) {
  for (std::size_t k = 0; k < front.size(); ++k) {
    const double here = front[k]->judged[q];
    if (here > error) continue;
    if (k == 0) return front[k]->time();  // even its fastest is nearer
    const double before = front[k - 1]->judged[q];
    const double share = std::log(before / error) / std::log(before / here);
    return front[k - 1]->time() * std::pow(front[k]->time() / front[k - 1]->time(), share);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<const ChartPoint*> own_front(const ChartTable& table, std::size_t q) {
  const auto points = sorted(table, q, [](const ChartPoint& p) { return p.peer.empty(); });
  std::vector<double> times;
  std::vector<double> errors;
  for (const ChartPoint* point : points) {
    times.push_back(point->time());
    errors.push_back(point->judged[q]);
  }
  const std::vector<bool> on = pareto_front(times, errors);
  std::vector<const ChartPoint*> front;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (on[k]) front.push_back(points[k]);
  return front;
}

std::string quantity_text(const ChartTable& table, std::size_t q) {
  std::string text = fmt::format("\n{}", table.quantities[q]);
  if (std::isfinite(table.answers[q]))
    text += fmt::format(" = {:.6g}; an error counts no better than that of the next finer spacing",
                        table.answers[q]);
  text += fmt::format("\n{:>12} {:>17} {:>11} {:>12} {:>10}  {}\n", "time [s]", "range", "error",
                      "spacing [m]", "particles", "configuration");
  for (const ChartPoint* point : sorted(table, q, [&](const ChartPoint& p) { return p.front[q]; }))
    text += fmt::format("{:>12.3g} {:>17} {:>11.3e} {:>12.5g} {:>10}  {}\n", point->time(),
                        range_of(*point), point->judged[q], point->spacing, point->particles,
                        name_of(*point));
  const auto peers = sorted(table, q, [](const ChartPoint& p) { return !p.peer.empty(); });
  if (peers.empty()) return text;
  const auto front = own_front(table, q);
  text +=
      fmt::format("{:>12} {:>17} {:>11} {:>12} {:>10}  {}\n", "time [s]", "range", "error",
                  "spacing [m]", "particles", "peer, and the time of this program's front there");
  for (const ChartPoint* point : peers) {
    const double own = time_for(front, q, point->judged[q]);
    text += fmt::format("{:>12.3g} {:>17} {:>11.3e} {:>12.5g} {:>10}  {}", point->time(),
                        range_of(*point), point->judged[q], point->spacing, point->particles,
                        point->peer);
    text += std::isfinite(own) ? fmt::format(": {:.3g} s, {:.3g} of it\n", own, own / point->time())
                               : ": not reached\n";
  }
  return text;
}

std::string csv_text(const ChartTable& table) {
  std::string csv =
      "peer,family,formulation,kernel,support,order,stabiliser,law,step_share,spacing,particles,"
      "steps,setup_seconds,stepping_seconds,stepping_seconds_min,stepping_seconds_max,repetitions";
  const auto end = std::back_inserter(csv);
  for (const std::string& quantity : table.quantities) fmt::format_to(end, ",{}", quantity);
  for (const std::string& quantity : table.quantities) fmt::format_to(end, ",judged_{}", quantity);
  for (const std::string& quantity : table.quantities) fmt::format_to(end, ",front_{}", quantity);
  csv += ",failure\n";
  for (const ChartPoint& point : table.points) {
    const auto [least, most] = point.seconds.empty() ? std::ranges::minmax_result<double>{}
                                                     : std::ranges::minmax(point.seconds);
    fmt::format_to(end, "{},{},{},{},{},{},{},{},{},{:.17g},{},{},{},{},{},{},{}", point.peer,
                   csv_field(point.family), point.formulation, point.kernel,
                   point.support ? fmt::format("{}", *point.support) : "",
                   point.order > 0 ? fmt::format("{}", point.order) : "", point.stabiliser,
                   point.law, point.step_share ? fmt::format("{}", *point.step_share) : "",
                   point.spacing, point.particles, point.steps, csv_number(point.setup_seconds),
                   csv_number(point.time()), csv_number(least), csv_number(most),
                   point.seconds.size());
    for (const double error : point.errors) fmt::format_to(end, ",{}", csv_number(error));
    for (const double error : point.judged) fmt::format_to(end, ",{}", csv_number(error));
    for (std::size_t q = 0; q < table.quantities.size(); ++q)
      fmt::format_to(end, ",{}", point.front[q] ? 1 : 0);
    fmt::format_to(end, ",{}\n", csv_field(point.failure));
  }
  return csv;
}

Json point_json(const ChartPoint& point, const ChartTable& table) {
  Json json;
  json.set("peer", point.peer);
  json.set("family", point.family);
  json.set("set", point.overrides);
  json.set("formulation", point.formulation);
  json.set("kernel", point.kernel);
  json.set("support", point.support);
  json.set("order", point.order);
  json.set("stabiliser", point.stabiliser);
  json.set_or_null("law", point.law);
  json.set("step_share", point.step_share);  // of the critical step
  json.set("spacing", point.spacing);
  json.set("particles", point.particles);
  json.set("steps", point.steps);
  json.set("setup_seconds", point.setup_seconds);
  json.set("stepping_seconds", point.seconds);
  json.set("errors", point.errors);  // in the order of `quantities`
  json.set("judged", point.judged);
  std::vector<std::string> fronts;
  for (std::size_t q = 0; q < table.quantities.size(); ++q)
    if (point.front[q]) fronts.push_back(table.quantities[q]);
  json.set("front", fronts);
  json.set_or_null("failure", point.failure);
  return json;
}

/// Fills `judged`, family by family. Peers keep their luck: nobody chose among many of them.
void judge(ChartTable& table) {
  std::map<std::string, std::vector<ChartPoint*>> families;
  for (ChartPoint& point : table.points) {
    point.judged.assign(table.quantities.size(), std::numeric_limits<double>::quiet_NaN());
    if (!point.failure.empty()) continue;
    if (point.peer.empty())
      families[point.family].push_back(&point);
    else
      point.judged = point.errors;
  }
  for (auto& [name, members] : families) {
    std::ranges::sort(members, std::greater(), &ChartPoint::spacing);
    std::vector<Measured> runs;
    for (const ChartPoint* point : members)
      runs.push_back({point->spacing, 0.0, 0.0, point->errors});
    runs = judged(std::move(runs), table.single_numbers());
    for (std::size_t k = 0; k < members.size(); ++k) members[k]->judged = runs[k].errors;
  }
}

}  // namespace

double ChartPoint::time() const {
  if (seconds.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values = seconds;
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

std::vector<bool> pareto_front(const std::vector<double>& times,
                               const std::vector<double>& errors) {
  std::vector<bool> front;
  for (std::size_t k = 0; k < times.size(); ++k) {
    bool on = std::isfinite(times[k]) && std::isfinite(errors[k]);
    for (std::size_t other = 0; other < times.size() && on; ++other)
      on = !(times[other] <= times[k] && errors[other] <= errors[k] &&
             (times[other] < times[k] || errors[other] < errors[k]));
    front.push_back(on);
  }
  return front;
}

std::vector<bool> ChartTable::single_numbers() const {
  std::vector<bool> single;
  for (const double answer : answers) single.push_back(std::isfinite(answer));
  return single;
}

void ChartTable::mark_fronts() {
  judge(*this);
  std::vector<double> times;
  for (ChartPoint& point : points) {
    times.push_back(point.time());
    point.front.assign(quantities.size(), false);
  }
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    std::vector<double> errors;
    for (const ChartPoint& point : points) errors.push_back(point.judged[q]);
    const std::vector<bool> on = pareto_front(times, errors);
    for (std::size_t k = 0; k < points.size(); ++k) points[k].front[q] = on[k];
  }
}

std::string ChartTable::text() const {
  const auto failed =
      std::ranges::count_if(points, [](const ChartPoint& p) { return !p.failure.empty(); });
  std::string text = fmt::format(
      "{} configurations of {} families and {} variants of law and step in {:.0f} s on {} "
      "thread{}; "
      "{} families refused by the scene, {} left behind, {} runs failed\n",
      points.size(), families, variants, spent, threads, threads == 1 ? "" : "s", refused,
      dominated, failed);
  for (std::size_t q = 0; q < quantities.size(); ++q) text += quantity_text(*this, q);
  for (const std::string& note : notes) text += "\n" + note;
  if (!notes.empty()) text += "\n";
  if (interrupted) text += "\ninterrupted: what was done\n";
  return text;
}

void ChartTable::write(const std::filesystem::path& directory) const {
  write_text_file(directory / "chart.csv", csv_text(*this));
  Json json;
  json.set("scene", scene);
  json.set("version", version);
  json.set("budget", budget);
  json.set("spent", spent);
  json.set("threads", threads);
  json.set("quantities", quantities);
  json.set("answers", answers);
  json.set("families", families);
  json.set("variants", variants);
  json.set("refused", refused);
  json.set("dominated", dominated);
  json.set("notes", notes);
  json.set("interrupted", interrupted);
  json.make_list("points");
  for (const ChartPoint& point : points) json.append("points", point_json(point, *this));
  json.write(directory / "chart.json");
}

}  // namespace tlsph
