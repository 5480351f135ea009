#include "tangent_pass.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <variant>

#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph::sweep {
namespace {

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
TangentPass<D>::TangentPass(const Discretisation<D>& disc, const State<D>& state,
                            const Storage<D>* operators)
    : disc_(disc),
      state_(&state),
      own_(operators == nullptr ? std::make_unique<Storage<D>>(disc, false) : nullptr),
      storage_(operators == nullptr ? *own_ : *operators),
      kernels_(kernels<D>(widest_level())),
      points_(cut(storage_.gradient.runs, disc.points.size())),
      nodes_(cut(storage_.divergence.runs, disc.nodes())),
      laws_(region_laws<D>(disc, kernels_, false)),
      region_(regions_of_points(disc)) {
  allocate();
}

template <int D>
TangentPass<D>::TangentPass(const Discretisation<D>& disc, const Storage<D>& operators)
    : disc_(disc),
      storage_(operators),
      kernels_(kernels<D>(widest_level())),
      points_(cut(storage_.gradient.runs, disc.points.size())),
      nodes_(cut(storage_.divergence.runs, disc.nodes())) {
  allocate();
}

template <int D>
void TangentPass<D>::allocate() {
  stress_.resize(storage_.modes ? D + 1 : D);
  for (auto& stress : stress_)
    stress.assign(static_cast<std::size_t>(disc_.points.size() * D + overrun), 0.0);
  threads_ = worth_threads(disc_.nodes()) ? omp_get_max_threads() : 1;
}

template <int D>
auto TangentPass<D>::cut(const std::vector<RowRun>& runs, Index rows) -> Blocks {
  Blocks result;
  for (Index first = 0; first < rows; first += block_rows) {
    const Index last = std::min(first + block_rows, rows);
    const Index run = append_runs(runs, first, last, result.runs);
    result.blocks.push_back({first, last, run, static_cast<Index>(result.runs.size()) - run});
  }
  return result;
}

template <int D>
void TangentPass<D>::stresses(Index first, Index last, double* const* window,
                              double* const* strain) {
  if (state_ == nullptr) {
    for (std::size_t a = 0; a < D; ++a)
      std::copy_n(window[a], (last - first) * D, stress_[a].data() + first * D);
    return;
  }
  for (Index s = first; s < last;) {
    const int region = region_.empty() ? 0 : region_[static_cast<std::size_t>(s)];
    Index end = region_.empty() ? last : s + 1;
    while (end < last && region_[static_cast<std::size_t>(end)] == region) ++end;
    std::array<const double*, D> change{};
    std::array<double*, D> stress{};
    for (std::size_t a = 0; a < D; ++a) {
      change[a] = window[a] + (s - first) * D;
      stress[a] = stress_[a].data() + s * D;
    }
    apply_tangent<D>(laws_[static_cast<std::size_t>(region)], state_->H.data() + s * D * D, end - s,
                     strain, change, stress);
    s = end;
  }
}

template <int D>
void TangentPass<D>::product(const VectorField<D>& x, VectorField<D>& force) {
  std::array<double*, D + 1> stress{};
  for (std::size_t a = 0; a < stress_.size(); ++a) stress[a] = stress_[a].data();
  const auto gradient = storage_.modes ? kernels_.gradient_and_modes : kernels_.gradient;
  const auto divergence = storage_.modes ? kernels_.divergence_and_modes : kernels_.divergence;
  std::vector<Buffer<D>> buffers(static_cast<std::size_t>(threads_));
  const auto share = [&](const Blocks& all, int part, const auto& visit) {
    const auto p = static_cast<std::size_t>(part);
    const std::size_t count = all.blocks.size();
    for (std::size_t b = count * p / buffers.size(); b < count * (p + 1) / buffers.size(); ++b)
      visit(all.blocks[b], buffers[p]);
  };
  static TeamChoice choice;  // one for every pass of the program
  in_parts(
      choice, static_cast<double>(disc_.nodes()), threads_, threads_,
      [&](int part) {
        share(points_, part, [&](const Block& block, const Buffer<D>& buffer) {
          double* const* out = buffer.changes();
          gradient(storage_.gradient_table, runs_of(points_, block), x.data(), x.size(),
                   {out, block.first});
          stresses(block.first, block.last, out, buffer.strains());
          if (storage_.modes && state_ != nullptr)
            std::copy_n(out[D], (block.last - block.first) * D, stress[D] + block.first * D);
        });
      },
      [&](int part) {
        share(nodes_, part, [&](const Block& block, const Buffer<D>& buffer) {
          double* const* out = buffer.changes();
          divergence(storage_.divergence_table, runs_of(nodes_, block), {stress.data(), 0}, out[0],
                     block.first);
          for (Index q = block.first; q < block.last; ++q)
            for (int i = 0; i < D; ++i)
              force.data()[q * D + i] = disc_.mass[q] * out[0][(q - block.first) * D + i];
        });
      });
  if (state_ != nullptr && disc_.stiffness.nonZeros() > 0)
    subtract_differences<D>(disc_.stiffness, x, force);
}

template class TangentPass<1>;
template class TangentPass<2>;

}  // namespace tlsph::sweep
