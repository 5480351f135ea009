#pragma once
/// \file
/// Functions sampled at equally spaced particles on a line, and what SPH sums make of them: the
/// interpolation studies of the thesis, section 2.7, and the parts of that case.

#include <array>
#include <functional>

#include "tlsph/kernels/families.hpp"
#include "tlsph/particles/particles.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {

using Function = std::function<double(double)>;

/// n intervals on [from, to] with `layers` ghost particles beyond each end; ghosts carry the
/// function continued. Without ghosts the particles at the ends own half a spacing.
struct SampledLine {
  SampledLine(double from, double to, int intervals, int layers);

  VectorField<1> X;  ///< all particles, ghosts included
  ScalarField V;
  double spacing = 0.0;
  Index first = 0;  ///< of the real ones
  Index count = 0;

  [[nodiscard]] ScalarField sample(const Function& f) const;
  /// The real ones among values at all.
  [[nodiscard]] ScalarField real(const ScalarField& all) const { return all.segment(first, count); }
};

/// Value and derivative at every particle, as matrices over all of them.
struct LineOperators {
  SparseMatrix value, derivative;
};

/// The sums of the thesis, (2.31) and (2.33); supports in spacings.
[[nodiscard]] LineOperators plain_sums(const AnyKernel& kernel, double support,
                                       const SampledLine& line);
/// The same, normalised so that W reproduces constants and X linear fields inside (`mirror`);
/// needs ghosts, without which the rows near the ends are incomplete.
[[nodiscard]] LineOperators normalised_sums(const AnyKernel& kernel, double support,
                                            const SampledLine& line);

/// The thesis's kernel and its derivative written out from (2.19), normalised by quadrature, as a
/// reference: sums over a lattice of unit spacing of W_j cos jθ and −W'_j sin jθ, which are what
/// becomes of the amplitudes of sin and of its derivative (divided by θ).
struct LatticeSums {
  explicit LatticeSums(double support);
  [[nodiscard]] double value(double theta) const;
  [[nodiscard]] double derivative(double theta) const;
  /// −Σ j W'_j: the share of the slope of a straight line that is found.
  [[nodiscard]] double slope() const;

 private:
  double support_, normalisation_;
  [[nodiscard]] double first(int j) const;
};

namespace sampling {

inline constexpr ModifiedMollifier kernel{};  ///< the thesis's own
inline constexpr std::array supports = {1.5, 2.5, 3.5, 4.5, 5.5};
inline constexpr int layers = 6;  ///< of ghosts, enough for all supports

/// Figs 2.10–2.12: (x − ½)⁴ with and without ghosts, and how its errors fall.
void quartic(CaseRun& run);
/// Figs 2.13–2.16: amplitudes of sin x and its derivatives.
void sine(CaseRun& run);
/// Figs 2.17–2.20: falling edges.
void edges(CaseRun& run);
/// (2.46), (2.47): the modified SPH matrix.
void modified_matrix(CaseRun& run);

}  // namespace sampling

}  // namespace tlsph
