#include "tlsph/sweep/stiffness_product.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <variant>

#include "region_laws.hpp"
#include "storage.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph {
namespace {

using namespace sweep;

/// One thread's fields of a block: the changes of the strains and the modes by direction, then the
/// strains.
template <int D>
class Buffer {
 public:
  Buffer() : values_(direction_.size() * stride, 0.0) {
    for (std::size_t a = 0; a < direction_.size(); ++a) direction_[a] = values_.data() + a * stride;
  }
  [[nodiscard]] double* const* changes() const { return direction_.data(); }
  [[nodiscard]] double* const* strains() const { return direction_.data() + D + 1; }

 private:
  static constexpr std::size_t stride = block_rows * D + overrun;
  std::array<double*, 2 * D + 1> direction_{};
  std::vector<double> values_;
};

/// The changes of the stresses of `count` points from those of their strains, both by direction.
template <int D>
void apply_tangent(const RegionLaw<D>& region, const double* H, Index count, double* const* strain,
                   const std::array<const double*, D>& change,
                   const std::array<double*, D>& stress) {
  for (Index s = 0; s < count; ++s)
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) strain[a][s * D + i] = H[s * D * D + i * D + a];
  if (region.loops != nullptr)
    return region.loops->tangent(region.text(), strain, change.data(), stress.data(), count);
  std::visit(
      [&](const auto& law) {
        for (Index s = 0; s < count; ++s) {
          Tensor<D> dH;
          for (int i = 0; i < D; ++i)
            for (int a = 0; a < D; ++a) dH(i, a) = change[static_cast<std::size_t>(a)][s * D + i];
          const Tensor<D> dP = law.dpk1(Eigen::Map<const Tensor<D>>(H + s * D * D), dH);
          for (int i = 0; i < D; ++i)
            for (int a = 0; a < D; ++a) stress[static_cast<std::size_t>(a)][s * D + i] = dP(i, a);
        }
      },
      region.law);
}

}  // namespace

template <int D>
struct StiffnessProduct<D>::Parts {
  /// Consecutive rows and the runs they are made of.
  struct Block {
    Index first = 0, last = 0;
    Index run = 0, runs = 0;
  };
  struct Blocks {
    std::vector<Block> blocks;
    std::vector<RowRun> runs;
  };

  const Discretisation<D>& disc;
  const State<D>* state;  // none: the unit tangent
  std::unique_ptr<Storage<D>> own;
  const Storage<D>& storage;
  const Loops<D>& loops;
  Blocks points, nodes;
  std::vector<RegionLaw<D>> laws;           // of the regions
  std::vector<int> region;                  // of every point; empty if there is one only
  std::vector<std::vector<double>> stress;  // of all points, a direction each
  int threads = 1;

  Parts(const Discretisation<D>& discretisation, const State<D>* at, const Sweep<D>* sweep)
      : disc(discretisation),
        state(at),
        own(sweep == nullptr ? std::make_unique<Storage<D>>(disc, false) : nullptr),
        storage(sweep == nullptr ? *own : sweep->operators()),
        loops(sweep::loops<D>(widest_level())),
        points(cut(storage.gradient.runs, disc.points.size())),
        nodes(cut(storage.divergence.runs, disc.nodes())),
        stress(storage.modes ? D + 1 : D),
        threads(worth_threads(disc.nodes()) ? omp_get_max_threads() : 1) {
    if (state != nullptr) {
      laws = region_laws<D>(disc, loops, false);
      region = regions_of_points(disc);
    }
    for (auto& values : stress)
      values.assign(static_cast<std::size_t>(disc.points.size() * D + overrun), 0.0);
  }

  static Blocks cut(const std::vector<RowRun>& runs, Index rows) {
    Blocks result;
    for (Index first = 0; first < rows; first += block_rows) {
      const Index last = std::min(first + block_rows, rows);
      const Index run = append_runs(runs, first, last, result.runs);
      result.blocks.push_back({first, last, run, static_cast<Index>(result.runs.size()) - run});
    }
    return result;
  }
  static Runs runs_of(const Blocks& blocks, const Block& block) {
    return {blocks.runs.data() + block.run, block.runs};
  }

