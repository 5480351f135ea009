#include "chart_families.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tlsph/kernels/families.hpp"
#include "tlsph/scene/names.hpp"

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
  const bool plane = dimension == 2;
  const auto adjoint = kernels_from("wendland-c2");
  const auto ghosted = kernels_from("modified-mollifier");
  const std::vector<Stabiliser> held = {pair, viscous, no_stabiliser};
  std::vector<Choices> all;
  // The nodes of a cell know no kernel, but a choice of stabilisers that supports do not have.
  all.push_back({Formulation::stress_point,
                 {"wendland-c2"},
                 {std::nullopt},
                 {1},
                 plane ? std::vector{cell, no_stabiliser, pair} : std::vector{no_stabiliser}});
  all.push_back({Formulation::consistent,
                 adjoint,
                 plane ? std::vector<std::optional<double>>{3.6, 3.1, 2.6}
                       : std::vector<std::optional<double>>{3.1, 2.6, 2.1},
                 {plane ? 2 : 1},
                 {pair, viscous, no_stabiliser}});
  all.push_back({Formulation::variational,
                 adjoint,
                 {2.5, 1.6, 2.1, 3.1, 3.6},
                 {1, 2},
                 plane ? held : std::vector{no_stabiliser, pair, viscous}});
  if (plane) all.push_back({Formulation::consistent, adjoint, {2.6, 2.1}, {1}, {pair, viscous}});
  all.push_back({Formulation::mirror, ghosted, {2.5, 1.5, 3.5}, {1}, {no_stabiliser}});
  all.push_back({Formulation::thesis, ghosted, {2.5, 1.5, 3.5}, {1}, {no_stabiliser}});
  all.push_back({Formulation::stress_point, adjoint, {1.8, 2.5}, {1, 2}, {no_stabiliser, pair}});
  return all;
}

ChartFamily family_of(const Choices& choices, std::size_t kernel, std::size_t support,
                      std::size_t order, std::size_t stabiliser) {
  ChartFamily family;
  family.formulation = name_of(choices.formulation);
  family.kernel = choices.kernels[kernel];
  family.support = choices.supports[support];
  family.order = choices.orders[order];
  family.stabiliser = choices.stabilisers[stabiliser].label;
  for (const std::size_t choice : {kernel, support, order, stabiliser})
    family.distance += choice > 0 ? 1 : 0;
  family.overrides = {"formulation=" + family.formulation};
  family.label = family.formulation;
  if (family.support) {
    family.overrides.push_back("kernel.family=" + family.kernel);
    family.overrides.push_back(fmt::format("kernel.support={}", *family.support));
    family.label += fmt::format(" {}", *family.support);
  } else {
    family.kernel = "";
  }
  if (family.order > 1 || choices.orders.size() > 1)
    family.overrides.push_back(fmt::format("kernel.order={}", family.order));
  if (choices.formulation == Formulation::consistent) {
    family.overrides.push_back(fmt::format("consistency=[{},1]", family.order));
    family.overrides.push_back(fmt::format("kernel.order={}", family.order));
  }
  if (family.order > 1) family.label += " order 2";
  if (kernel > 0) family.label += " " + family.kernel;
  if (!family.stabiliser.empty()) family.label += " " + family.stabiliser;
  for (const std::string& override_text : choices.stabilisers[stabiliser].overrides)
    family.overrides.push_back(override_text);
  return family;
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

}  // namespace tlsph
