#include "tlsph/scene/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "overrides.hpp"
#include "read_body.hpp"
#include "read_boundary.hpp"
#include "read_operators.hpp"
#include "rules.hpp"
#include "tlsph/observe/quantity.hpp"
#include "view.hpp"

namespace tlsph {
namespace {

/// The constants of the law, those that the table leaves out from `base`. A constant of another law
/// is refused.
std::vector<double> read_constants(const TableView& view, LawName law, const MaterialScene* base) {
  std::vector<double> values;
  for (const LawConstant& constant : constants_of(law)) {
    const auto inherited = base == nullptr ? std::nullopt : base->constant(constant.name);
    values.push_back(inherited ? view.number_or(constant.name, *inherited)
                               : view.require(constant.name).number());
  }
  for (const LawConstant& constant : all_law_constants())
    if (view.has(constant.name) && std::ranges::find(constants_of(law), constant.name,
                                                     &LawConstant::name) == constants_of(law).end())
      throw InputError(view.place_of(constant.name),
                       fmt::format("the law \"{}\" has no such constant", name_of(law)));
  return values;
}

std::vector<MaterialScene> read_materials(const TableView& view, int dimension) {
  MaterialScene base;
  base.place = view.place();
  base.law = view.choice<LawName>("law");
  base.assumption = view.choice<Assumption>("assumption");
  base.constants = read_constants(view, base.law, nullptr);
  base.density = view.number("density");
  std::vector<MaterialScene> materials = {base};
  for (const TableView& region : view.tables("region")) {
    MaterialScene part = base;
    part.place = region.place();
    const auto corners = read_box(region.require("box"), dimension);
    part.lower = corners.lower;
    part.upper = corners.upper;
    part.law = region.choice_or("law", base.law);
    part.constants = read_constants(region, part.law, &base);
    part.density = region.number_or("density", base.density);
    materials.push_back(part);
  }
  return materials;
}

TimeScene read_time(const TableView& view) {
  TimeScene time;
  time.place = view.place();
  time.end = view.number("end");
  time.safety = view.number("safety");
  if (view.has("step")) time.step = view.number("step");
  time.allow_unstable = view.flag("allow_unstable");
  if (view.has("energy_tolerance")) time.energy_tolerance = view.number("energy_tolerance");
  time.end_place = view.place_of("end");
  time.step_place = view.place_of("step");
  if (time.step && *time.step > time.end)
    throw InputError(view.place_of("step"),
                     fmt::format("must not exceed time.end, {} s", time.end));
  return time;
}

/// A name that can head a column of probes.csv.
void check_probe_name(const std::string& name, const Place& place) {
  const bool plain = !name.empty() && name.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-") == std::string::npos;
  if (!plain)
    throw InputError(place, fmt::format("\"{}\" cannot head a column; allowed: letters, digits, _ "
                                        "and -",
                                        name));
}

std::vector<ProbeScene> read_probes(const TableView& root, int dimension) {
  std::vector<ProbeScene> probes;
  for (const TableView& view : root.tables("probe")) {
    ProbeScene probe;
    probe.place = view.place_of("at");
    probe.name = view.has("name") ? view.text("name") : fmt::format("p{}", probes.size() + 1);
    check_probe_name(probe.name, view.place_of("name"));
    for (const ProbeScene& other : probes)
      if (other.name == probe.name)
        throw InputError(view.place_of("name"),
                         fmt::format("\"{}\" is already the name of another probe", probe.name));
    probe.at = read_vector(view.require("at"), dimension, "one per dimension");
    for (const auto& word : view.texts("record")) {
      if (std::find(probe.record.begin(), probe.record.end(), word) != probe.record.end())
        throw InputError(view.place_of("record"), fmt::format("\"{}\" is listed twice", word));
      probe.record.push_back(word);
    }
    if (probe.record.empty())
      throw InputError(view.place_of("record"), fmt::format("must name at least one of {}",
                                                            fmt::join(quantity_names, " | ")));
    probes.push_back(std::move(probe));
  }
  return probes;
}

InitialField read_initial(const TableView& initial, std::string_view key, int dimension) {
  InitialField field;
  field.place = initial.place_of(key);
  if (!initial.has(key) || initial.find(key)->text()) return field;
  if (const Node& node = *initial.find(key); node.list()) {
    field.kind = InitialField::Kind::linear;
    field.constant = read_vector(node, dimension, "one per dimension");
    return field;
  }
  const TableView view = initial.table(key);
  if (view.has("field")) {
    for (const char* other : {"constant", "gradient"})
      if (view.has(other))
        throw InputError(view.place_of(other), "does not go with a named field; leave one out");
    field.kind = view.choice<InitialField::Kind>("field");
    view.require("amplitude");
    field.amplitude = view.number("amplitude");
    return field;
  }
  if (view.has("amplitude"))
    throw InputError(view.place_of("amplitude"), "goes with a named field; give field too");
  if (!view.has("constant") && !view.has("gradient"))
    throw InputError(view.place(), "must have constant, gradient or field; or be \"zero\"");
  const auto n = static_cast<std::size_t>(dimension);
  field.kind = InitialField::Kind::linear;
  field.constant.assign(n, 0.0);
  field.gradient.assign(n, std::vector<double>(n, 0.0));
  if (const Node* constant = view.find("constant"))
    field.constant = read_vector(*constant, dimension, "one per dimension");
  if (const Node* gradient = view.find("gradient")) {
    if (gradient->list()->size() != n)
      throw InputError(gradient->place,
                       fmt::format("must have {} row{}, one per dimension, not {}", n,
                                   n == 1 ? "" : "s", gradient->list()->size()));
    for (std::size_t i = 0; i < n; ++i)
      field.gradient[i] = read_vector((*gradient->list())[i], dimension, "one per dimension");
  }
  return field;
}

std::vector<InitialRegion> read_initial_regions(const TableView& initial, int dimension) {
  std::vector<InitialRegion> regions;
  for (const TableView& view : initial.tables("region")) {
    InitialRegion region;
    region.place = view.place();
    const auto corners = read_box(view.require("box"), dimension);
    region.lower = corners.lower;
    region.upper = corners.upper;
    if (view.has("displacement"))
      region.displacement = read_initial(view, "displacement", dimension);
    if (view.has("velocity")) region.velocity = read_initial(view, "velocity", dimension);
    if (!region.displacement && !region.velocity)
      throw InputError(region.place, "says nothing about its box; give displacement or velocity");
    regions.push_back(std::move(region));
  }
  return regions;
}

OutputScene read_output(const TableView& view) {
  OutputScene output;
  output.frames = view.small_integer("frames");
  output.probe_every = view.small_integer("probe_every");
  output.energy_every = view.small_integer("energy_every");
  output.checkpoint = view.number("checkpoint");
  output.checkpoint_steps = view.small_integer("checkpoint_steps");
  output.fields = view.texts("fields");
  auto sorted = output.fields;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    throw InputError(view.place_of("fields"), "lists a field twice");
  return output;
}

Scene build(const TableView& root) {
  Scene scene;
  scene.title = root.text("title");
  scene.dimension = root.small_integer("dimension");
  scene.formulation = root.choice<Formulation>("formulation");
  scene.formulation_place = root.place_of("formulation");
  scene.ghosts = root.choice<GhostClosure>("boundary_treatment");
  scene.boundary_solver = root.choice<SolverChoice>("boundary_solver");
  scene.precision = root.choice<Precision>("precision");
  scene.boundary_solver_place = root.place_of("boundary_solver");
  for (const char* name : {"body", "material", "time"}) root.require(name);
  scene.body = read_body(root.table("body"), scene.dimension, scene.formulation);
  scene.consistency = read_consistency(root, scene.formulation, scene.dimension);
  scene.kernel =
      read_kernel(root.table("kernel"), scene.formulation, scene.consistency, scene.dimension);
  scene.stabiliser = read_stabiliser(root.table("stabiliser"), scene);
  scene.materials = read_materials(root.table("material"), scene.dimension);
  for (const TableView& view : root.tables("boundary"))
    scene.boundaries.push_back(read_boundary(view, scene.dimension));
  if (const Node* gravity = root.find("gravity"))
    scene.body_force = read_vector(*gravity, scene.dimension, "one per dimension");
  scene.time = read_time(root.table("time"));
  scene.probes = read_probes(root, scene.dimension);
  const TableView reference = root.table("reference");
  scene.exact = reference.choice<ExactKind>("exact");
  scene.exact_place = reference.place_of("exact");
  const TableView initial = root.table("initial");
  scene.displacement = read_initial(initial, "displacement", scene.dimension);
  scene.velocity = read_initial(initial, "velocity", scene.dimension);
  scene.initial_regions = read_initial_regions(initial, scene.dimension);
  scene.output = read_output(root.table("output"));
  return scene;
}

std::string read_file(const std::filesystem::path& file) {
  const Place place{file.string(), 0, 0, ""};
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError(place, "no such file");
  if (status.type() == std::filesystem::file_type::directory)
    throw InputError(place, "a directory, not a scene file");
  std::ifstream stream(file, std::ios::binary);
  // Far above any scene; below what a device or a data file would pour in.
  constexpr std::size_t limit = std::size_t{16} << 20U;
  std::string text;
  std::vector<char> chunk(std::size_t{1} << 16U);
  while (stream && text.size() <= limit) {
    stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad() || (!stream.eof() && text.size() <= limit))
    throw InputError(place, "cannot be read; check its permissions");
  if (text.size() > limit) throw InputError(place, "larger than 16 MiB: not a scene file");
  return text;
}

}  // namespace

Scene read_scene_text(const std::string& text, const std::string& name,
                      const std::vector<std::string>& overrides) {
  Node document = parse_document(text, name);
  if (document.table()->empty() && overrides.empty())
    throw InputError(document.place, "empty: a scene has at least [body], [material] and [time]");
  for (const auto& change : overrides) apply_override(document, change);
  check_document(document);

  const TableView root(document);
  Scene scene = build(root);
  check_formulation(scene, root);
  check_positions(scene);
  check_boundaries(scene);
  check_exact(scene);
  scene.file = name;
  scene.text = overrides.empty() ? text : print_document(document);
  return scene;
}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_scene_text(read_file(file), file.string(), overrides);
}

}  // namespace tlsph
