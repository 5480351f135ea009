#pragma once
/// \file
/// Peers on a chart: each from spacing to spacing within its part of the time, in the variants of
/// time step and law that it can be given.

#include <functional>
#include <string>

#include "chart_plan.hpp"
#include "chart_variants.hpp"
#include "tlsph/studies/chart.hpp"

namespace tlsph {

struct ChartPeers {
  const ChartRequest& request;
  const ChartPlan& plan;
  const ChartVariation& variation;
  const ChartOptions& options;
  ChartTable& table;
  std::function<double()> spent;  ///< [s] since the study began
  std::function<void(const std::string& what)> show;
  std::function<void(ChartPoint)> add;  ///< to the table

  /// Runs all of them, until so many seconds are spent.
  void run(double until) const;
};

}  // namespace tlsph