  /// The change of the stresses of points [first, last), from that of the strains in `window`;
  /// `strain` has room for theirs.
  void stresses(Index first, Index last, double* const* window, double* const* strain) {
    if (state == nullptr) {
      for (std::size_t a = 0; a < D; ++a)
        std::copy_n(window[a], (last - first) * D, stress[a].data() + first * D);
      return;
    }
    for (Index s = first; s < last;) {
      const int law = region.empty() ? 0 : region[static_cast<std::size_t>(s)];
      Index end = region.empty() ? last : s + 1;
      while (end < last && region[static_cast<std::size_t>(end)] == law) ++end;
      std::array<const double*, D> change{};
      std::array<double*, D> to{};
      for (std::size_t a = 0; a < D; ++a) {
        change[a] = window[a] + (s - first) * D;
        to[a] = stress[a].data() + s * D;
      }
      apply_tangent<D>(laws[static_cast<std::size_t>(law)], state->H.data() + s * D * D, end - s,
                       strain, change, to);
      s = end;
    }
  }
};

template <int D>
StiffnessProduct<D>::StiffnessProduct(const Discretisation<D>& disc, const State<D>& state,
                                      const Sweep<D>* sweep)
    : parts_(std::make_unique<Parts>(disc, &state, sweep)) {}
template <int D>
StiffnessProduct<D>::StiffnessProduct(const Discretisation<D>& disc, const Sweep<D>& sweep)
    : parts_(std::make_unique<Parts>(disc, nullptr, &sweep)) {}
template <int D>
StiffnessProduct<D>::StiffnessProduct(StiffnessProduct&&) noexcept = default;
template <int D>
StiffnessProduct<D>::~StiffnessProduct() = default;

template <int D>
void StiffnessProduct<D>::product(const VectorField<D>& x, VectorField<D>& force) {
  Parts& p = *parts_;
  const Storage<D>& storage = p.storage;
  std::array<double*, D + 1> stress{};
  for (std::size_t a = 0; a < p.stress.size(); ++a) stress[a] = p.stress[a].data();
  const auto gradient = storage.modes ? p.loops.gradient_and_modes : p.loops.gradient;
  const auto divergence = storage.modes ? p.loops.divergence_and_modes : p.loops.divergence;
  std::vector<Buffer<D>> buffers(static_cast<std::size_t>(p.threads));
  const auto share = [&](const auto& all, int part, const auto& visit) {
    const auto own = static_cast<std::size_t>(part);
    const std::size_t count = all.blocks.size();
    for (std::size_t b = count * own / buffers.size(); b < count * (own + 1) / buffers.size(); ++b)
      visit(all.blocks[b], buffers[own]);
  };
  static TeamChoice choice;  // one for every pass of the program
  in_parts(
      choice, static_cast<double>(p.disc.nodes()), p.threads, p.threads,
      [&](int part) {
        share(p.points, part, [&](const auto& block, const Buffer<D>& buffer) {
          double* const* out = buffer.changes();
          gradient(storage.gradient_table, Parts::runs_of(p.points, block), x.data(), x.size(),
                   {out, block.first});
          p.stresses(block.first, block.last, out, buffer.strains());
          if (storage.modes && p.state != nullptr)
            std::copy_n(out[D], (block.last - block.first) * D, stress[D] + block.first * D);
        });
      },
      [&](int part) {
        share(p.nodes, part, [&](const auto& block, const Buffer<D>& buffer) {
          double* const* out = buffer.changes();
          divergence(storage.divergence_table, Parts::runs_of(p.nodes, block), {stress.data(), 0},
                     out[0], block.first);
          for (Index q = block.first; q < block.last; ++q)
            for (int i = 0; i < D; ++i)
              force.data()[q * D + i] = p.disc.mass[q] * out[0][(q - block.first) * D + i];
        });
      });
  if (p.state != nullptr && p.disc.stiffness.nonZeros() > 0)
    subtract_differences<D>(p.disc.stiffness, x, force);
}

template class StiffnessProduct<1>;
template class StiffnessProduct<2>;

}  // namespace tlsph
