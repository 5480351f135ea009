#include "method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tlsph {
namespace {

using Cover = Method::Cover;

std::string kernel(double support, const std::string& rest = "") {
  return fmt::format("kernel={{support={}{}}}", support, rest);
}

std::string family(const char* name, double support) {
  return fmt::format(R"(kernel={{family="{}", support={}}})", name, support);
}

constexpr const char* bare = R"(stabiliser={kind="none"})";
constexpr const char* pair = R"(stabiliser={kind="pair"})";
constexpr const char* viscous = R"(stabiliser={kind="pair", as="viscosity"})";
constexpr const char* cell = R"(stabiliser={kind="cell"})";

constexpr std::array other_kernels = {"cubic-spline", "quadratic", "gaussian",
                                      "lucy",         "mollifier", "modified-mollifier"};

Method thesis(const std::string& closure, double support, Cover cover) {
  return {fmt::format("thesis {} {}", closure, support),
          {"formulation=thesis", "boundary_treatment=" + closure, kernel(support), bare},
          cover,
          true};
}

Method mirror(double support, Cover cover) {
  return {fmt::format("mirror {}", support),
          {"formulation=mirror", kernel(support), bare},
          cover,
          true};
}

Method variational(double support, bool stabilised, Cover cover) {
  return {fmt::format("variational {}{}", support, stabilised ? " + S" : ""),
          {"formulation=variational", kernel(support), stabilised ? pair : bare},
          cover,
          false,
          true};
}

Method corrected(const char* correction, Cover cover) {
  return {fmt::format("variational 2.5 {} + S", correction),
          {"formulation=variational", kernel(2.5, fmt::format(R"(, correction="{}")", correction)),
           pair},
          cover};
}

Method consistent(int rows, int columns, Cover cover) {
  return {fmt::format("consistent [{}, {}]", rows, columns),
          {"formulation=consistent", fmt::format("consistency=[{}, {}]", rows, columns), viscous},
          cover};
}

std::vector<Method> bar_methods() {
  std::vector<Method> list = {{"stress-point", {"formulation=stress-point", bare}, Cover::all}};
  for (const double support : {1.01, 1.5, 2.5, 3.5, 5.5})
    list.push_back(variational(support, false, Cover::all));
  for (const double support : {1.5, 2.5, 5.5})
    list.push_back(variational(support, true, Cover::all));
  list.push_back(consistent(1, 1, Cover::all));
  for (const double support : {1.01, 1.5, 2.5, 3.5, 5.5})
    list.push_back(mirror(support, Cover::all));
  for (const double support : {1.5, 2.5, 3.5, 5.5})
    list.push_back(thesis("consistent", support, Cover::all));
  for (const double support : {2.5, 5.5}) {
    list.push_back(thesis("as-printed", support, Cover::few));
    list.push_back(thesis("eta", support, Cover::few));
  }
  for (const char* name : {"none", "gradient", "mixed"})
    list.push_back(corrected(name, Cover::few));
  for (const char* name : other_kernels)
    list.push_back({fmt::format("mirror 2.5 {}", name),
                    {"formulation=mirror", family(name, 2.5), bare},
                    Cover::few,
                    true});
  return list;
}

std::vector<Method> sheet_methods() {
  std::vector<Method> list = {
      {"stress-point cells + S", {"formulation=stress-point", cell}, Cover::all},
      {"stress-point cells", {"formulation=stress-point", bare}, Cover::all},
      {"stress-point fit 1.8",
       {"formulation=stress-point", kernel(1.8), "consistency=true", bare},
       Cover::all},
  };
  list.push_back(variational(1.01, true, Cover::few));
  list.push_back(variational(1.5, true, Cover::all));
  list.push_back(variational(2.5, false, Cover::all));
  list.push_back(variational(2.5, true, Cover::all));
  list.push_back(variational(3.5, true, Cover::few));
  list.push_back(variational(5.5, true, Cover::few));
  list.push_back(consistent(1, 1, Cover::all));
  list.push_back(consistent(2, 1, Cover::few));
  for (const char* name : {"none", "gradient", "mixed"})
    list.push_back(corrected(name, Cover::few));
  for (const char* name : other_kernels)
    list.push_back({fmt::format("variational 2.5 {} + S", name),
                    {"formulation=variational", family(name, 2.5), pair},
                    Cover::few});
  for (const double support : {2.5, 5.5}) list.push_back(mirror(support, Cover::few));
  for (const double support : {2.5, 5.5})
    list.push_back(thesis("consistent", support, Cover::reference));
  return list;
}

}  // namespace

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
