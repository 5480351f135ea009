// A plate that swings in a mode of constant volume: orders of convergence at two Poisson's ratios.
#include <fmt/format.h>

#include "list.hpp"

namespace tlsph {
namespace {

/// `second_order` is promised in displacement, velocity and stress, or only reported.
void check_orders(CaseRun& run, const std::string& formulation, double poisson, bool second_order,
                  std::vector<CaseColumn>& columns) {
  constexpr const char* source = "Lee et al. 2019, Table 1";
  Settings settings = {"formulation=" + formulation, fmt::format("material.poisson={}", poisson)};
  if (!second_order) settings.emplace_back("stabiliser.kind=pair");
  const ConvergenceTable table = run.converge("plate.toml", settings, columns.front().values);
  const Checks check(run, fmt::format(", ν = {}, {}", poisson, formulation));
  for (std::size_t q = 0; q < table.quantities.size(); ++q) {
    const std::string& quantity = table.quantities[q];
    CaseColumn& errors =
        columns.emplace_back(fmt::format("{} {} {}", formulation, poisson, quantity));
    for (const ConvergenceRow& row : table.rows) errors.values.push_back(row.errors[q]);
    check(source, fmt::format("order of the {} error", quantity), table.fits[q].fit.order,
          second_order ? absolute(2.0, 0.1) : reported(2.0));
  }
  check(source, "L2 error of the stress, 32 cells", table.rows[2].errors[2],
        second_order ? at_most(1e-3) : reported());
}

}  // namespace

void swinging_plate(CaseRun& run) {
  std::vector<CaseColumn> columns = {{"spacing"}};
  for (const int cells : {8, 16, 32, 64}) add_row(columns, {1.0 / cells});
  for (const std::string formulation : {"stress-point", "mirror", "variational"})
    for (const double poisson : {0.3, 0.45})
      check_orders(run, formulation, poisson, formulation != "variational", columns);
  run.table("errors", columns);
}

}  // namespace tlsph
