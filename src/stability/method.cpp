#include "method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

using Cover = Method::Cover;

constexpr std::array other_kernels = {"cubic-spline", "quadratic", "gaussian",
                                      "lucy",         "mollifier", "modified-mollifier"};

Method method(std::string name, Formulation formulation, std::optional<double> support,
              StabiliserKind stabiliser, Cover cover) {
  Method result;
  result.name = std::move(name);
  result.formulation = formulation;
  if (support) result.kernel.support = support;
  result.stabiliser.kind = stabiliser;
  result.cover = cover;
  return result;
}

Method stress_point(std::string name, StabiliserKind stabiliser) {
  return method(std::move(name), Formulation::stress_point, std::nullopt, stabiliser, Cover::all);
}

Method thesis(GhostClosure closure, double support, Cover cover) {
  Method result = method(fmt::format("thesis {} {}", name_of(closure), support),
                         Formulation::thesis, support, StabiliserKind::none, cover);
  result.ghosts = closure;
  result.lattice = true;
  return result;
}

Method mirror(double support, Cover cover) {
  Method result = method(fmt::format("mirror {}", support), Formulation::mirror, support,
                         StabiliserKind::none, cover);
  result.lattice = true;
  return result;
}

Method variational(double support, bool stabilised, Cover cover) {
  Method result = method(fmt::format("variational {}{}", support, stabilised ? " + S" : ""),
                         Formulation::variational, support,
                         stabilised ? StabiliserKind::pair : StabiliserKind::none, cover);
  result.cell_centred = true;
  return result;
}

Method corrected(Correction correction) {
  Method result = method(fmt::format("variational 2.5 {} + S", name_of(correction)),
                         Formulation::variational, 2.5, StabiliserKind::pair, Cover::few);
  result.kernel.correction = correction;
  return result;
}

Method consistent(int rows, int columns, Cover cover) {
  Method result = method(fmt::format("consistent [{}, {}]", rows, columns), Formulation::consistent,
                         std::nullopt, StabiliserKind::pair, cover);
  result.consistency = ConsistencyScene{rows, columns, false, {}};
  result.stabiliser.action = StabiliserAction::viscosity;
  return result;
}

/// With another kernel, at few states.
Method with_kernel(Method result, const std::string& family) {
  const auto place = result.name.ends_with(" + S") ? result.name.size() - 4 : result.name.size();
  result.name.insert(place, " " + family);
  result.kernel.family = family;
  result.cover = Cover::few;
  result.cell_centred = false;
  return result;
}

constexpr std::array corrections = {Correction::none, Correction::gradient, Correction::mixed};

std::vector<Method> bar_methods() {
  std::vector<Method> list = {stress_point("stress-point", StabiliserKind::none)};
  for (const double support : {1.01, 1.5, 2.5, 3.5, 5.5})
    list.push_back(variational(support, false, Cover::all));
  for (const double support : {1.5, 2.5, 5.5})
    list.push_back(variational(support, true, Cover::all));
  list.push_back(consistent(1, 1, Cover::all));
  for (const double support : {1.01, 1.5, 2.5, 3.5, 5.5})
    list.push_back(mirror(support, Cover::all));
  for (const double support : {1.5, 2.5, 3.5, 5.5})
    list.push_back(thesis(GhostClosure::consistent, support, Cover::all));
  for (const double support : {2.5, 5.5}) {
    list.push_back(thesis(GhostClosure::as_printed, support, Cover::few));
    list.push_back(thesis(GhostClosure::eta, support, Cover::few));
  }
  for (const Correction correction : corrections) list.push_back(corrected(correction));
  for (const char* name : other_kernels) list.push_back(with_kernel(mirror(2.5, Cover::few), name));
  return list;
}

std::vector<Method> sheet_methods() {
  Method fit = stress_point("stress-point fit 1.8", StabiliserKind::none);
  fit.kernel.support = 1.8;
  fit.consistency = ConsistencyScene{1, 0, true, {}};
  std::vector<Method> list = {stress_point("stress-point cells + S", StabiliserKind::cell),
                              stress_point("stress-point cells", StabiliserKind::none), fit};
  list.push_back(variational(1.01, true, Cover::few));
  list.push_back(variational(1.5, true, Cover::all));
  list.push_back(variational(2.5, false, Cover::all));
  list.push_back(variational(2.5, true, Cover::all));
  list.push_back(variational(3.5, true, Cover::few));
  list.push_back(variational(5.5, true, Cover::few));
  list.push_back(consistent(1, 1, Cover::all));
  list.push_back(consistent(2, 1, Cover::few));
  for (const Correction correction : corrections) list.push_back(corrected(correction));
  for (const char* name : other_kernels)
    list.push_back(with_kernel(variational(2.5, true, Cover::few), name));
  for (const double support : {2.5, 5.5}) list.push_back(mirror(support, Cover::few));
  for (const double support : {2.5, 5.5})
    list.push_back(thesis(GhostClosure::consistent, support, Cover::reference));
  return list;
}

}  // namespace

void Method::apply_to(Scene& scene) const {
  scene.formulation = formulation;
  scene.formulation_place = {};
  scene.kernel = kernel;
  scene.stabiliser = stabiliser;
  if (ghosts.given()) scene.ghosts = ghosts;
  if (consistency.given()) scene.consistency = consistency;
}

std::vector<Method> atlas_methods(int dimension) {
  return dimension == 1 ? bar_methods() : sheet_methods();
}

std::string StateKey::name() const {
  return fmt::format("{}, {}{}, nu {}, stretch {}", method.name,
                     strip > 0 ? fmt::format("strip of {}, ", strip) : "",
                     jitter == 0.0 ? "lattice" : fmt::format("jitter {}", jitter), poisson,
                     stretch);
}

std::vector<StateKey> atlas_states(int dimension, double poisson) {
  using List = std::vector<double>;
  const bool bar = dimension == 1;
  const List stretches =
      bar ? List{0.2, 0.5, 0.8, 1.0, 1.5, 2.0, 4.0, 6.0} : List{0.2, 0.5, 1.0, 1.5, 4.0};
  const List few_stretches = bar ? List{0.5, 1.0, 4.0} : List{0.5, 1.0, 1.5};
  List ratios = {poisson};
  for (const double ratio : bar ? List{0.48, 0.49, 0.4999} : List{0.49, 0.4999})
    if (ratio != poisson) ratios.push_back(ratio);
  std::vector<StateKey> states;
  for (const Method& method : atlas_methods(dimension)) {
    const bool all = method.cover == Cover::all;
    const List nu = all ? ratios : List{poisson};
    const List lambda = all                                ? stretches
                        : method.cover == Cover::reference ? List{1.0}
                                                           : few_stretches;
    List jitters = {0.0};
    if (!method.lattice) jitters = all ? List{0.0, 0.2, 0.4} : List{0.0, 0.2};
    for (const double jitter : jitters)
      for (const double ratio : nu)
        for (const double stretch : lambda) states.push_back({method, 0, jitter, ratio, stretch});
  }
  if (dimension == 2)
    for (const Method& method : atlas_methods(dimension)) {
      const bool cells = method.name.starts_with("stress-point cells");
      const bool chosen = cells || method.name == "variational 2.5" ||
                          method.name == "variational 2.5 + S" ||
                          method.name == "variational 1.5 + S";
      if (!chosen) continue;
      // A stress point needs a cell: two particles are the thinnest it can be.
      for (const int strip : {1, 2, 3})
        if (!cells || strip > 1) states.push_back({method, strip, 0.0, poisson, 1.0});
    }
  return states;
}

}  // namespace tlsph
