// From the pilots of one family to the spacing of a wanted error and what it will cost.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tlsph/analysis/order.hpp"
#include "tlsph/studies/chart_search.hpp"
#include "tlsph/studies/fit.hpp"

namespace tlsph {
namespace {

constexpr double least_order = 0.5, largest_order = 4.0, usual_order = 2.0, hopeful_order = 3.0;
constexpr double settled = 0.4, flat = 0.1;
constexpr Index telling = 60;  // particles

double order_between(const Pilot& coarse, const Pilot& fine) {
  return std::log(std::abs(coarse.error) / std::abs(fine.error)) /
         std::log(coarse.spacing / fine.spacing);
}

}  // namespace

std::vector<double> believed_errors(const std::vector<Pilot>& pilots) {
  std::vector<Measured> runs;
  for (const Pilot& pilot : pilots)
    runs.push_back({pilot.spacing, pilot.setup, pilot.stepping, {std::abs(pilot.error)}});
  std::vector<double> errors;
  for (const Measured& run : judged(std::move(runs), {pilots.size() > 1}))
    errors.push_back(run.errors.front());
  return errors;
}

double observed_order(const std::vector<Pilot>& pilots, const std::vector<double>& errors) {
  const std::size_t first = pilots.size() > 3 ? pilots.size() - 3 : 0;
  std::vector<double> spacings;
  for (const Pilot& pilot : pilots) spacings.push_back(pilot.spacing);
  const double order =
      fit_order(std::span(spacings).subspan(first), std::span(errors).subspan(first)).order;
  return std::isfinite(order) ? std::clamp(order, least_order, largest_order) : usual_order;
}

double predicted_error(const std::vector<Pilot>& pilots, const std::vector<double>& errors,
                       double spacing) {
  const std::size_t n = pilots.size();
  if (spacing >= pilots.front().spacing)
    return errors.front() * std::pow(spacing / pilots.front().spacing, usual_order);
  for (std::size_t k = 1; k < n; ++k) {
    if (spacing < pilots[k].spacing) continue;
    const double share =
        std::log(spacing / pilots[k].spacing) / std::log(pilots[k - 1].spacing / pilots[k].spacing);
    return errors[k] * std::pow(errors[k - 1] / errors[k], share);
  }
  return errors.back() * std::pow(spacing / pilots.back().spacing, observed_order(pilots, errors));
}

double spacing_for(const std::vector<Pilot>& pilots, const std::vector<double>& errors,
                   double error) {
  if (errors.back() > error)
    return pilots.back().spacing *
           std::pow(error / errors.back(), 1.0 / observed_order(pilots, errors));
  std::size_t k = pilots.size() - 1;
  while (k > 0 && errors[k - 1] <= error) --k;
  if (k == 0) return pilots.front().spacing;
  const double share = std::log(error / errors[k]) / std::log(errors[k - 1] / errors[k]);
  return pilots[k].spacing * std::pow(pilots[k - 1].spacing / pilots[k].spacing, share);
}

double predicted_seconds(const std::vector<Pilot>& pilots, double spacing, int dimension) {
  const Pilot& near = *std::ranges::min_element(
      pilots, {}, [&](const Pilot& pilot) { return std::abs(std::log(pilot.spacing / spacing)); });
  return near.charged * std::pow(near.spacing / spacing, dimension + 1);
}

bool is_bracketed(const std::vector<Pilot>& pilots, double error) {
  if (pilots.size() < 2 || !(std::abs(pilots.back().error) <= error)) return false;
  const double before = pilots[pilots.size() - 2].error;
  const double last = pilots.back().error;
  return std::abs(before) <= error || (before * last > 0.0 && std::abs(last) < std::abs(before));
}

bool has_settled(const std::vector<Pilot>& pilots) {
  if (pilots.size() < 3) return false;
  const auto last = pilots.end() - 1;
  const double before = order_between(*(last - 2), *(last - 1));
  const double now = order_between(*(last - 1), *last);
  return before >= least_order && now >= least_order && std::abs(now - before) <= settled;
}

bool has_stalled(const std::vector<Pilot>& pilots) {
  if (pilots.size() < 4 || pilots.back().particles < telling) return false;
  for (auto last = pilots.end() - 1; last != pilots.end() - 4; --last)
    if (std::abs(order_between(*(last - 1), *last)) > flat) return false;
  return true;
}

double hoped_seconds(const std::vector<Pilot>& pilots, double error, int dimension) {
  const Pilot& last = pilots.back();
  if (std::abs(last.error) <= error) return 0.0;  // a coarser one may do
  double order = hopeful_order;
  if (pilots.size() >= 3)
    order = std::max(order_between(pilots[pilots.size() - 2], last), least_order) + 0.5;
  const double spacing = last.spacing * std::pow(error / std::abs(last.error), 1.0 / order);
  return predicted_seconds({last}, spacing, dimension);
}

}  // namespace tlsph
