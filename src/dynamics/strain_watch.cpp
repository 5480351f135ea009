#include "strain_watch.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "tlsph/core/parallel.hpp"
#include "tlsph/materials/any_law.hpp"

namespace tlsph::sweep {
namespace {

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

}  // namespace

template <int D>
StrainWatch<D>::StrainWatch(const Discretisation<D>& disc)
    : disc_(disc),
      kernels_(kernels<D>(widest_level())),
      points_(disc.points.size()),
      blocks_((points_ + block_rows - 1) / block_rows),
      laws_(region_laws<D>(disc, kernels_, false)),
      region_(regions_of_points(disc)) {
  const int threads = worth_threads(points_) ? omp_get_max_threads() : 1;
  for (int t = 0; t < threads; ++t) {
    buffers_.push_back(std::make_unique<Buffer>());
    Buffer& buffer = *buffers_.back();
    for (std::size_t a = 0; a < most_directions; ++a) {
      buffer.values[a].assign(static_cast<std::size_t>(block_rows * D + overrun), 0.0);
      buffer.direction[a] = buffer.values[a].data();
    }
  }
}

template <int D>
void StrainWatch<D>::read_by(const Sweep<D>& sweep) {
  storage_ = &sweep.operators();
  for (Index b = 0; b < blocks_; ++b)
    first_run_.push_back(append_runs(storage_->gradient.runs, b * block_rows,
                                     std::min(points_, (b + 1) * block_rows), runs_));
  first_run_.push_back(static_cast<Index>(runs_.size()));
}

template <int D>
void StrainWatch<D>::read(Index block, const State<D>& state, double* const* H) const {
  const Index first = block * block_rows;
  const Index count = std::min(block_rows, points_ - first);
  if (storage_ != nullptr) {
    const auto b = static_cast<std::size_t>(block);
    (storage_->modes ? kernels_.gradient_and_modes : kernels_.gradient)(
        storage_->gradient_table, {runs_.data() + first_run_[b], first_run_[b + 1] - first_run_[b]},
        state.u.data(), state.u.size(), {H, first});
  } else {
    for (Index s = 0; s < count; ++s)
      for (int i = 0; i < D; ++i)
        for (int a = 0; a < D; ++a) H[a][s * D + i] = state.H(first + s, i * D + a);
  }
  remove_rotation<D>(count, H);
}

/// Maxima do not depend on the order, nor on the number of threads.
template <int D>
template <class Visit>
auto StrainWatch<D>::largest(const State<D>& state, const Visit& visit) -> Change {
  const auto look = [&](Index block, Buffer& buffer) -> Change {
    read(block, state, buffer.direction.data());
    Directions H;
    std::copy_n(buffer.direction.begin(), D, H.begin());
    const Index first = block * block_rows;
    return visit(first, std::min(block_rows, points_ - first), H);
  };
  static TeamChoice choice;  // one for every watch of the program
  const auto parts = static_cast<int>(buffers_.size());
  in_parts(choice, static_cast<double>(points_), parts, parts, [&](int part) {
    Buffer& buffer = *buffers_[static_cast<std::size_t>(part)];
    buffer.most = {};
    for (Index b = blocks_ * part / parts; b < blocks_ * (part + 1) / parts; ++b) {
      const Change change = look(b, buffer);
      buffer.most.stiffening = std::max(buffer.most.stiffening, change.stiffening);
      buffer.most.deformation = std::max(buffer.most.deformation, change.deformation);
    }
  });
  Change most;
  for (const auto& buffer : buffers_) {
    most.stiffening = std::max(most.stiffening, buffer->most.stiffening);
    most.deformation = std::max(most.deformation, buffer->most.deformation);
  }
  return most;
}

template <int D>
auto StrainWatch<D>::at(const StrainField& field, Index point) const -> Stored {
  Stored result;
  for (std::size_t a = 0; a < D; ++a)
    result[a] = field.data() + (static_cast<Index>(a) * points_ + point) * D;
  return result;
}

template <int D>
void StrainWatch<D>::copy(Index first, Index count, const Directions& H, StrainField& to) const {
  for (std::size_t a = 0; a < D; ++a)
    std::transform(H[a], H[a] + count * D,
                   to.data() + (static_cast<Index>(a) * points_ + first) * D,
                   [](double value) { return static_cast<float>(value); });
}

template <int D>
StrainField StrainWatch<D>::strains(const State<D>& state) {
  StrainField field(static_cast<std::size_t>(points_ * D * D));
  store(state, field);
  return field;
}

template <int D>
void StrainWatch<D>::store(const State<D>& state, StrainField& to) {
  (void)largest(state, [&](Index first, Index count, const Directions& H) {
    copy(first, count, H, to);
    return Change{};
  });
}

template <int D>
double StrainWatch<D>::deformation(const State<D>& state, const StrainField& before) {
  const Change most = largest(state, [&](Index first, Index count, const Directions& H) {
    return Change{0.0, kernels_.deformation(H.data(), at(before, first).data(), count)};
  });
  return std::sqrt(most.deformation);
}

template <int D>
double StrainWatch<D>::stiffening(const State<D>& state, const StrainField& before,
                                  const MemoryField& memory_before) {
  const Memories memories{state.memory, memory_before};
  return largest(state,
                 [&](Index first, Index count, const Directions& H) {
                   return Change{stiffening_of_block(first, count, H, at(before, first), memories),
                                 0.0};
                 })
      .stiffening;
}

template <int D>
auto StrainWatch<D>::change(const State<D>& state, const StrainField& before,
                            const MemoryField& memory_before, StrainField& to) -> Change {
  const Memories memories{state.memory, memory_before};
  Change most = largest(state, [&](Index first, Index count, const Directions& H) {
    const Stored then = at(before, first);
    copy(first, count, H, to);
    return Change{stiffening_of_block(first, count, H, then, memories),
                  kernels_.deformation(H.data(), then.data(), count)};
  });
  most.deformation = std::sqrt(most.deformation);
  return most;
}

template <int D>
double StrainWatch<D>::stiffening_of_block(Index first, Index count, const Directions& H,
                                           const Stored& before, const Memories& memories) const {
  if (region_.empty()) return stiffening_of_region(0, first, count, H, before, memories);
  double most = 0.0;
  for (Index s = 0; s < count;) {
    const int region = region_[static_cast<std::size_t>(first + s)];
    Index end = s + 1;
    while (end < count && region_[static_cast<std::size_t>(first + end)] == region) ++end;
    Directions some = H;
    Stored some_before = before;
    for (std::size_t a = 0; a < D; ++a) {
      some[a] += s * D;
      some_before[a] += s * D;
    }
    most = std::max(most,
                    stiffening_of_region(region, first + s, end - s, some, some_before, memories));
    s = end;
  }
  return most;
}

template <int D>
double StrainWatch<D>::stiffening_of_region(Index region, Index first, Index count,
                                            const Directions& H, const Stored& before,
                                            const Memories& memories) const {
  const RegionLaw<D>& law = laws_[static_cast<std::size_t>(region)];
  if (law.loops == nullptr) return stiffening_of(law.law, first, count, H, before, memories);
  return law.loops->stiffening(law.text(), H.data(), before.data(), count);
}

/// By Gershgorin's discs.
template <int D>
double StrainWatch<D>::stiffening_of(const AnyLaw<D>& law, Index first, Index count,
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

template class StrainWatch<1>;
template class StrainWatch<2>;

}  // namespace tlsph::sweep
