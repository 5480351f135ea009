#include "tangent_pass.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <variant>

#include "sweep_region_laws.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph::sweep {
namespace {

/// One thread's fields of a block.
template <int D>
class Buffer {
 public:
  Buffer() : values_(static_cast<std::size_t>((D + 1) * stride), 0.0) {
    for (std::size_t a = 0; a <= D; ++a)
      direction_[a] = values_.data() + static_cast<Index>(a) * stride;
  }
  [[nodiscard]] double* const* data() const { return direction_.data(); }

 private:
  static constexpr Index stride = block_rows * D + overrun;
  std::vector<double> values_;
  std::array<double*, D + 1> direction_{};
};

/// Whether part of the law's tangent is worth keeping from product to product.
template <class Law, int D>
constexpr bool keeps_factors = requires(const Law& law, const Tensor<D>& H) {
  law.plane_tangent(H);
};
/// Numbers a point of what is kept.
constexpr Index kept = 2;

template <int D>
Tensor<D> strain_at(const double* H, Index s) {
  return Eigen::Map<const Tensor<D>>(H + s * D * D);
}

template <class Law, int D>
void apply_tangent(const Law& law, const double* H, [[maybe_unused]] const double* factors,
                   Index count, const std::array<const double*, D>& change,
                   const std::array<double*, D>& stress) {
  for (Index s = 0; s < count; ++s) {
    Tensor<D> dH, dP;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) dH(i, a) = change[static_cast<std::size_t>(a)][s * D + i];
    if constexpr (keeps_factors<Law, D>)
      dP = law.dpk1({factors[s * kept], factors[s * kept + 1]}, strain_at<D>(H, s), dH);
    else
      dP = law.dpk1(strain_at<D>(H, s), dH);
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) stress[static_cast<std::size_t>(a)][s * D + i] = dP(i, a);
  }
}

/// What the law of a region keeps of its points.
template <int D>
void keep_factors(const Region<D>& region, const TensorField<D>& H, std::vector<double>& factors) {
  std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (keeps_factors<Law, D>) {
          factors.resize(static_cast<std::size_t>(H.rows() * kept));
          const auto at = [&](Index s) {
            const auto tangent = law.plane_tangent(tensor_at<D>(H, s));
            factors[static_cast<std::size_t>(s * kept)] = tangent.turned;
            factors[static_cast<std::size_t>(s * kept + 1)] = tangent.along;
          };
          if (region.points.empty())
            for_rows(H.rows(), at);
          else
            for_rows(static_cast<Index>(region.points.size()),
                     [&](Index k) { at(region.points[static_cast<std::size_t>(k)]); });
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
      region_(regions_of_points(disc)) {
  for (const Region<D>& region : disc.regions) keep_factors<D>(region, state.H, factors_);
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
void TangentPass<D>::stresses(Index first, Index last, double* const* window) {
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
    std::visit(
        [&]<class Law>(const Law& law) {
          apply_tangent<Law, D>(law, state_->H.data() + s * D * D,
                                factors_.empty() ? nullptr : factors_.data() + s * kept, end - s,
                                change, stress);
        },
        disc_.regions[static_cast<std::size_t>(region)].law);
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
      visit(all.blocks[b], buffers[p].data());
  };
  static TeamChoice choice;  // one for every pass of the program
  in_parts(
      choice, static_cast<double>(disc_.nodes()), threads_, threads_,
      [&](int part) {
        share(points_, part, [&](const Block& block, double* const* out) {
          gradient(storage_.gradient_table, runs_of(points_, block), x.data(), x.size(),
                   {out, block.first});
          stresses(block.first, block.last, out);
          if (storage_.modes && state_ != nullptr)
            std::copy_n(out[D], (block.last - block.first) * D, stress[D] + block.first * D);
        });
      },
      [&](int part) {
        share(nodes_, part, [&](const Block& block, double* const* out) {
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
