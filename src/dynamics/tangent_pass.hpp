#pragma once
/// \file
/// Products with the stiffness of a large deformed body, by the operators and inner loops of a
/// sweep: the change of the strains and at once, in its place, of the stresses, then the forces.
/// Not for other rooms.

#include <memory>
#include <vector>

#include "sweep_region_laws.hpp"
#include "sweep_storage.hpp"
#include "tlsph/dynamics/state.hpp"

namespace tlsph::sweep {

template <int D>
class TangentPass {
 public:
  /// Both must outlive this and `state.H` stay as it is. `Sweep::possible`, no viscosity.
  /// `operators`: those of a sweep, which must outlive this too; none: its own.
  TangentPass(const Discretisation<D>& discretisation, const State<D>& state,
              const Storage<D>* operators = nullptr);
  /// The unit tangent in place of the laws', and no stabiliser.
  TangentPass(const Discretisation<D>& discretisation, const Storage<D>& operators);

  /// −K x = D (A : G x) − S x, the change of the forces with a displacement x (N×d) [N per
  /// thickness].
  void product(const VectorField<D>& x, VectorField<D>& force);

 private:
  /// Consecutive rows and the runs they are made of.
  struct Block {
    Index first = 0, last = 0;
    Index run = 0, runs = 0;
  };
  struct Blocks {
    std::vector<Block> blocks;
    std::vector<RowRun> runs;
  };
  static Blocks cut(const std::vector<RowRun>& runs, Index rows);
  static Runs runs_of(const Blocks& blocks, const Block& block) {
    return {blocks.runs.data() + block.run, block.runs};
  }
  void allocate();
  /// The change of the stresses of points [first, last), from that of the strains in `window`;
  /// `strain` has room for theirs.
  void stresses(Index first, Index last, double* const* window, double* const* strain);

  const Discretisation<D>& disc_;
  const State<D>* state_ = nullptr;  // none: the unit tangent
  std::unique_ptr<Storage<D>> own_;
  const Storage<D>& storage_;
  const Kernels<D>& kernels_;
  Blocks points_, nodes_;
  std::vector<RegionLaw<D>> laws_;           // of the regions
  std::vector<int> region_;                  // of every point; empty if there is one only
  std::vector<std::vector<double>> stress_;  // of all points, a direction each
  int threads_ = 1;
};

}  // namespace tlsph::sweep
