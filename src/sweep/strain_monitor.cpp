#include "tlsph/sweep/strain_monitor.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "region_laws.hpp"
#include "storage.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/materials/any_law.hpp"

namespace tlsph {
namespace {

using namespace sweep;

/// H of the stretch, U − 1 with F = R U, in the place of H: A(R U) has the eigenvalues of A(U), so
/// a body that turns has not deformed.
template <int D>
void remove_rotation(Index count, double* const* H) {
  if constexpr (D == 2)
    for (Index s = 0; s < count; ++s) {
      double* x = H[0] + 2 * s;  // F_11 − 1, F_21
      double* y = H[1] + 2 * s;  // F_12, F_22 − 1
      const double p = 2.0 + x[0] + y[1];
      const double q = x[1] - y[0];
      const double r = std::sqrt(p * p + q * q);
      if (!(r > 0.0)) continue;
      const double c = p / r;
      const double n = q / r;
      const double F11 = 1.0 + x[0];
      const double F22 = 1.0 + y[1];
      const double off = c * y[0] + n * F22;
      x[0] = c * F11 + n * x[1] - 1.0;
      y[1] = c * F22 - n * y[0] - 1.0;
      x[1] = y[0] = off;
    }
}

/// One thread's strains of a block, and a row of the stabiliser where the operators have one.
template <int D>
struct Buffer {
  std::array<std::vector<double>, D + 1> values;
  std::array<double*, D + 1> direction{};
  typename StrainMonitor<D>::Change most;

  Buffer() {
    for (std::size_t a = 0; a < values.size(); ++a) {
      values[a].assign(static_cast<std::size_t>(block_rows * D + overrun), 0.0);
      direction[a] = values[a].data();
    }
  }
};

}  // namespace

template <int D>
struct StrainMonitor<D>::Parts {
  using Directions = std::array<const double*, static_cast<std::size_t>(D)>;
  using Stored = std::array<const float*, static_cast<std::size_t>(D)>;
  struct Memories {
    const MemoryField& now;
    const MemoryField& before;
  };

  const Discretisation<D>& disc;
  const Loops<D>& loops;
  const Storage<D>* storage = nullptr;
  Index points, blocks;
  std::vector<RowRun> runs;      // of the gradient, cut to the blocks
  std::vector<Index> first_run;  // of every block, and one more
  std::vector<RegionLaw<D>> laws;
  std::vector<int> region;  // of every point; empty if there is one only
  std::vector<std::unique_ptr<Buffer<D>>> buffers;

  explicit Parts(const Discretisation<D>& discretisation)
      : disc(discretisation),
        loops(sweep::loops<D>(widest_level())),
        points(disc.points.size()),
        blocks((points + block_rows - 1) / block_rows),
        laws(region_laws<D>(disc, loops, false)),
        region(regions_of_points(disc)) {
    const int threads = worth_threads(points) ? omp_get_max_threads() : 1;
    for (int t = 0; t < threads; ++t) buffers.push_back(std::make_unique<Buffer<D>>());
  }

  void read(Index block, const State<D>& state, double* const* H) const {
    const Index first = block * block_rows;
    const Index count = std::min(block_rows, points - first);
    if (storage != nullptr) {
      const auto b = static_cast<std::size_t>(block);
      (storage->modes ? loops.gradient_and_modes : loops.gradient)(
          storage->gradient_table, {runs.data() + first_run[b], first_run[b + 1] - first_run[b]},
          state.u.data(), state.u.size(), {H, first});
    } else {
      for (Index s = 0; s < count; ++s)
        for (int i = 0; i < D; ++i)
          for (int a = 0; a < D; ++a) H[a][s * D + i] = state.H(first + s, i * D + a);
    }
    remove_rotation<D>(count, H);
  }

  /// The largest of each number of visit(first, count, H) over the blocks, at least zero. Maxima do
  /// not depend on the order, nor on the number of threads.
  template <class Visit>
  Change largest(const State<D>& state, const Visit& visit) {
    static TeamChoice choice;  // one for every monitor of the program
    const auto parts = static_cast<int>(buffers.size());
    in_parts(choice, static_cast<double>(points), parts, parts, [&](int part) {
      Buffer<D>& buffer = *buffers[static_cast<std::size_t>(part)];
      buffer.most = {};
      for (Index b = blocks * part / parts; b < blocks * (part + 1) / parts; ++b) {
        read(b, state, buffer.direction.data());
        Directions H;
        std::copy_n(buffer.direction.begin(), D, H.begin());
        const Index first = b * block_rows;
        const Change change = visit(first, std::min(block_rows, points - first), H);
        buffer.most.stiffening = std::max(buffer.most.stiffening, change.stiffening);
        buffer.most.deformation = std::max(buffer.most.deformation, change.deformation);
      }
    });
    Change most;
    for (const auto& buffer : buffers) {
      most.stiffening = std::max(most.stiffening, buffer->most.stiffening);
      most.deformation = std::max(most.deformation, buffer->most.deformation);
    }
    return most;
  }

  [[nodiscard]] Stored at(const StrainField& field, Index point) const {
    Stored result;
    for (std::size_t a = 0; a < D; ++a)
      result[a] = field.data() + (static_cast<Index>(a) * points + point) * D;
    return result;
  }

