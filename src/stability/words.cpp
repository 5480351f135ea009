#include "words.hpp"

#include <array>

namespace tlsph {
namespace {

struct Entry {
  std::string_view group;
  std::string_view what, why, cure;
};

// In the order of the story: what the material does, what operators do, what cannot be built.
constexpr std::array entries = {
    Entry{
        "1 material", "every method grows, at any step and any spacing",
        "the law has lost hyperbolicity: its acoustic tensor is not positive, so a homogeneous "
        "state "
        "cannot exist",
        "none in the method: a smaller Poisson ratio or a stretch nearer to 1, or a law that stays "
        "hyperbolic"},
    Entry{
        "2 compression", "ω² < 0 though the material carries waves, growth at any step",
        "under pressure the tangent weighs Σ V (∂₁u₁ ∂₂u₂ − ∂₂u₁ ∂₁u₂), which is zero for every "
        "motion "
        "that vanishes at the boundary, with μ − λ ln J; gradients of collocated operators do not "
        "keep it zero beside boundaries and on irregular particles",
        "stress points in cells, whose mean gradients keep that sum exactly; a stabiliser shifts "
        "the "
        "onset"},
    Entry{"3 tension", "ω² < 0 in tension of nearly incompressible material",
          "the same sum, weighed with −λ ln J", "stress points in cells"},
    Entry{"4 growing", "oscillations that grow at any step",
          "D is not the adjoint of G: the forces come from no energy, ω² is complex",
          "an adjoint pair, or mirrored ghosts; narrow supports only slow it down"},
    Entry{"5 soft", "modes without energy, to be excited by anything",
          "G u vanishes for fields that change sign from particle to particle",
          "the stabiliser S, or a viscosity; stress points between the particles"},
    Entry{"6 weak",
          "modes with less than half the energy of the first true vibration, in spite of S",
          "the stabiliser's 0.1 μ is little beside λ + 2μ, and jittered kernels weigh it down",
          "stress points in cells, whose hourglass stiffness has the right size"},
    Entry{"7 no gradient", "no operators: too few neighbours",
          "a plane cannot be fitted through them",
          "a support of 1.5 or more, or the nodes of a cell"},
    Entry{"7 thin body", "no operators: a body one particle thick has no gradient across",
          "particles in a row span a line",
          "two layers of particles: stress points in one layer of cells bend as they should"},
    Entry{"8 ghosts", "the uniform state cannot be set up: det F <= 0 in it",
          "ghosts are solved for, and the solution oscillates beside the boundary",
          "mirrored ghosts, or no ghosts at all"},
    Entry{"9 not for it", "no operators: the method is not made for this body",
          "what it asks of the body is said below", "a method of the others"},
};

}  // namespace

std::string group_of(const AtlasRow& row) {
  switch (row.verdict) {
    case Verdict::material:
      return "1 material";
    case Verdict::negative:
      return row.stretch < 1.0 ? "2 compression" : "3 tension";
    case Verdict::growing:
      return "4 growing";
    case Verdict::soft:
      return row.method.ends_with("+ S") ? "6 weak" : "5 soft";
    case Verdict::refused:
      if (row.refusal.find("det F") != std::string::npos) return "8 ghosts";
      if (row.refusal.find("do not determine") == std::string::npos) return "9 not for it";
      return row.body == "scene" ? "7 no gradient" : "7 thin body";
    case Verdict::stable:
      break;
  }
  return "";
}

Words words_of(std::string_view group) {
  for (const Entry& entry : entries)
    if (entry.group == group)
      return {std::string(entry.what), std::string(entry.why), std::string(entry.cure)};
  return {};
}

}  // namespace tlsph
