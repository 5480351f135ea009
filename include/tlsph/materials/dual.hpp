#pragma once
/// \file
/// Dual numbers: a value and its derivatives in N directions, carried through the arithmetic of a
/// law to round-off (Griewank and Walther, Evaluating Derivatives, 2008, ch. 3).

#include "tlsph/materials/numbers.hpp"

namespace tlsph {

template <class R, int N = 1>
struct Dual {
  R value;
  R change[N];

  template <class Change>
  [[gnu::always_inline]] static Dual of(const R& value, const Change& change) {
    Dual result;
    result.value = value;
    for (int n = 0; n < N; ++n) result.change[n] = change(n);
    return result;
  }

  [[gnu::always_inline]] friend Dual operator+(const Dual& a, const Dual& b) {
    return of(R(a.value + b.value), [&](int n) { return a.change[n] + b.change[n]; });
  }
  [[gnu::always_inline]] friend Dual operator-(const Dual& a, const Dual& b) {
    return of(R(a.value - b.value), [&](int n) { return a.change[n] - b.change[n]; });
  }
  [[gnu::always_inline]] friend Dual operator*(const Dual& a, const Dual& b) {
    return of(R(a.value * b.value),
              [&](int n) { return a.change[n] * b.value + a.value * b.change[n]; });
  }
  /// (a/b)' = (a' − (a/b) b')/b.
  [[gnu::always_inline]] friend Dual operator/(const Dual& a, const Dual& b) {
    const R inverse = 1.0 / b.value, quotient = a.value * inverse;
    return of(quotient, [&](int n) { return (a.change[n] - quotient * b.change[n]) * inverse; });
  }
  [[gnu::always_inline]] friend Dual operator/(double a, const Dual& b) {
    const R inverse = 1.0 / b.value, quotient = a * inverse;
    return of(quotient, [&](int n) { return -quotient * inverse * b.change[n]; });
  }
  [[gnu::always_inline]] friend Dual operator/(const Dual& a, double b) { return (1.0 / b) * a; }
  [[gnu::always_inline]] friend Dual operator-(const Dual& a) {
    return of(R(-a.value), [&](int n) { return -a.change[n]; });
  }
  [[gnu::always_inline]] friend Dual operator+(double a, const Dual& b) {
    return of(R(a + b.value), [&](int n) { return b.change[n]; });
  }
  [[gnu::always_inline]] friend Dual operator+(const Dual& a, double b) { return b + a; }
  [[gnu::always_inline]] friend Dual operator-(const Dual& a, double b) {
    return of(R(a.value - b), [&](int n) { return a.change[n]; });
  }
  [[gnu::always_inline]] friend Dual operator-(double a, const Dual& b) { return a + -b; }
  [[gnu::always_inline]] friend Dual operator*(double a, const Dual& b) {
    return of(R(a * b.value), [&](int n) { return a * b.change[n]; });
  }
  [[gnu::always_inline]] friend Dual operator*(const Dual& a, double b) { return b * a; }
  [[gnu::always_inline]] friend auto operator<(const Dual& a, double b) { return a.value < b; }
  [[gnu::always_inline]] friend auto operator>(const Dual& a, double b) { return a.value > b; }
};

/// {value, change(n) …}.
template <int N, class R, class Change>
[[gnu::always_inline]] inline Dual<R, N> dual(const R& value, const Change& change) {
  return Dual<R, N>::of(value, change);
}

template <class R, int N>
struct Numbers<Dual<R, N>> {
  using Real = Numbers<R>;
  using Mask = typename Real::Mask;
  [[gnu::always_inline]] static Dual<R, N> all(double value) {
    return dual<N>(Real::all(value), [](int) { return Real::all(0.0); });
  }
  [[gnu::always_inline]] static R magnitude(const Dual<R, N>& a) {
    return Real::magnitude(a.value);
  }
  [[gnu::always_inline]] static Dual<R, N> root(const Dual<R, N>& a) {
    const R root = Real::root(a.value);
    const R slope = 0.5 / root;
    return dual<N>(root, [&](int n) { return slope * a.change[n]; });
  }
  [[gnu::always_inline]] static Dual<R, N> log_and_inverse(const Dual<R, N>& e, Dual<R, N>& inverse,
                                                           Mask& good) {
    R one_over;
    const R log = Real::log_and_inverse(e.value, one_over, good);
    const R slope = -one_over * one_over;
    inverse = dual<N>(one_over, [&](int n) { return slope * e.change[n]; });
    return dual<N>(log, [&](int n) { return one_over * e.change[n]; });
  }
  [[gnu::always_inline]] static Dual<R, N> log_minus(const Dual<R, N>& e) {
    const R slope = -e.value / (1.0 + e.value);
    return dual<N>(Real::log_minus(e.value), [&](int n) { return slope * e.change[n]; });
  }
};

/// A : dH of a law at H.
template <int D, class R, class Law>
[[gnu::always_inline]] inline TensorOf<D, R> action_of(const Law& law, const TensorOf<D, R>& H,
                                                       const TensorOf<D, R>& dH) {
  TensorOf<D, Dual<R>> moved;
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a) moved(i, a) = {H(i, a), {dH(i, a)}};
  Mask<R> good{};
  const TensorOf<D, Dual<R>> P = law.stress(moved, good);
  TensorOf<D, R> dP;
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a) dP(i, a) = P(i, a).change[0];
  return dP;
}

/// ∂P/∂F of a law at H, rows and columns numbered i*D + a: the text's own expression, at a
/// fifth of the cost, or by dual numbers.
template <int D, class R, class Law>
[[gnu::always_inline]] inline TensorOf<D * D, R> tangent_of(const Law& law,
                                                            const TensorOf<D, R>& H) {
  if constexpr (requires { law.tangent(H); }) {
    return law.tangent(H);
  } else {
    TensorOf<D, Dual<R, D * D>> moved;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a)
        moved(i, a) = dual<D * D>(
            H(i, a), [&](int n) { return Numbers<R>::all(n == i * D + a ? 1.0 : 0.0); });
    Mask<R> good{};
    const TensorOf<D, Dual<R, D* D>> P = law.stress(moved, good);
    TensorOf<D * D, R> A;
    for (int row = 0; row < D * D; ++row)
      for (int column = 0; column < D * D; ++column)
        A(row, column) = P(row / D, row % D).change[column];
    return A;
  }
}

}  // namespace tlsph
