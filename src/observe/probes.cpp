#include "tlsph/observe/probes.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string_view>
#include <utility>

#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/measures.hpp"

namespace tlsph {
namespace {

constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};

/// The measures at H and P, which are interpolated between points: at the boundary extrapolated,
/// perhaps to a compression that the law is not made for. Those of the nearest point stand for it
/// then.
template <int D>
StressMeasures<D> measures_at(const Region<D>& region, const State<D>& state, const Tensor<D>& H,
                              const Tensor<D>& P, Index nearest) {
  if ((Tensor<D>::Identity() + H).determinant() > 0.0) {
    const StressMeasures<D> stress = stress_measures<D>(region, H, P);
    if (stress.cauchy.allFinite() && std::isfinite(stress.von_mises)) return stress;
  }
  return stress_measures<D>(region, tensor_at<D>(state.H, nearest), tensor_at<D>(state.P, nearest));
}

}  // namespace

template <int D>
std::vector<std::string> component_suffixes(std::string_view stem) {
  std::vector<std::string> suffixes;
  if (stem == "displacement" || stem == "velocity" || stem == "acceleration") {
    for (std::size_t i = 0; i < D; ++i) suffixes.push_back(fmt::format("_{}", axes[i]));
  } else if (stem == "deformation_gradient" || stem == "pk1" || stem == "cauchy") {
    const bool symmetric = stem == "cauchy";
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = symmetric ? i : 0; j < D; ++j)
        suffixes.push_back(fmt::format("_{}{}", axes[i], axes[j]));
  } else {
    suffixes.emplace_back("");
  }
  return suffixes;
}

template <int D>
Probes<D>::Probes(const Discretisation<D>& disc, const std::vector<ProbeRequest<D>>& requests) {
  static constexpr std::array<std::pair<std::string_view, Kind>, 8> names = {
      {{"displacement", Kind::displacement},
       {"velocity", Kind::velocity},
       {"acceleration", Kind::acceleration},
       {"deformation_gradient", Kind::deformation_gradient},
       {"pk1", Kind::pk1},
       {"cauchy", Kind::cauchy},
       {"pressure", Kind::pressure},
       {"von_mises", Kind::von_mises}}};
  for (const ProbeRequest<D>& request : requests) {
    Probe probe;
    try {
      probe.nodes = linear_interpolation<D>(disc.particles.X, request.at, disc.spacing);
      probe.points = linear_interpolation<D>(disc.points.X, request.at, disc.spacing);
    } catch (const InputError& error) {
      throw InputError(request.place, error.what());
    }
    const auto heaviest = std::max_element(probe.points.weight.begin(), probe.points.weight.end());
    probe.nearest =
        probe.points.node[static_cast<std::size_t>(heaviest - probe.points.weight.begin())];
    probe.region = region_of<D>(disc, probe.nearest);
    for (const std::string& stem : request.quantities) {
      const auto* entry = std::find_if(names.begin(), names.end(),
                                       [&](const auto& pair) { return pair.first == stem; });
      if (entry == names.end())
        throw InputError(fmt::format("probe \"{}\": no quantity {}", request.name, stem));
      probe.kinds.push_back(entry->second);
      for (const std::string& suffix : component_suffixes<D>(stem))
        columns_.push_back(fmt::format("{}.{}{}", request.name, stem, suffix));
    }
    probes_.push_back(std::move(probe));
  }
}

template <int D>
void Probes<D>::sample(const Discretisation<D>& disc, const State<D>& state, double dt,
                       std::span<double> row) const {
  std::size_t out = 0;
  for (const Probe& probe : probes_) {
    Vector<D> u = Vector<D>::Zero();
    Vector<D> v = Vector<D>::Zero();
    Vector<D> a = Vector<D>::Zero();
    for (std::size_t k = 0; k < probe.nodes.node.size(); ++k)
      for (int i = 0; i < D; ++i) {
        const Index dof = probe.nodes.node[k] * D + i;
        const NodalMotion motion = motion_of<D>(disc, state, dt, dof);
        u[i] += probe.nodes.weight[k] * state.u.data()[dof];
        v[i] += probe.nodes.weight[k] * motion.velocity;
        a[i] += probe.nodes.weight[k] * motion.acceleration;
      }
    Tensor<D> H = Tensor<D>::Zero();
    Tensor<D> P = Tensor<D>::Zero();
    for (std::size_t k = 0; k < probe.points.node.size(); ++k) {
      H += probe.points.weight[k] * tensor_at<D>(state.H, probe.points.node[k]);
      P += probe.points.weight[k] * tensor_at<D>(state.P, probe.points.node[k]);
    }
    const StressMeasures<D> stress =
        measures_at<D>(disc.regions[probe.region], state, H, P, probe.nearest);
    const auto put = [&](double number) { row[out++] = number; };
    const auto put_vector = [&](const Vector<D>& vector) {
      for (int i = 0; i < D; ++i) put(vector[i]);
    };
    const auto put_tensor = [&](const Tensor<D>& tensor) {
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) put(tensor(i, j));
    };
    for (const Kind kind : probe.kinds) {
      switch (kind) {
        case Kind::displacement:
          put_vector(u);
          break;
        case Kind::velocity:
          put_vector(v);
          break;
        case Kind::acceleration:
          put_vector(a);
          break;
        case Kind::deformation_gradient:
          put_tensor(Tensor<D>::Identity() + H);
          break;
        case Kind::pk1:
          put_tensor(P);
          break;
        case Kind::cauchy:
          for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j) put(stress.cauchy(i, j));
          break;
        case Kind::pressure:
          put(stress.pressure);
          break;
        case Kind::von_mises:
          put(stress.von_mises);
          break;
      }
    }
  }
  assert(out == row.size());
}

template <int D>
std::vector<Index> Probes<D>::nodes() const {
  std::vector<Index> all;
  for (const Probe& probe : probes_)
    all.insert(all.end(), probe.nodes.node.begin(), probe.nodes.node.end());
  return all;
}

template <int D>
std::vector<Index> Probes<D>::points() const {
  std::vector<Index> all;
  for (const Probe& probe : probes_)
    all.insert(all.end(), probe.points.node.begin(), probe.points.node.end());
  return all;
}

template std::vector<std::string> component_suffixes<1>(std::string_view);
template std::vector<std::string> component_suffixes<2>(std::string_view);
template class Probes<1>;
template class Probes<2>;

}  // namespace tlsph
