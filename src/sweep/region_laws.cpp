#include "region_laws.hpp"

#include <cmath>
#include <limits>
#include <variant>

namespace tlsph::sweep {
namespace {

template <int D, class Number>
Tensor<D> tensor_of(const Number* const* field, Index s) {
  Tensor<D> H;
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a) H(i, a) = field[a][s * D + i];
  return H;
}

template <int D>
void write(const Tensor<D>& P, double* const* field, Index s) {
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a) field[a][s * D + i] = P(i, a);
}

}  // namespace

template <int D>
const void* RegionLaw<D>::text() const {
  return std::visit(
      [](const auto& held) -> const void* {
        if constexpr (requires { held.text(); })
          return &held.text();
        else
          return nullptr;
      },
      law);
}

template <int D>
bool RegionLaw<D>::stress(double* const* field, Index first, Index count) const {
  if (loops != nullptr) return loops->stress(text(), field, first, count);
  double sum = 0.0;
  std::visit(
      [&](const auto& held) {
        for (Index s = first; s < first + count; ++s) {
          const Tensor<D> H = tensor_of<D>(field, s);
          const Tensor<D> P = linearised ? held.dpk1(Tensor<D>::Zero(), H) : Tensor<D>(held.pk1(H));
          sum += P(0, 0);
          if (!linearised && !(held.margin(H) > 0.0))
            sum = std::numeric_limits<double>::quiet_NaN();
          write<D>(P, field, s);
        }
      },
      law);
  return std::isfinite(sum);
}

template <int D>
void RegionLaw<D>::tangent(const double* const* H, const double* const* dH, double* const* dP,
                           Index count) const {
  if (loops != nullptr) return loops->tangent(text(), H, dH, dP, count);
  std::visit(
      [&](const auto& held) {
        for (Index s = 0; s < count; ++s)
          write<D>(held.dpk1(tensor_of<D>(H, s), tensor_of<D>(dH, s)), dP, s);
      },
      law);
}

/// Without loops by Gershgorin's discs, as with them.
template <int D>
double RegionLaw<D>::stiffening(const double* const* H, const float* const* before, Index first,
                                Index count, const MemoryField& memory,
                                const MemoryField& memory_before) const {
  if (loops != nullptr) return loops->stiffening(text(), H, before, count);
  const auto tangent_at = [&](const Tensor<D>& strain, const MemoryField& own, Index s) {
    return tlsph::tangent<D>(law, strain, {own.data() + (first + s) * own.cols(), 0.0});
  };
  double end = 0.0;
  for (Index s = 0; s < count; ++s) {
    const Tangent<D> A = tangent_at(tensor_of<D>(H, s), memory, s) -
                         tangent_at(tensor_of<D>(before, s), memory_before, s);
    for (int i = 0; i < D * D; ++i)
      end = std::max(end, A(i, i) + A.row(i).cwiseAbs().sum() - std::abs(A(i, i)));
  }
  return end;
}

template <int D>
std::vector<RegionLaw<D>> region_laws(const Discretisation<D>& body, const Loops<D>& loops,
                                      bool linearised) {
  std::vector<RegionLaw<D>> result;
  for (const Region<D>& region : body.regions) {
    const std::optional<AnyLaw<D>> linear = linearised ? at_rest<D>(region.law) : std::nullopt;
    RegionLaw<D> law{linear.value_or(region.law), nullptr, linearised && !linear};
    const std::size_t index = law.law.index();
    if (index < std::size(loops.laws) && !law.linearised && tlsph::memory<D>(law.law) == 0)
      law.loops = &loops.laws[index];
    result.push_back(std::move(law));
  }
  return result;
}

template <int D>
std::vector<int> regions_of_points(const Discretisation<D>& body) {
  if (body.regions.size() < 2) return {};
  std::vector<int> regions(static_cast<std::size_t>(body.points.size()), 0);
  for (std::size_t r = 0; r < body.regions.size(); ++r)
    for (const int s : body.regions[r].points)
      regions[static_cast<std::size_t>(s)] = static_cast<int>(r);
  return regions;
}

#define TLSPH_INSTANTIATE(D)                                                                       \
  template struct RegionLaw<D>;                                                                    \
  template std::vector<RegionLaw<D>> region_laws(const Discretisation<D>&, const Loops<D>&, bool); \
  template std::vector<int> regions_of_points(const Discretisation<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph::sweep
