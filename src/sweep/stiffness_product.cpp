#include "tlsph/sweep/stiffness_product.hpp"

#include <omp.h>

#include "fields.hpp"
#include "region_laws.hpp"
#include "storage.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph {

using namespace sweep;

template <int D>
struct StiffnessProduct<D>::Parts {
  /// One thread's fields of a block.
  struct Buffer {
    Fields<D> changes, strains;
  };

  const Discretisation<D>& body;
  const State<D>* state;  // none: the unit tangent
  std::unique_ptr<Storage<D>> own;
  const Storage<D>& storage;
  const Loops<D>& loops;
  Blocks points, nodes;
  std::vector<RegionLaw<D>> laws;
  std::vector<int> regions;
  Fields<D> stress;  // the changes, of all points
  int threads = 1;

  Parts(const Discretisation<D>& discretisation, const State<D>* at, const Sweep<D>* sweep)
      : body(discretisation),
        state(at),
        own(sweep == nullptr ? std::make_unique<Storage<D>>(body, false) : nullptr),
        storage(sweep == nullptr ? *own : sweep->operators()),
        loops(sweep::loops<D>(Instructions::widest)),
        points(storage.gradient.runs, body.points.size()),
        nodes(storage.divergence.runs, body.nodes()),
        stress(storage.tables.modes ? D + 1 : D, body.points.size()),
        threads(worth_threads(body.nodes()) ? omp_get_max_threads() : 1) {
    if (state == nullptr) return;
    laws = region_laws<D>(body, loops, false);
    regions = regions_of_points(body);
  }

  /// The change of the stresses of points [first, last), from that of the strains in the buffer.
  void stresses(Index first, Index last, Buffer& buffer) {
    const auto copy = [&](int a) {
      std::copy_n(buffer.changes.at(first, a), (last - first) * D, stress.at(first, a));
    };
    if (state != nullptr && storage.tables.modes) copy(D);
    if (state == nullptr) {
      for (int a = 0; a < D; ++a) copy(a);
      return;
    }
    buffer.strains.base = first;
    buffer.strains.read(state->H, first, last);
    for_laws(regions, first, last, [&](std::size_t region, Index from, Index end) {
      laws[region].tangent(buffer.strains.from(from).data(), buffer.changes.from(from).data(),
                           stress.from(from).data(), end - from);
    });
  }
};

template <int D>
StiffnessProduct<D>::StiffnessProduct(const Discretisation<D>& body, const State<D>& state,
                                      const Sweep<D>* sweep)
    : parts_(std::make_unique<Parts>(body, &state, sweep)) {}
template <int D>
StiffnessProduct<D>::StiffnessProduct(const Discretisation<D>& body, const Sweep<D>& sweep)
    : parts_(std::make_unique<Parts>(body, nullptr, &sweep)) {}
template <int D>
StiffnessProduct<D>::StiffnessProduct(StiffnessProduct&&) noexcept = default;
template <int D>
StiffnessProduct<D>::~StiffnessProduct() = default;

template <int D>
void StiffnessProduct<D>::product(const VectorField<D>& x, VectorField<D>& force) {
  Parts& p = *parts_;
  const Operators& tables = p.storage.tables;
  const Products& products = p.loops.products[tables.modes];
  std::vector<typename Parts::Buffer> buffers;
  for (int t = 0; t < p.threads; ++t)
    buffers.push_back({Fields<D>(D + 1, block_rows), Fields<D>(D, block_rows)});
  static TeamChoice choice;  // one for every pass of the program
  in_parts(
      choice, static_cast<double>(p.body.nodes()), p.threads, p.threads,
      [&](int part) {
        auto& buffer = buffers[static_cast<std::size_t>(part)];
        p.points.for_part(part, p.threads, [&](Index first, Index last, Runs runs) {
          buffer.changes.base = first;
          products.gradient(tables.gradient, runs, x.data(), x.size(), buffer.changes.window());
          p.stresses(first, last, buffer);
        });
      },
      [&](int part) {
        Fields<D>& out = buffers[static_cast<std::size_t>(part)].changes;
        p.nodes.for_part(part, p.threads, [&](Index first, Index last, Runs runs) {
          out.base = first;
          products.divergence(tables.divergence, runs, p.stress.window(), out.at(first), first);
          for (Index q = first; q < last; ++q)
            for (int i = 0; i < D; ++i) force(q, i) = p.body.mass[q] * out.at(q)[i];
        });
      });
  if (p.state != nullptr && p.body.stiffness.nonZeros() > 0)
    subtract_differences<D>(p.body.stiffness, x, force);
}

template class StiffnessProduct<1>;
template class StiffnessProduct<2>;

}  // namespace tlsph
