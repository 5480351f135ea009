#include "chart_families.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "tlsph/kernels/families.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/linear_law.hpp"

namespace tlsph {
namespace {

struct Stabiliser {
  const char* label;
  std::vector<std::string> overrides;
};
const Stabiliser no_stabiliser{"", {"stabiliser.kind=none"}};
const Stabiliser cell{"cell", {"stabiliser.kind=cell", "stabiliser.as=stiffness"}};
const Stabiliser pair{"pair", {"stabiliser.kind=pair", "stabiliser.as=stiffness"}};
const Stabiliser viscous{"pair viscosity", {"stabiliser.kind=pair", "stabiliser.as=viscosity"}};

/// What a formulation can be given, its default first.
struct Choices {
  Formulation formulation;
  std::vector<std::string> kernels;
  std::vector<std::optional<double>> supports;
  std::vector<int> orders;
  std::vector<Stabiliser> stabilisers;
};

std::vector<std::string> kernels_from(std::string_view first) {
  std::vector<std::string> names = {std::string(first)};
  for (const std::string_view name : kernel_names())
    if (name != first) names.emplace_back(name);
  return names;
}

std::vector<Choices> choices_in(int dimension) {
  using Supports = std::vector<std::optional<double>>;
  const bool plane = dimension == 2;
  const auto adjoint = kernels_from("wendland-c2");
  const auto ghosted = kernels_from("modified-mollifier");
  const std::vector<Stabiliser> none = {no_stabiliser}, held = {pair, viscous, no_stabiliser},
                                free = {no_stabiliser, pair, viscous},
                                cells = {cell, no_stabiliser, pair};
  // Corrected to degree 1 where degree 2 is the default.
  const Supports linear = plane ? Supports{2.6, 2.1} : Supports{};
  const Supports corrected = plane ? Supports{3.6, 3.1, 2.6} : Supports{3.1, 2.6, 2.1};
  return {
      // The nodes of a cell know no kernel, but a choice of stabilisers that supports do not have.
      {Formulation::stress_point, {"wendland-c2"}, {std::nullopt}, {1}, plane ? cells : none},
      {Formulation::consistent, adjoint, corrected, {plane ? 2 : 1}, held},
      {Formulation::variational, adjoint, {2.5, 1.6, 2.1, 3.1, 3.6}, {1, 2}, plane ? held : free},
      {Formulation::consistent, adjoint, linear, {1}, {pair, viscous}},
      {Formulation::mirror, ghosted, {2.5, 1.5, 3.5}, {1}, none},
      {Formulation::thesis, ghosted, {2.5, 1.5, 3.5}, {1}, none},
      {Formulation::stress_point, adjoint, {1.8, 2.5}, {1, 2}, {no_stabiliser, pair}}};
}

ChartFamily family_of(const Choices& choices, std::size_t kernel, std::size_t support,
                      std::size_t order, std::size_t stabiliser) {
  ChartFamily family;
  family.formulation = name_of(choices.formulation);
  family.support = choices.supports[support];
  family.order = choices.orders[order];
  family.stabiliser = choices.stabilisers[stabiliser].label;
  for (const std::size_t choice : {kernel, support, order, stabiliser})
    family.distance += choice > 0 ? 1 : 0;
  family.family = family.formulation;
  family.overrides = {"formulation=" + family.formulation};
  const auto set = [&](const std::string& text) { family.overrides.push_back(text); };
  if (family.support) {
    family.kernel = choices.kernels[kernel];
    set("kernel.family=" + family.kernel);
    set(fmt::format("kernel.support={}", *family.support));
    family.family += fmt::format(" {}", *family.support);
  }
  if (family.order > 1 || choices.orders.size() > 1)
    set(fmt::format("kernel.order={}", family.order));
  if (choices.formulation == Formulation::consistent) {
    set(fmt::format("consistency=[{},1]", family.order));
    set(fmt::format("kernel.order={}", family.order));
  }
  if (family.order > 1) family.family += " order 2";
  if (kernel > 0) family.family += " " + family.kernel;
  if (!family.stabiliser.empty()) family.family += " " + family.stabiliser;
  std::ranges::for_each(choices.stabilisers[stabiliser].overrides, set);
  return family;
}

/// The share of most runs, on the way from a small one to the largest.
constexpr double usual_share = 0.9;

ChartFamily varied(const ChartFamily& family, bool linear, std::optional<double> share,
                   double own_share) {
  ChartFamily other = family;
  const std::string now = variant_label(family.linear, family.step_share, own_share);
  other.family.resize(other.family.size() - now.size());
  other.family += variant_label(linear, share, own_share);
  other.linear = linear;
  other.step_share = share;
  return other;
}

}  // namespace

std::vector<ChartFamily> chart_families(int dimension, const std::vector<std::string>& wanted) {
  std::vector<ChartFamily> families;
  for (const Choices& choices : choices_in(dimension)) {
    if (!wanted.empty() && std::ranges::find(wanted, name_of(choices.formulation)) == wanted.end())
      continue;
    for (std::size_t kernel = 0; kernel < choices.kernels.size(); ++kernel)
      for (std::size_t support = 0; support < choices.supports.size(); ++support)
        for (std::size_t order = 0; order < choices.orders.size(); ++order)
          for (std::size_t held = 0; held < choices.stabilisers.size(); ++held)
            families.push_back(family_of(choices, kernel, support, order, held));
  }
  std::ranges::stable_sort(families, {}, &ChartFamily::distance);
  return families;
}

std::vector<std::string> ChartVariation::overrides(const ChartFamily& family) const {
  std::vector<std::string> texts;
  if (family.linear) texts = linear;
  if (family.step_share && *family.step_share != own_share)
    texts.push_back(fmt::format("time.safety={}", *family.step_share));
  return texts;
}

std::string ChartVariation::law_of(const ChartFamily& family) const {
  return family.linear ? std::string(name_of(LawName::linear_elastic)) : law;
}

ChartVariation chart_variation(const Scene& scene) {
  ChartVariation variation;
  variation.own_share = scene.time.safety;
  if (!scene.time.step) {
    const double own = scene.time.safety;
    variation.shares = {own, 0.5 * own, 0.25 * own};
    for (const double share : {usual_share, largest_share})
      if (share > own) variation.shares.push_back(share);
    std::ranges::sort(variation.shares, std::greater());
  }
  variation.linear = linear_law(scene);
  std::vector<std::string_view> laws;
  for (const MaterialScene& material : scene.materials)
    if (const auto name = name_of(material.law); std::ranges::find(laws, name) == laws.end())
      laws.push_back(name);
  variation.law = fmt::format("{}", fmt::join(laws, "+"));
  return variation;
}

std::string variant_label(bool linear, std::optional<double> share, double own_share) {
  std::string label = linear ? " linear" : "";
  if (share && *share != own_share) label += fmt::format(" step {:.3g}", *share);
  return label;
}

std::vector<ChartFamily> neighbours(const ChartFamily& family, const ChartVariation& variation) {
  std::vector<ChartFamily> others;
  const double own = variation.own_share;
  const bool adjoint = is_adjoint(*from_name<Formulation>(family.formulation));
  const auto add = [&](bool linear, std::optional<double> share) {
    others.push_back(varied(family, linear, share, own));
  };
  if (!variation.linear.empty()) add(!family.linear, family.step_share);
  if (!family.step_share) return others;
  const auto& shares = variation.shares;
  const auto here = std::ranges::find(shares, *family.step_share);
  if (here == shares.end()) return others;
  if (here != shares.begin() && (adjoint || *std::prev(here) <= own))
    add(family.linear, *std::prev(here));
  if (std::next(here) != shares.end()) add(family.linear, *std::next(here));
  return others;
}

}  // namespace tlsph
