// A plate that swings in a mode of constant volume: orders of convergence at two Poisson's ratios.
#include <fmt/format.h>

#include <array>

#include "list.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

constexpr const char* source = "Lee et al. 2019, Table 1";
constexpr std::array cells = {8, 16, 32, 64};

struct Method {
  const char* formulation;
  bool second_order;  ///< promised: in displacement, velocity and stress
};

ConvergenceTable study(const CaseRun& run, const Method& method, double poisson) {
  ConvergenceRequest request;
  request.scene = run.folder() / "plate.toml";
  request.formulations = {method.formulation};
  request.overrides = {fmt::format("material.poisson={}", poisson)};
  if (!method.second_order) request.overrides.emplace_back("stabiliser.kind=pair");
  for (const int n : cells) request.spacings.push_back(1.0 / n);
  ConvergenceOptions options;
  options.threads = 1;
  return converge(request, options);
}

}  // namespace

void swinging_plate(CaseRun& run) {
  std::vector<std::string> columns = {"spacing"};
  std::vector<std::vector<double>> values(1);
  for (const int n : cells) values[0].push_back(1.0 / n);
  for (const Method& method :
       {Method{"stress-point", true}, Method{"mirror", true}, Method{"variational", false}})
    for (const double poisson : {0.3, 0.45}) {
      const ConvergenceTable table = study(run, method, poisson);
      const std::string where = fmt::format("ν = {}, {}", poisson, method.formulation);
      for (const ConvergenceRow& row : table.rows)
        if (!row.failure.empty()) throw NumericalError(row.failure, 0.0, -1);
      for (std::size_t q = 0; q < table.quantities.size(); ++q) {
        const std::string& quantity = table.quantities[q];
        columns.push_back(fmt::format("{} {} {}", method.formulation, poisson, quantity));
        auto& errors = values.emplace_back();
        for (const ConvergenceRow& row : table.rows) errors.push_back(row.errors[q]);
        const std::string order = fmt::format("order of the {} error, {}", quantity, where);
        if (method.second_order)
          run.absolute(source, order, 2.0, table.fits[q].fit.order, 0.1);
        else
          run.report(source, order, table.fits[q].fit.order, 2.0);
      }
      if (method.second_order)
        run.at_most(source, fmt::format("L2 error of the stress, 32 cells, {}", where), 1e-3,
                    table.rows[2].errors[2]);
      else
        run.report(source, fmt::format("L2 error of the stress, 32 cells, {}", where),
                   table.rows[2].errors[2]);
    }
  run.table("errors", columns, values);
}

}  // namespace tlsph
