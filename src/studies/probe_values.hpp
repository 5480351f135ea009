#pragma once
/// \file
/// Single numbers read off the probes of a run: `tip.displacement_y.period` is the period of that
/// column of probes.csv about zero, `….max` and `….min` its largest and smallest value, `….peak`
/// the larger of their sizes, `….end` its last value.

#include <string>
#include <vector>

#include "tlsph/observe/history.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// InputError, naming `--value`, for a name that ends in none of the words, names no probe of the
/// scene or a quantity it does not record.
void check_value_names(const std::vector<std::string>& names, const Scene& scene);

/// One a name; not a number where a column has no period. InputError for a column that is not
/// there.
[[nodiscard]] std::vector<double> read_values(const std::vector<std::string>& names,
                                              const History& history);

/// What is worth reading of a history nobody asked about: the peak of every column that is not
/// zero, the period of every one that oscillates about zero.
[[nodiscard]] std::vector<std::string> telling_values(const History& history);

}  // namespace tlsph
