// The first period of a clamped plate, by the operators' own eigenvalue.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "linear_body.hpp"
#include "list.hpp"
#include "tlsph/dynamics/critical_step.hpp"
#include "tlsph/simulation/builder.hpp"

namespace tlsph {
namespace {
constexpr double exact_period = 0.25523;
}

void beam_period(CaseRun& run) {
  const char* extra = std::getenv("BEAM");
  for (const auto& [name, overrides] :
       std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"cons 21", {}},
           {"cons 21 .01", {"stabiliser.coefficient=0.01"}},
           {"cons 21 .3", {"stabiliser.coefficient=0.3"}},
           {"cons 11", {"consistency=[1,1]"}},
           {"var o2 2.6", {"formulation=variational", "kernel.order=2", "kernel.support=2.6"}},
           {"var o2 2.6 .01",
            {"formulation=variational", "kernel.order=2", "kernel.support=2.6",
             "stabiliser.coefficient=0.01"}},
           {"var o2 2.6 none",
            {"formulation=variational", "kernel.order=2", "kernel.support=2.6",
             "stabiliser.coefficient=1e-6"}},
           {"var o1", {"formulation=variational"}},
           {"cell", {"formulation=stress-point", "stabiliser.kind=cell"}}})
    for (const int cells : {4, 9, 10, 19, 20}) {
      auto all = overrides;
      all.push_back(fmt::format("body.spacing={}", 0.02 / cells));
      if (extra) all.push_back(extra);
      try {
        const auto disc = build<2>(run.read("plate.toml", all));
        const double period = 2 * std::numbers::pi / LinearBody(disc).lowest_frequency();
        const auto state = make_state<2>(disc, VectorField<2>::Zero(disc.nodes(), 2),
                                         VectorField<2>::Zero(disc.nodes(), 2));
        fmt::print(stderr, "{:18} {:3} cells {:.6f} {:+.3f} %\n", name, cells, period,
                   100 * (period / exact_period - 1));
      } catch (const std::exception& e) {
        fmt::print(stderr, "{} {} {}\n", name, cells, e.what());
      }
    }
}

}  // namespace tlsph
