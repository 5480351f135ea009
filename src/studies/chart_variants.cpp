#include "chart_variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/linear_law.hpp"

namespace tlsph {
namespace {

/// The share of most runs, on the way from a small one to the largest.
constexpr double usual_share = 0.9;

bool is_adjoint(const ChartFamily& family) {
  return tlsph::is_adjoint(*from_name<Formulation>(family.formulation));
}

ChartFamily varied(const ChartFamily& family, bool linear, std::optional<double> share,
                   double own_share) {
  ChartFamily other = family;
  const std::string now = variant_label(family.linear, family.step_share, own_share);
  other.label.resize(other.label.size() - now.size());
  other.label += variant_label(linear, share, own_share);
  other.linear = linear;
  other.step_share = share;
  return other;
}

}  // namespace

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
  std::vector<std::string> laws;
  for (const MaterialScene& material : scene.materials) {
    const std::string name(name_of(material.law));
    if (std::ranges::find(laws, name) != laws.end()) continue;
    laws.push_back(name);
    variation.law += (variation.law.empty() ? "" : "+") + name;
  }
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
  if (!variation.linear.empty())
    others.push_back(varied(family, !family.linear, family.step_share, own));
  if (!family.step_share) return others;
  const auto& shares = variation.shares;
  const auto here = std::ranges::find(shares, *family.step_share);
  if (here == shares.end()) return others;
  if (here != shares.begin() && (is_adjoint(family) || *std::prev(here) <= own))
    others.push_back(varied(family, family.linear, *std::prev(here), own));
  if (std::next(here) != shares.end())
    others.push_back(varied(family, family.linear, *std::next(here), own));
  return others;
}

}  // namespace tlsph
