// A chart on the screen and in its files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tlsph/analysis/not_known.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/table.hpp"
#include "tlsph/studies/chart.hpp"
#include "tlsph/studies/chart_search.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

std::string name_of(const ChartPoint& point) {
  return point.peer.empty() ? point.family : point.peer;
}

std::ranges::minmax_result<double> fastest_and_slowest(const ChartPoint& point) {
  if (point.seconds.empty()) return {};
  return std::ranges::minmax(point.seconds);
}

std::string range_of(const ChartPoint& point) {
  if (point.seconds.size() < 2) return "";
  const auto [least, most] = fastest_and_slowest(point);
  return fmt::format("{:.2g}-{:.2g}", least, most);
}

/// Points of quantity q that count, fastest first, of equally fast ones the nearest.
std::vector<ChartPoint> sorted(const ChartTable& table, std::size_t q, auto wanted) {
  std::vector<ChartPoint> points;
  for (const ChartPoint& point : table.points)
    if (point.failure.empty() && std::isfinite(point.judged[q]) && wanted(point))
      points.push_back(point);
  std::ranges::sort(points, {}, [q](const ChartPoint& point) {
    return std::pair(point.time(), point.judged[q]);
  });
  return points;
}

/// When this program is as near as `error`, by the straight line in logarithms between the points
/// of its own front; not a number beyond their ends.
double time_for(const std::vector<ChartPoint>& front, std::size_t q, double error) {
  for (std::size_t k = 0; k < front.size(); ++k) {
    const double here = front[k].judged[q];
    if (here > error) continue;
    if (k == 0) return front[k].time();  // even its fastest is nearer
    const double before = front[k - 1].judged[q];
    const double share = std::log(before / error) / std::log(before / here);
    return front[k - 1].time() * std::pow(front[k].time() / front[k - 1].time(), share);
  }
  return not_known;
}

std::vector<ChartPoint> own_front(const ChartTable& table, std::size_t q) {
  std::vector<ChartPoint> front;
  for (const ChartPoint& point :
       sorted(table, q, [](const ChartPoint& p) { return p.peer.empty(); }))
    if (front.empty() || point.judged[q] < front.back().judged[q]) front.push_back(point);
  return front;
}

/// Points judged by quantity q on the screen, `last` behind the numbers.
Table<ChartPoint> screen_table(std::size_t q, Column<ChartPoint> last) {
  using Row = ChartPoint;
  Table<Row> table = {
      {"", &Row::time, {"time [s]", ">12.3g"}},
      {"", range_of, {"range", " >17"}},
      {"", [q](const Row& row) { return row.judged[q]; }, {"error", " >11.3e"}},
      {"", &Row::spacing, {"spacing [m]", " >12.5g"}},
      {"", &Row::particles, {"particles", " >10"}},
  };
  table.add(std::move(last));
  return table;
}

std::string quantity_text(const ChartTable& table, std::size_t q) {
  std::string text = fmt::format("\n{}", table.quantities[q]);
  if (std::isfinite(table.answers[q]))
    text += fmt::format(" = {:.6g}; an error counts no better than that of the next finer spacing",
                        table.answers[q]);
  text += '\n';
  text += screen_table(q, {"", name_of, {"configuration", "  <"}})
              .text(sorted(table, q, [&](const ChartPoint& p) { return p.front[q]; }));
  const auto peers = sorted(table, q, [](const ChartPoint& p) { return !p.peer.empty(); });
  if (peers.empty()) return text;
  const auto beside = [q, front = own_front(table, q)](const ChartPoint& peer) {
    const double own = time_for(front, q, peer.judged[q]);
    return peer.peer + (std::isfinite(own)
                            ? fmt::format(": {:.3g} s, {:.3g} of it", own, own / peer.time())
                            : ": not reached");
  };
  const Screen last = {"peer, and the time of this program's front there", "  <"};
  return text + screen_table(q, {"", beside, last}).text(peers);
}

Table<ChartPoint> point_table(const std::vector<std::string>& quantities) {
  using Row = ChartPoint;
  const auto fronts = [quantities](const Row& row) {
    std::vector<std::string> names;
    for (std::size_t q = 0; q < quantities.size(); ++q)
      if (row.front[q]) names.push_back(quantities[q]);
    return names;
  };
  Table<Row> table = {
      {"peer", &Row::peer},
      {"family", &Row::family},
      {"set", &Row::overrides, Medium::json},
      {"formulation", &Row::formulation},
      {"kernel", &Row::kernel},
      {"support", &Row::support},
      {"order", [](const Row& row) { return row.order > 0 ? Json(row.order) : Json(nullptr); }},
      {"stabiliser", &Row::stabiliser},
      {"law", [](const Row& row) { return Json::text_or_null(row.law); }},
      {"step_share", &Row::step_share},
      {"spacing", &Row::spacing},
      {"particles", &Row::particles},
      {"steps", &Row::steps},
      {"setup_seconds", &Row::setup_seconds},
      {"stepping_seconds", &Row::seconds, Medium::json},
      {"stepping_seconds", &Row::time, Medium::csv},
      {"stepping_seconds_min", [](const Row& row) { return fastest_and_slowest(row).min; },
       Medium::csv},
      {"stepping_seconds_max", [](const Row& row) { return fastest_and_slowest(row).max; },
       Medium::csv},
      {"repetitions", [](const Row& row) { return row.seconds.size(); }, Medium::csv},
      {"errors", &Row::errors, Medium::json},
      {"judged", &Row::judged, Medium::json},
      {"front", fronts, Medium::json},
  };
  const auto add_each = [&](const std::string& prefix, auto Row::*values) {
    for (std::size_t q = 0; q < quantities.size(); ++q)
      table.add({prefix + quantities[q],
                 [values, q](const Row& row) { return Json((row.*values)[q]); }, Medium::csv});
  };
  add_each("", &Row::errors);
  add_each("judged_", &Row::judged);
  add_each("front_", &Row::front);
  table.add({"failure", [](const Row& row) { return Json::text_or_null(row.failure); }});
  return table;
}

/// Fills `judged`, family by family. Peers keep their errors: they are not picked from many.
void judge(ChartTable& table) {
  std::map<std::string, std::vector<ChartPoint*>> families;
  for (ChartPoint& point : table.points) {
    point.judged.assign(table.quantities.size(), not_known);
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
  return spread_of(seconds).median;
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
  const Table<ChartPoint> table = point_table(quantities);
  write_text_file(directory / "chart.csv", table.csv(points));
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
  json.set("points", table.json(points));
  json.write(directory / "chart.json");
}

}  // namespace tlsph
