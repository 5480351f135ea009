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

/// Of an enumeration: its names and values.
template <class E>
constexpr NameList<E, 0> word_list = {};

template <>
inline constexpr auto word_list<Formulation> = [] {
  NameList<Formulation, formulation_table.size()> result;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = {formulation_table[k].name, formulation_table[k].formulation};
  return result;
}();
template <>
inline constexpr NameList<GhostClosure, 3> word_list<GhostClosure> = {
    {{"consistent", GhostClosure::consistent},
     {"as-printed", GhostClosure::as_printed},
     {"eta", GhostClosure::eta}}};
template <>
inline constexpr NameList<SolverChoice, 3> word_list<SolverChoice> = {
    {{"auto", SolverChoice::automatic},
     {"cholmod", SolverChoice::cholmod},
     {"umfpack", SolverChoice::umfpack}}};
template <>
inline constexpr NameList<Precision, 2> word_list<Precision> = {
    {{"double", Precision::full}, {"mixed", Precision::mixed}}};
template <>
inline constexpr NameList<NodePlacement, 2> word_list<NodePlacement> = {
    {{"on-boundary", NodePlacement::on_boundary}, {"cell-centred", NodePlacement::cell_centred}}};
template <>
inline constexpr NameList<Layout, 2> word_list<Layout> = {
    {{"square", Layout::square}, {"hexagonal", Layout::hexagonal}}};
template <>
inline constexpr NameList<Correction, 4> word_list<Correction> = {
    {{"none", Correction::none},
     {"gradient", Correction::gradient},
     {"mixed", Correction::mixed},
     {"least-squares", Correction::least_squares}}};
template <>
inline constexpr NameList<StabiliserKind, 3> word_list<StabiliserKind> = {
    {{"none", StabiliserKind::none},
     {"pair", StabiliserKind::pair},
     {"cell", StabiliserKind::cell}}};
template <>
inline constexpr NameList<StabiliserAction, 2> word_list<StabiliserAction> = {
    {{"stiffness", StabiliserAction::stiffness}, {"viscosity", StabiliserAction::viscosity}}};
template <>
inline constexpr auto word_list<LawName> = [] {
  NameList<LawName, law_names.size()> result;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = {law_names[k], static_cast<LawName>(k)};
  return result;
}();
template <>
inline constexpr NameList<Assumption, 2> word_list<Assumption> = {
    {{"strain", Assumption::strain}, {"stress", Assumption::stress}}};
template <>
inline constexpr NameList<ExactKind, 4> word_list<ExactKind> = {
    {{"none", ExactKind::none},
     {"bar-wave", ExactKind::bar_wave},
     {"swinging-plate", ExactKind::swinging_plate},
     {"uniform-stretch", ExactKind::uniform_stretch}}};
/// The fields an initial state can name beside `zero` and a linear map.
template <>
inline constexpr NameList<InitialField::Kind, 2> word_list<InitialField::Kind> = {
    {{"swinging-plate", InitialField::Kind::swinging_plate},
     {"cantilever-mode", InitialField::Kind::cantilever_mode}}};

/// The scene's word for a value.
template <class E>
[[nodiscard]] constexpr std::string_view name_of(E value) {
  for (const auto& [name, entry] : word_list<E>)
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
  for (const auto& [name, entry] : word_list<E>)
    if (name == word) return entry;
  return std::nullopt;
}

/// `a | b | c`.
template <class E>
[[nodiscard]] std::string choices() {
  std::string text;
  for (const auto& [name, entry] : word_list<E>)
    text.append(text.empty() ? "" : " | ").append(name);
  return text;
}

}  // namespace tlsph
