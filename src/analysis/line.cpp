#include "tlsph/analysis/line.hpp"

#include <cmath>

namespace tlsph {

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
  LineFit line;
  const auto n = static_cast<double>(x.size());
  if (x.size() < 2) return line;
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    mean_x += x[k] / n;
    mean_y += y[k] / n;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mean_x) * (x[k] - mean_x);
    xy += (x[k] - mean_x) * (y[k] - mean_y);
  }
  if (xx == 0.0) return line;
  line.slope = xy / xx;
  line.intercept = mean_y - line.slope * mean_x;
  if (x.size() < 3) return line;
  double residual = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double r = y[k] - line.intercept - line.slope * x[k];
    residual += r * r;
  }
  line.standard_error = std::sqrt(residual / (n - 2.0) / xx);
  return line;
}

}  // namespace tlsph
