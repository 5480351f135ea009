#include "tlsph/studies/chart_search.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tlsph/analysis/not_known.hpp"

namespace tlsph {
namespace {

/// Orders a prediction believes. The least is hopeful, because coarse spacings often show less than
/// what comes; a family that disappoints is too far behind the front for hope to matter.
constexpr double least_order = 1.5, largest_order = 4.0;
/// No scheme here has a higher one.
constexpr double best_order = 3.0;
/// A run nothing is as fast as promises so much: to open a new end of the front.
constexpr double new_end = 3.0;

double observed_power(double fine, double coarse, double ratio) {
  return fine > 0.0 && coarse > 0.0 ? std::log(fine / coarse) / std::log(ratio) : 0.0;
}

}  // namespace

Predicted predict(const std::vector<Measured>& runs, double spacing, int dimension) {
  assert(!runs.empty());
  const Measured& last = runs.back();
  const Measured* before = runs.size() > 1 ? &runs[runs.size() - 2] : nullptr;
  const double ratio = last.spacing / spacing;
  double work = dimension + 1.0;
  double set_up = dimension;
  if (before != nullptr) {
    const double refined = before->spacing / last.spacing;
    work = std::clamp(observed_power(last.stepping, before->stepping, refined), work, work + 1.0);
    set_up = std::clamp(observed_power(last.setup, before->setup, refined), set_up, set_up + 1.5);
  }
  Predicted run;
  run.stepping = last.stepping * std::pow(ratio, work);
  run.setup = last.setup * std::pow(ratio, set_up);
  for (std::size_t q = 0; q < last.errors.size(); ++q) {
    double order = 2.0;
    if (before != nullptr) {
      const double seen =
          observed_power(last.errors[q], before->errors[q], last.spacing / before->spacing);
      if (std::isfinite(seen)) order = std::clamp(seen, least_order, largest_order);
    }
    run.errors.push_back(last.errors[q] * std::pow(ratio, -order));
  }
  return run;
}

std::vector<Measured> judged(std::vector<Measured> runs, const std::vector<bool>& single_number) {
  const std::vector<Measured> raw = runs;
  for (std::size_t q = 0; q < single_number.size(); ++q) {
    if (!single_number[q]) continue;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      double& error = runs[k].errors[q];
      if (raw.size() == 1) error = not_known;
      if (k + 1 < raw.size()) error = std::max(error, raw[k + 1].errors[q]);
      if (k > 0)
        error = std::max(error, raw[k - 1].errors[q] *
                                    std::pow(raw[k].spacing / raw[k - 1].spacing, best_order));
    }
  }
  return runs;
}

double promise(const Predicted& run, const std::vector<Measured>& all, double margin) {
  double best = -new_end;
  for (std::size_t q = 0; q < run.errors.size(); ++q) {
    if (!std::isfinite(run.errors[q])) continue;
    double reached = new_end;
    for (const Measured& other : all)
      if (other.stepping * margin <= run.stepping && std::isfinite(other.errors[q]))
        reached = std::min(reached, std::log(margin * other.errors[q] / run.errors[q]));
    best = std::max(best, reached);
  }
  return best;
}

std::optional<std::size_t> best_prospect(const std::vector<Prospect>& prospects,
                                         double seconds_left) {
  std::optional<std::size_t> best;
  const auto rate = [&](std::size_t k) { return prospects[k].promise / prospects[k].cost; };
  for (std::size_t k = 0; k < prospects.size(); ++k) {
    if (!(prospects[k].promise > 0.0) || prospects[k].cost > seconds_left) continue;
    if (!best || rate(k) > rate(*best)) best = k;
  }
  return best;
}

}  // namespace tlsph
