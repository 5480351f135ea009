#include "tlsph/sweep/strain_monitor.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "fields.hpp"
#include "region_laws.hpp"
#include "storage.hpp"
#include "tlsph/core/parallel.hpp"

namespace tlsph {

using namespace sweep;

namespace {

/// H of the stretch, U − 1 with F = R U, in the place of H: A(R U) has the eigenvalues of A(U), so
/// a body that turns has not deformed.
template <int D>
void remove_rotation(Index count, const std::array<double*, D>& H) {
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
struct StrainMonitor<D>::Parts {
  /// One thread's strains of a block, and a row of the stabiliser where the operators have one.
  struct Buffer {
    Fields<D> strains;
    Change most;
  };
  using Stored = std::array<const float*, static_cast<std::size_t>(D)>;

  const Discretisation<D>& body;
  const Loops<D>& loops;
  const Storage<D>* storage = nullptr;
  Index points;
  Blocks blocks;
  std::vector<RegionLaw<D>> laws;
  std::vector<int> regions;
  std::vector<Buffer> buffers;

  explicit Parts(const Discretisation<D>& discretisation)
      : body(discretisation),
        loops(sweep::loops<D>(Instructions::widest)),
        points(body.points.size()),
        blocks({}, points),
        laws(region_laws<D>(body, loops, false)),
        regions(regions_of_points(body)) {
    const int threads = worth_threads(points) ? omp_get_max_threads() : 1;
    for (int t = 0; t < threads; ++t) buffers.push_back({Fields<D>(D + 1, block_rows), {}});
  }

  /// The largest of each number of visit(strains, first, last) over the blocks, at least zero.
  /// Maxima do not depend on the order, nor on the number of threads.
  template <class Visit>
  Change largest(const State<D>& state, const Visit& visit) {
    static TeamChoice choice;  // one for every monitor of the program
    const auto parts = static_cast<int>(buffers.size());
    const auto add = [](Change& most, const Change& other) {
      most.stiffening = std::max(most.stiffening, other.stiffening);
      most.deformation = std::max(most.deformation, other.deformation);
    };
    in_parts(choice, static_cast<double>(points), parts, parts, [&](int part) {
      auto& [strains, own] = buffers[static_cast<std::size_t>(part)];
      own = {};
      blocks.for_part(part, parts, [&](Index first, Index last, Runs runs) {
        strains.base = first;
        if (storage != nullptr)
          loops.products[storage->tables.modes].gradient(
              storage->tables.gradient, runs, state.u.data(), state.u.size(), strains.window());
        else
          strains.read(state.H, first, last);
        remove_rotation<D>(last - first, strains.from(first));
        add(own, visit(strains, first, last));
      });
    });
    Change most;
    for (const Buffer& buffer : buffers) add(most, buffer.most);
    return most;
  }

  [[nodiscard]] Stored at(const StrainField& field, Index point) const {
    Stored result;
    for (std::size_t a = 0; a < D; ++a)
      result[a] = field.data() + (static_cast<Index>(a) * points + point) * D;
    return result;
  }

  void store(const Fields<D>& strains, Index first, Index last, StrainField& to) const {
    for (int a = 0; a < D; ++a)
      std::transform(strains.at(first, a), strains.at(last, a),
                     to.data() + (a * points + first) * D,
                     [](double value) { return static_cast<float>(value); });
  }

  /// ‖U − U₀‖² ‖U⁻¹‖², the largest.
  [[nodiscard]] double deformation(const Fields<D>& strains, Index first, Index last,
                                   const StrainField& before) const {
    return loops.deformation(strains.from(first).data(), at(before, first).data(), last - first);
  }
};

template <int D>
StrainMonitor<D>::StrainMonitor(const Discretisation<D>& body)
    : parts_(std::make_unique<Parts>(body)) {}
template <int D>
StrainMonitor<D>::~StrainMonitor() = default;

template <int D>
void StrainMonitor<D>::use_operators_of(const Sweep<D>& sweep) {
  parts_->storage = &sweep.operators();
  parts_->blocks = Blocks(parts_->storage->gradient.runs, parts_->points);
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
  (void)parts_->largest(state, [&](const Fields<D>& strains, Index first, Index last) {
    parts_->store(strains, first, last, to);
    return Change{};
  });
}

template <int D>
double StrainMonitor<D>::deformation(const State<D>& state, const StrainField& before) {
  const Change most =
      parts_->largest(state, [&](const Fields<D>& strains, Index first, Index last) {
        return Change{0.0, parts_->deformation(strains, first, last, before)};
      });
  return std::sqrt(most.deformation);
}

template <int D>
auto StrainMonitor<D>::change(const State<D>& state, const StrainField& before,
                              const MemoryField& memory_before, StrainField& to) -> Change {
  const Parts& p = *parts_;
  Change most = parts_->largest(state, [&](const Fields<D>& strains, Index first, Index last) {
    Change block{0.0, p.deformation(strains, first, last, before)};
    for_laws(p.regions, first, last, [&](std::size_t region, Index from, Index end) {
      block.stiffening =
          std::max(block.stiffening,
                   p.laws[region].stiffening(strains.from(from).data(), p.at(before, from).data(),
                                             from, end - from, state.memory, memory_before));
    });
    p.store(strains, first, last, to);
    return block;
  });
  most.deformation = std::sqrt(most.deformation);
  return most;
}

template class StrainMonitor<1>;
template class StrainMonitor<2>;

}  // namespace tlsph
