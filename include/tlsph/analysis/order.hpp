#pragma once
/// \file
/// The straight line through points, and orders of convergence: how an error e ≈ C h^p falls with
/// the spacing h, from errors against an exact solution or, where there is none, from the
/// differences between runs of successive spacings.

#include <span>
#include <vector>

#include "tlsph/analysis/not_known.hpp"

namespace tlsph {

/// y = c + p x. Not a number where there are too few points for it: two, of the error three.
struct LineFit {
  double slope = not_known;           ///< p
  double intercept = not_known;       ///< c
  double standard_error = not_known;  ///< of p
};

/// By least squares.
[[nodiscard]] LineFit fit_line(std::span<const double> x, std::span<const double> y);

/// The order p and constant C of a model with C > 0, by least squares on the logarithms. Not a
/// number where too few values are positive and finite.
struct OrderFit {
  double order = not_known;           ///< p
  double log_constant = not_known;    ///< ln C
  double standard_error = not_known;  ///< of p; needs three values
  int points = 0;                     ///< values that entered
};

/// p_k = ln(e_{k−1}/e_k) / ln(h_{k−1}/h_k), one an error; the first is not a number, nor is one
/// that meets an error which is not positive and finite. Spacings are positive and differ.
[[nodiscard]] std::vector<double> pairwise_orders(std::span<const double> spacing,
                                                  std::span<const double> error);

/// e_k = C h_k^p through all errors that are positive and finite.
[[nodiscard]] OrderFit fit_order(std::span<const double> spacing, std::span<const double> error);

/// |q_k − q_{k+1}| = C |h_k^p − h_{k+1}^p| through the differences of n runs, the k-th between runs
/// k and k + 1 (n − 1 of them): what e_k = C h_k^p with errors of one sign leaves when the exact
/// value is unknown. Spacings are positive and fall; their ratio may vary. With a constant ratio r
/// it is the straight line ln d = p ln h + const. Two differences give p exactly (Roache 1994),
/// more the least squares on their logarithms.
[[nodiscard]] OrderFit fit_order_of_differences(std::span<const double> spacing,
                                                std::span<const double> difference);

/// One an entry of `spacing`: p_k from the differences d_{k−2}, d_{k−1} of the three runs k−2, k−1,
/// k; the first two are not numbers.
[[nodiscard]] std::vector<double> pairwise_orders_of_differences(
    std::span<const double> spacing, std::span<const double> difference);

/// Error left in the finer of two runs that differ by `difference`, spacings in the ratio
/// `ratio` = h_coarse/h_fine > 1: difference/(ratio^p − 1). Not a number unless p > 0.
[[nodiscard]] double richardson_error(double difference, double ratio, double order);

/// The value both runs tend to: fine + (fine − coarse)/(ratio^p − 1). Not a number unless p > 0.
[[nodiscard]] double richardson_limit(double coarse, double fine, double ratio, double order);

}  // namespace tlsph
