#pragma once
/// \file
/// How a scene spells its choices: one list per enumeration, read by the scene reader, printed by
/// `scene-reference`, used again wherever a result names what was run.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tlsph/scene/scene.hpp"

namespace tlsph {

template <class E, std::size_t N>
using NameList = std::array<std::pair<std::string_view, E>, N>;

template <class E>
struct Names;

template <>
struct Names<Formulation> {
  static constexpr auto list = [] {
    NameList<Formulation, formulation_table.size()> result;
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] = {formulation_table[k].name, formulation_table[k].formulation};
    return result;
  }();
};
template <>
struct Names<GhostClosure> {
  static constexpr NameList<GhostClosure, 3> list = {{{"consistent", GhostClosure::consistent},
                                                      {"as-printed", GhostClosure::as_printed},
                                                      {"eta", GhostClosure::eta}}};
};
template <>
struct Names<SolverChoice> {
  static constexpr NameList<SolverChoice, 3> list = {{{"auto", SolverChoice::automatic},
                                                      {"cholmod", SolverChoice::cholmod},
                                                      {"umfpack", SolverChoice::umfpack}}};
};
template <>
struct Names<Precision> {
  static constexpr NameList<Precision, 2> list = {
      {{"double", Precision::full}, {"mixed", Precision::mixed}}};
};
template <>
struct Names<NodePlacement> {
  static constexpr NameList<NodePlacement, 2> list = {
      {{"on-boundary", NodePlacement::on_boundary}, {"cell-centred", NodePlacement::cell_centred}}};
};
template <>
struct Names<Layout> {
  static constexpr NameList<Layout, 2> list = {
      {{"square", Layout::square}, {"hexagonal", Layout::hexagonal}}};
};
template <>
struct Names<Correction> {
  static constexpr NameList<Correction, 4> list = {{{"none", Correction::none},
                                                    {"gradient", Correction::gradient},
                                                    {"mixed", Correction::mixed},
                                                    {"least-squares", Correction::least_squares}}};
};
template <>
struct Names<StabiliserKind> {
  static constexpr NameList<StabiliserKind, 3> list = {{{"none", StabiliserKind::none},
                                                        {"pair", StabiliserKind::pair},
                                                        {"cell", StabiliserKind::cell}}};
};
template <>
struct Names<StabiliserAction> {
  static constexpr NameList<StabiliserAction, 2> list = {
      {{"stiffness", StabiliserAction::stiffness}, {"viscosity", StabiliserAction::viscosity}}};
};
template <>
struct Names<LawName> {
  static constexpr auto list = [] {
    NameList<LawName, law_names.size()> result;
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] = {law_names[k], static_cast<LawName>(k)};
    return result;
  }();
};
template <>
struct Names<Assumption> {
  static constexpr NameList<Assumption, 2> list = {
      {{"strain", Assumption::strain}, {"stress", Assumption::stress}}};
};
template <>
struct Names<ExactKind> {
  static constexpr NameList<ExactKind, 4> list = {
      {{"none", ExactKind::none},
       {"bar-wave", ExactKind::bar_wave},
       {"swinging-plate", ExactKind::swinging_plate},
       {"uniform-stretch", ExactKind::uniform_stretch}}};
};
/// The fields an initial state can name beside `zero` and a linear map.
template <>
struct Names<InitialField::Kind> {
  static constexpr NameList<InitialField::Kind, 2> list = {
      {{"swinging-plate", InitialField::Kind::swinging_plate},
       {"cantilever-mode", InitialField::Kind::cantilever_mode}}};
};

/// The scene's word for a value.
template <class E>
[[nodiscard]] constexpr std::string_view name_of(E value) {
  for (const auto& [name, entry] : Names<E>::list)
    if (entry == value) return name;
  return "";
}

template <class E>
[[nodiscard]] constexpr std::string_view name_of(const Defaulted<E>& value) {
  return name_of(value.get());
}

/// The value a word stands for; empty if it is none of them.
template <class E>
[[nodiscard]] constexpr std::optional<E> from_name(std::string_view word) {
  for (const auto& [name, entry] : Names<E>::list)
    if (name == word) return entry;
  return std::nullopt;
}

/// `a | b | c`.
template <class E>
[[nodiscard]] std::string choices() {
  std::string text;
  for (const auto& [name, entry] : Names<E>::list)
    text.append(text.empty() ? "" : " | ").append(name);
  return text;
}

}  // namespace tlsph
