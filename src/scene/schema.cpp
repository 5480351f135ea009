#include "schema.hpp"

#include <string>
#include <utility>
#include <vector>

#include "curve_kinds.hpp"
#include "law_keys.hpp"
#include "tlsph/kernels/families.hpp"
#include "tlsph/observe/quantity.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

/// The words of an enumeration.
template <class E>
Allowed choices_of() {
  std::vector<std::string> all;
  for (const auto& [name, entry] : Names<E>::list) all.emplace_back(name);
  return Allowed(std::move(all));
}

Allowed kernel_choices() {
  const auto names = kernel_names();
  return Allowed({names.begin(), names.end()});
}

Allowed quantity_choices() {
  return Allowed({quantity_names.begin(), quantity_names.end()});
}

Allowed curve_choices() {
  std::vector<std::string> all;
  for (const auto& kind : curve_kinds()) all.emplace_back(kind.name);
  return Allowed(std::move(all));
}

std::vector<Key> all_keys() {
  const std::string optional = "(none)";
  const std::string required;
  const Allowed any;
  return {
      // group, name, forms, group below, unit, default, range, meaning
      {"", "title", text, "", "", "\"\"", any, "what the run is called in its results"},
      {"", "dimension", integer, "", "", "2", closed(1.0, 2.0),
       "1: a bar; 2: a sheet of unit thickness"},
      {"", "formulation", text, "", "", "\"stress-point\"", choices_of<Formulation>(),
       "which gradient and divergence matrices: thesis (SPH sums, ghosts, modified SPH matrix), "
       "mirror (SPH sums, ghosts folded into the matrices), variational (corrected gradient, "
       "adjoint divergence), consistent (the same, corrected so that its adjoint is exact too), "
       "stress-point (gradient at cell centres, adjoint divergence)"},
      {"", "boundary_treatment", text, "", "", "\"consistent\"", choices_of<GhostClosure>(),
       "thesis only: the modified SPH matrix with the coupling to the interior, as printed without "
       "it, or the eta corrections (1D)"},
      {"", "boundary_solver", text, "", "", "\"auto\"", choices_of<SolverChoice>(),
       "thesis only: factorisation of the modified SPH matrix; auto tries cholmod, then umfpack"},
      {"", "precision", text, "", "", "\"double\"", choices_of<Precision>(),
       "mixed: weights in single precision where particles are irregular, sums in double; faster "
       "there, momenta kept to 1e-7; lattices are not touched, nor thesis and mirror"},
      {"", "consistency", flag | numbers, "", "", "(consistent: [2, 1], in 1D [1, 1]; else false)",
       any,
       "degrees of the polynomials that the gradient and its adjoint are made exact for, [1, 0], "
       "[1, 1] or [2, 1]; true: the default "
       "for consistent, [1, 0] for stress-point"},
      {"", "gravity", numbers, "", "m/s^2", optional, any,
       "acceleration of the whole body, one number per dimension"},
      {"", "body", table, "body", "", required, any, "what is modelled"},
      {"", "kernel", table, "kernel", "", optional, any, "what weights the neighbours"},
      {"", "stabiliser", table, "stabiliser", "", optional, any, "what holds zero-energy modes"},
      {"", "material", table, "material", "", required, any, "what the body is made of"},
      {"", "boundary", tables, "boundary", "", optional, any,
       "one entry per condition; patches without one are free"},
      {"", "time", table, "time", "", required, any, "how long and in which steps"},
      {"", "probe", tables, "probe", "", optional, any, "points whose history goes to probes.csv"},
      {"", "reference", table, "reference", "", optional, any, "what the result is compared with"},
      {"", "initial", table, "initial", "", optional, any, "the state at t = 0"},
      {"", "output", table, "output", "", optional, any, "what is written, and how often"},

      {"body", "shape", table, "shape", "m", required, any,
       "an interval in 1D; a box, disc, polygon or difference of them in 2D"},
      {"body", "cloud", text, "", "", optional, any,
       "file of points instead of a lattice, path relative to the scene's folder: a header line "
       "x,y[,volume][,tag] (1D: x[,volume][,tag]), then a line per node. They fill the shape, its "
       "corners among them; those on its outline make the boundary. Without volumes each node has "
       "its Voronoi cell; a tag names nodes for [[boundary]] where, several separated by spaces. "
       "Nodes in an order that jumps about are put in strips; run.h5 says which line each is. "
       "For " +
           adjoint_formulations() +
           " (one point per edge of the triangles between "
           "them; locks as poisson nears 0.5). One kernel.support serves them all, so their "
           "distances "
           "should not differ by more than about half"},
      {"body", "spacing", number, "", "m", "(required; of a cloud: estimated)", above(0.0),
       "distance of neighbouring nodes, taken to the nearest division of the body; a change of "
       "more than 1 % is refused, but for fitted discs and polygons. Of a cloud: the unit of "
       "kernel.support"},
      {"body", "layout", text, "", "", "\"square\"", choices_of<Layout>(),
       "rows and columns, or rows shifted by half a spacing so that each node has six neighbours "
       "(2D, " +
           adjoint_formulations() + "; see cloud)"},
      {"body", "placement", text, "", "", "\"on-boundary\"", choices_of<NodePlacement>(),
       "nodes on the boundary (with half and quarter volumes), or at the centres of the cells"},
      {"body", "fit", flag, "", "", "(true for " + adjoint_formulations() + ", on-boundary, 2D)",
       any,
       "nodes follow curved and slanted edges instead of approaching them in stairs. Polygons with "
       "angles from 20 to 340 degrees, edges of two spacings and parts two spacings wide are "
       "always filled, by cells whose corners have a sine >= 0.1 and a Jacobian >= 0.1 spacing^2"},
      {"body", "jitter", number, "", "spacings", "0", closed(0.0, 0.4),
       "largest random shift of interior nodes"},
      {"body", "seed", integer, "", "", "1", at_least(0.0), "of the random shifts"},
      {"body", "tags", tables, "tag", "", optional, any,
       "names for parts of the body, beside those that boundary.where lists"},

      {"shape", "interval", numbers, "", "m", optional, any, "1D: [from, to]"},
      {"shape", "box", points, "", "m", optional, any,
       "[[x0, y0], [x1, y1]]: lower left, upper right"},
      {"shape", "disc", table, "disc", "m", optional, any, "a full circle"},
      {"shape", "polygon", points, "", "m", optional, any, "[[x, y], …]: corners in order"},
      {"shape", "difference", tables, "shape", "", optional, any,
       "[shape, hole, …]: the first without the others"},

      {"disc", "centre", numbers, "", "m", required, any, "[x, y]"},
      {"disc", "radius", number, "", "m", required, above(0.0), ""},

      {"tag", "name", text, "", "", required, any, "what [[boundary]] where calls this part"},
      {"tag", "box", points | numbers, "", "m", required, any,
       "[[x0, y0], [x1, y1]], in 1D [from, to]: fixed, held, symmetry and displacement act on the "
       "nodes in it, traction on all of the boundary in it, cut where it leaves the box (plan says "
       "how much of both). A box around one node loads the edges next to that node as far as the "
       "box "
       "reaches"},

      {"kernel", "family", text, "", "", "(wendland-c2; thesis and mirror: modified-mollifier)",
       kernel_choices(), "shape of the kernel"},
      {"kernel", "support", number, "", "spacings",
       "(2.5; consistent: 3.6, with linear gradients 2.6, in 1D 3.1; stress-point: the nodes of "
       "each cell)",
       at_least(1.0),
       "full radius of the kernel; the least-squares fit of a point whose nodes within it do not "
       "determine its polynomial takes a larger one, up to 2.5 times"},
      {"kernel", "order", integer, "", "", "(1; consistent: that of its rows)", closed(1.0, 2.0),
       "degree of the polynomials a least-squares gradient is exact for"},
      {"kernel", "correction", text, "", "", "(least-squares; thesis and mirror: none)",
       choices_of<Correction>(),
       "gradients of collocated nodes: a fitted plane, the gradient or mixed correction of Bonet "
       "and "
       "Lok, or plain differences"},

      {"stabiliser", "kind", text, "", "",
       "(consistent: pair; 2D: cell for stress-point on its cells, pair for variational; else "
       "none)",
       choices_of<StabiliserKind>(),
       "pair: error of linear extrapolation between neighbours; cell: hourglass mode of a cell"},
      {"stabiliser", "coefficient", number | text, "", "", "\"auto\"",
       Allowed({"auto"}, at_least(0.0)),
       "strength as a share of the shear modulus (cell: of E/(1 - nu^2)), as viscosity of density "
       "times "
       "speed of shear waves times spacing; auto: the value recommended for the kind"},
      {"stabiliser", "as", text, "", "", "\"stiffness\"", choices_of<StabiliserAction>(),
       "acts on displacements, which keeps energy and momenta, or on velocities: that dissipates, "
       "lets a body under load creep in modes that its gradients do not see, and keeps the angular "
       "momentum of small motions only"},

      {"material", "law", text, "", "", "\"neo-hookean\"", choices_of<LawName>(),
       "stress from strain"},
      {"material", "assumption", text, "", "", "\"strain\"", choices_of<Assumption>(),
       "of the dimensions left out: no strain (1D strain, plane strain) or no stress"},
      {"material", "density", number, "", "kg/m^3", required, above(0.0), "in the reference state"},
      {"material", "region", tables, "region", "", optional, any,
       "parts of another material, [[material.region]]; of overlapping ones the last counts"},

      {"region", "box", points | numbers, "", "m", required, any,
       "[[x0, y0], [x1, y1]], in 1D [from, to]: the part"},
      {"region", "law", text, "", "", "(of [material])", choices_of<LawName>(),
       "stress from strain"},
      {"region", "density", number, "", "kg/m^3", "(of [material])", above(0.0),
       "reference density"},

      {"boundary", "where", text, "", "", required, any,
       "a patch. left, right, bottom, top: the straight edges of the outer boundary that face "
       "that way, of several the outermost; edge1, edge2 …: one edge, from corner (more than 20°) "
       "to "
       "corner, in the order of the shape (a box: bottom, right, top, left; a polygon: from its "
       "first "
       "corner on; a difference: edges of its first shape, then of the others); hole1, hole2 …: "
       "all "
       "that the first, second … shape taken away leaves; hole: all that such shapes leave, "
       "without "
       "left, right, bottom and top; outer: the rest; boundary: all; or the name of a tag. In 1D "
       "left, "
       "right, outer, boundary and tags. A wrong name is answered by the list, with places"},
      {"boundary", "fixed", flag | text | texts, "", "", optional, Allowed({"x", "y"}),
       "held at zero displacement: true, or the components held"},
      {"boundary", "held", flag | text | texts, "", "", optional, Allowed({"x", "y"}),
       "kept at the displacement of t = 0, for a body that starts stretched; for " +
           adjoint_formulations()},
      {"boundary", "symmetry", flag, "", "", "false", any,
       "the displacement normal to the (straight) patch is zero"},
      {"boundary", "displacement", table, "motion", "m", optional, any, "prescribed motion"},
      {"boundary", "traction", number | numbers | table, "curve", "Pa", optional, any,
       "load per reference area: a number or curve is normal, tension positive; a list, or a curve "
       "with a list as amplitude, is a vector"},

      {"motion", "x", number | table, "curve", "m", optional, any, "displacement in x"},
      {"motion", "y", number | table, "curve", "m", optional, any, "displacement in y"},

      {"curve", "curve", text, "", "", required, curve_choices(),
       "value over time, zero before t = 0; pulse: A/2 [erf((t-3r)/r) - erf((t-3r-T)/r)], r the "
       "rise, T the duration"},
      {"curve", "amplitude", number | numbers, "", "", "(of a table: 1)", any,
       "largest value, in the unit of what the curve drives; of a table: a factor"},
      {"curve", "rise", number, "", "s", optional, above(0.0),
       "ramp, smooth-ramp, pulse: time of rise"},
      {"curve", "duration", number, "", "s", optional, above(0.0), "pulse, sine-squared: length"},
      {"curve", "time", numbers, "", "s", optional, any, "table: instants, increasing"},
      {"curve", "value", numbers, "", "", optional, any, "table: the values then"},
      {"curve", "interpolation", text, "", "", "(of a motion: cubic, of a load: linear)",
       Allowed({"linear", "cubic"}),
       "table: lines between the values, or a natural cubic spline: velocity and acceleration of "
       "the motion are continuous, but it overshoots where values stop changing"},

      {"time", "end", number, "", "s", required, above(0.0), "the last step lands on it"},
      {"time", "safety", number, "", "", "0.9", Range{0.0, 1.0, false, true},
       "share of the computed critical step; where large strains stiffen the body, the step falls "
       "below its first value and stays there"},
      {"time", "step", number, "", "s", "(safety x critical step)", above(0.0),
       "instead of safety; the same from start to end. Refused where it exceeds the critical step "
       "at the start by more than 0.5 %"},
      {"time", "allow_unstable", flag, "", "", "false", any,
       "takes a step above the critical one, to see what grows: the run ends where it does"},
      {"time", "energy_tolerance", number, "", "", optional, above(0.0),
       "ends the run where its energy leaves its balance by more than this share of the largest "
       "energy; without it, 1 % and more are reported at the end"},

      {"probe", "name", text, "", "", "(p1, p2, …)", any, "its columns are name.quantity"},
      {"probe", "at", numbers, "", "m", required, any, "reference position, inside the body"},
      {"probe", "record", texts, "", "", "[\"displacement\"]", quantity_choices(),
       "what to record"},

      {"reference", "exact", text, "", "", "\"none\"", choices_of<ExactKind>(),
       "an exact solution: errors go to summary.json"},

      {"initial", "displacement", text | numbers | table, "field", "m", "\"zero\"",
       Allowed({"zero"}), "at t = 0; numbers: the same everywhere"},
      {"initial", "velocity", text | numbers | table, "field", "m/s", "\"zero\"", Allowed({"zero"}),
       "at t = 0; numbers: the same everywhere"},
      {"initial", "region", tables, "initial region", "", optional, any,
       "parts with another start, [[initial.region]]; of overlapping ones the last counts"},

      {"initial region", "box", points | numbers, "", "m", required, any,
       "[[x0, y0], [x1, y1]], in 1D [from, to]: the nodes meant, those on its rim too"},
      {"initial region", "displacement", text | numbers | table, "field", "m", "(of [initial])",
       Allowed({"zero"}), "instead of that of [initial]"},
      {"initial region", "velocity", text | numbers | table, "field", "m/s", "(of [initial])",
       Allowed({"zero"}), "instead of that of [initial]"},

      {"field", "constant", numbers, "", "m or m/s", optional, any, "the same everywhere"},
      {"field", "gradient", points, "", "1 or 1/s", optional, any,
       "[[xx, xy], [yx, yy]]: gradient times position is added"},
      {"field", "field", text, "", "", optional, choices_of<InitialField::Kind>(),
       "a named field: of the swinging plate, or the first bending mode of a beam clamped at left"},
      {"field", "amplitude", number, "", "m or m/s", optional, any,
       "of the named field: its largest component, at the tip of the beam"},

      {"output", "frames", integer, "", "", "50", at_least(0.0),
       "full fields after the initial one"},
      {"output", "fields", texts, "", "", "[\"displacement\", \"velocity\", \"pk1\"]",
       quantity_choices(), "what a frame holds"},
      {"output", "probe_every", integer, "", "steps", "1", at_least(1.0),
       "between rows of probes.csv"},
      {"output", "energy_every", integer, "", "steps", "0", at_least(0.0),
       "between rows of the energy ledger; 0: about 200 rows, at least 50 steps apart"},
      {"output", "checkpoint", number, "", "s", "60", above(0.0), "wall time between checkpoints"},
      {"output", "checkpoint_steps", integer, "", "steps", "0", at_least(0.0),
       "steps between checkpoints; 0: by wall time only"},
  };
}

}  // namespace

const std::vector<Key>& schema() {
  static const std::vector<Key> keys = with_law_constants(all_keys());
  return keys;
}

const Key* find_key(std::string_view group, std::string_view name) {
  for (const Key& key : schema())
    if (key.group == group && key.name == name) return &key;
  return nullptr;
}

}  // namespace tlsph
