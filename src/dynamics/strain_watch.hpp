#pragma once
/// \file
/// What the step of a deforming body wants to know of its strains, in passes over blocks of points
/// whose strains never leave the cache. Not for other rooms.

#include <array>
#include <memory>
#include <vector>

#include "sweep_region_laws.hpp"
#include "sweep_storage.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/dynamics/sweep.hpp"

namespace tlsph::sweep {

/// Stretches of all material points, rotation removed: U − 1 with F = R U, by direction: its
/// columns, interleaved, at a·points·D. In single precision: what is asked for is how far a body is
/// from them, in thousandths at the finest, and a look costs little more than reading them.
using StrainField = std::vector<float>;

template <int D>
class StrainWatch {
 public:
  /// Of states that are evaluated. The discretisation must outlive this.
  explicit StrainWatch(const Discretisation<D>& discretisation);

  /// From now on strains come from displacements, by the operators of a sweep of the same
  /// discretisation, which must outlive this.
  void read_by(const Sweep<D>& sweep);
  /// Whether `state.H` is what is looked at.
  [[nodiscard]] bool reads_strains() const { return storage_ == nullptr; }

  [[nodiscard]] StrainField strains(const State<D>& state);
  void store(const State<D>& state, StrainField& to);
  /// max ‖U − U₀‖ ‖U⁻¹‖, the largest relative deformation of a point between two states.
  [[nodiscard]] double deformation(const State<D>& state, const StrainField& before);
  /// max λ_max(A(U) − A(U₀)), at most that and at least zero [Pa]; A each at its own memory.
  [[nodiscard]] double stiffening(const State<D>& state, const StrainField& before,
                                  const MemoryField& memory_before);

  struct Change {
    double stiffening = 0.0;   ///< as above
    double deformation = 0.0;  ///< as above
  };
  /// Both at once, the strains stored in `to` on the way.
  [[nodiscard]] Change change(const State<D>& state, const StrainField& before,
                              const MemoryField& memory_before, StrainField& to);

 private:
  static constexpr std::size_t most_directions = D + 1;
  /// One thread's strains of a block, and a row of the stabiliser where the operators have one.
  struct Buffer {
    std::array<std::vector<double>, most_directions> values;
    std::array<double*, most_directions> direction{};
    Change most;
  };
  using Directions = std::array<const double*, static_cast<std::size_t>(D)>;
  using Stored = std::array<const float*, static_cast<std::size_t>(D)>;
  struct Memories {
    const MemoryField& now;
    const MemoryField& before;
  };

  /// The largest of each number of visit(first, count, H) over the blocks, at least zero.
  template <class Visit>
  Change largest(const State<D>& state, const Visit& visit);
  void read(Index block, const State<D>& state, double* const* H) const;
  [[nodiscard]] double stiffening_of_block(Index first, Index count, const Directions& H,
                                           const Stored& before, const Memories& memories) const;
  [[nodiscard]] double stiffening_of_region(Index region, Index first, Index count,
                                            const Directions& H, const Stored& before,
                                            const Memories& memories) const;
  /// The same of a law without loops.
  [[nodiscard]] static double stiffening_of(const AnyLaw<D>& law, Index first, Index count,
                                            const Directions& H, const Stored& before,
                                            const Memories& memories);
  void copy(Index first, Index count, const Directions& H, StrainField& to) const;
  [[nodiscard]] Stored at(const StrainField& field, Index point) const;

  const Discretisation<D>& disc_;
  const Kernels<D>& kernels_;
  const Storage<D>* storage_ = nullptr;
  Index points_, blocks_;
  std::vector<RowRun> runs_;      // of the gradient, cut to the blocks
  std::vector<Index> first_run_;  // of every block, and one more
  std::vector<RegionLaw<D>> laws_;
  std::vector<int> region_;  // of every point; empty if there is one only
  std::vector<std::unique_ptr<Buffer>> buffers_;
};

}  // namespace tlsph::sweep