  void copy(Index first, Index count, const Directions& H, StrainField& to) const {
    for (std::size_t a = 0; a < D; ++a)
      std::transform(H[a], H[a] + count * D,
                     to.data() + (static_cast<Index>(a) * points + first) * D,
                     [](double value) { return static_cast<float>(value); });
  }

  [[nodiscard]] double stiffening_of_block(Index first, Index count, const Directions& H,
                                           const Stored& before, const Memories& memories) const {
    if (region.empty()) return stiffening_of_region(0, first, count, H, before, memories);
    double most = 0.0;
    for (Index s = 0; s < count;) {
      const int law = region[static_cast<std::size_t>(first + s)];
      Index end = s + 1;
      while (end < count && region[static_cast<std::size_t>(first + end)] == law) ++end;
      Directions some = H;
      Stored some_before = before;
      for (std::size_t a = 0; a < D; ++a) {
        some[a] += s * D;
        some_before[a] += s * D;
      }
      most = std::max(most,
                      stiffening_of_region(law, first + s, end - s, some, some_before, memories));
      s = end;
    }
    return most;
  }

  [[nodiscard]] double stiffening_of_region(Index number, Index first, Index count,
                                            const Directions& H, const Stored& before,
                                            const Memories& memories) const {
    const RegionLaw<D>& law = laws[static_cast<std::size_t>(number)];
    if (law.loops == nullptr) return stiffening_of(law.law, first, count, H, before, memories);
    return law.loops->stiffening(law.text(), H.data(), before.data(), count);
  }

  /// The same of a law without loops, by Gershgorin's discs.
  [[nodiscard]] static double stiffening_of(const AnyLaw<D>& law, Index first, Index count,
                                            const Directions& H, const Stored& before,
                                            const Memories& memories) {
    const auto tangent_at = [&](const auto& field, const MemoryField& memory, Index s) {
      Tensor<D> strain;
      for (int i = 0; i < D; ++i)
        for (int a = 0; a < D; ++a) strain(i, a) = field[static_cast<std::size_t>(a)][s * D + i];
      return tangent<D>(law, strain, {memory.data() + (first + s) * memory.cols(), 0.0});
    };
    double end = 0.0;
    for (Index s = 0; s < count; ++s) {
      const Tangent<D> A = tangent_at(H, memories.now, s) - tangent_at(before, memories.before, s);
      for (int i = 0; i < D * D; ++i)
        end = std::max(end, A(i, i) + A.row(i).cwiseAbs().sum() - std::abs(A(i, i)));
    }
    return end;
  }
};

template <int D>
StrainMonitor<D>::StrainMonitor(const Discretisation<D>& disc)
    : parts_(std::make_unique<Parts>(disc)) {}
template <int D>
StrainMonitor<D>::~StrainMonitor() = default;

template <int D>
void StrainMonitor<D>::use_operators_of(const Sweep<D>& sweep) {
  Parts& p = *parts_;
  p.storage = &sweep.operators();
  for (Index b = 0; b < p.blocks; ++b)
    p.first_run.push_back(append_runs(p.storage->gradient.runs, b * block_rows,
                                      std::min(p.points, (b + 1) * block_rows), p.runs));
  p.first_run.push_back(static_cast<Index>(p.runs.size()));
}

template <int D>
bool StrainMonitor<D>::reads_strains() const {
  return parts_->storage == nullptr;
}

template <int D>
StrainField StrainMonitor<D>::strains(const State<D>& state) {
  StrainField field(static_cast<std::size_t>(parts_->points * D * D));
  store(state, field);
  return field;
}

template <int D>
void StrainMonitor<D>::store(const State<D>& state, StrainField& to) {
  (void)parts_->largest(state, [&](Index first, Index count, const auto& H) {
    parts_->copy(first, count, H, to);
    return Change{};
  });
}

template <int D>
double StrainMonitor<D>::deformation(const State<D>& state, const StrainField& before) {
  const Change most = parts_->largest(state, [&](Index first, Index count, const auto& H) {
    return Change{0.0,
                  parts_->loops.deformation(H.data(), parts_->at(before, first).data(), count)};
  });
  return std::sqrt(most.deformation);
}

template <int D>
double StrainMonitor<D>::stiffening(const State<D>& state, const StrainField& before,
                                    const MemoryField& memory_before) {
  const typename Parts::Memories memories{state.memory, memory_before};
  return parts_
      ->largest(state,
                [&](Index first, Index count, const auto& H) {
                  return Change{parts_->stiffening_of_block(first, count, H,
                                                            parts_->at(before, first), memories),
                                0.0};
                })
      .stiffening;
}

template <int D>
auto StrainMonitor<D>::change(const State<D>& state, const StrainField& before,
                              const MemoryField& memory_before, StrainField& to) -> Change {
  const typename Parts::Memories memories{state.memory, memory_before};
  Change most = parts_->largest(state, [&](Index first, Index count, const auto& H) {
    const auto then = parts_->at(before, first);
    parts_->copy(first, count, H, to);
    return Change{parts_->stiffening_of_block(first, count, H, then, memories),
                  parts_->loops.deformation(H.data(), then.data(), count)};
  });
  most.deformation = std::sqrt(most.deformation);
  return most;
}

template class StrainMonitor<1>;
template class StrainMonitor<2>;

}  // namespace tlsph
