#pragma once
/// \file
/// How far a body has deformed since a stored state, and how much stiffer its tangents have become:
/// passes over blocks of material points whose strains never leave the cache.

#include <memory>
#include <vector>

#include "tlsph/dynamics/state.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {

/// Stretches of all material points, rotation removed: U − 1 with F = R U, by direction: its
/// columns, interleaved, at a·points·D. In single precision: differences of a thousandth matter at
/// the finest, and a comparison costs little more than reading them.
using StrainField = std::vector<float>;

template <int D>
class StrainMonitor {
 public:
  /// Reads H of states that are evaluated. The discretisation must outlive this.
  explicit StrainMonitor(const Discretisation<D>& discretisation);
  StrainMonitor(const StrainMonitor&) = delete;
  StrainMonitor& operator=(const StrainMonitor&) = delete;
  ~StrainMonitor();

  /// From now on strains are computed from u, by the operators of a sweep of the same
  /// discretisation, which must outlive this.
  void use_operators_of(const Sweep<D>& sweep);
  /// Whether `state.H` is read.
  [[nodiscard]] bool reads_strains() const;

  [[nodiscard]] StrainField strains(const State<D>& state);
  void store(const State<D>& state, StrainField& to);
  /// max ‖U − U₀‖ ‖U⁻¹‖, the largest relative deformation of a point between two states.
  [[nodiscard]] double deformation(const State<D>& state, const StrainField& before);
  struct Change {
    double stiffening = 0.0;  ///< max λ_max(A(U) − A(U₀)), at most that and at least zero [Pa]
    double deformation = 0.0;  ///< as above
  };
  /// Both at once, A each at its own memory; the strains stored in `to`, which may be `before`.
  [[nodiscard]] Change change(const State<D>& state, const StrainField& before,
                              const MemoryField& memory_before, StrainField& to);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tlsph
