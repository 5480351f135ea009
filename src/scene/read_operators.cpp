#include "read_operators.hpp"

#include <utility>

#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

bool is_ghosted(Formulation formulation) {
  return !is_adjoint(formulation);
}

}  // namespace

std::optional<ConsistencyScene> read_consistency(const TableView& root, Formulation formulation,
                                                 int dimension) {
  const bool collocated = formulation == Formulation::consistent;
  ConsistencyScene standard;
  standard.rows = collocated && dimension == 2 ? 2 : 1;
  standard.columns = collocated ? 1 : 0;
  standard.place = root.place_of("consistency");
  const Node* node = root.find("consistency");
  if (node == nullptr) return collocated ? std::optional(standard) : std::nullopt;
  if (const bool* wanted = node->flag()) {
    if (*wanted) return standard;
    if (collocated)
      throw InputError(
          standard.place,
          "formulation \"consistent\" is corrected; without it, it is \"variational\"");
    return std::nullopt;
  }
  const std::vector<double> degrees = read_vector(*node, 2, "[rows, columns]");
  for (const auto& [rows, columns] : {std::pair{1, 0}, std::pair{1, 1}, std::pair{2, 1}})
    if (degrees[0] == rows && degrees[1] == columns) {
      standard.rows = rows;
      standard.columns = columns;
      return standard;
    }
  throw InputError(standard.place, "must be [1, 0], [1, 1] or [2, 1], or true or false");
}

KernelScene read_kernel(const TableView& view, Formulation formulation,
                        const std::optional<ConsistencyScene>& consistency, int dimension) {
  KernelScene kernel;
  kernel.place = view.place();
  kernel.family = view.has("family")        ? view.text("family")
                  : is_ghosted(formulation) ? "modified-mollifier"
                                            : "wendland-c2";
  if (view.has("support"))
    kernel.support = view.number("support");
  else if (formulation == Formulation::consistent)
    kernel.support = consistency->rows > 1 ? 3.6 : dimension == 2 ? 2.6 : 3.1;
  else if (formulation != Formulation::stress_point)
    kernel.support = 2.5;
  kernel.order = view.has("order")                        ? view.small_integer("order")
                 : formulation == Formulation::consistent ? consistency->rows
                                                          : 1;
  kernel.correction = view.choice_or(
      "correction", is_ghosted(formulation) ? Correction::none : Correction::least_squares);
  return kernel;
}

StabiliserScene read_stabiliser(const TableView& view, const Scene& scene) {
  StabiliserScene stabiliser;
  stabiliser.place = view.place();
  StabiliserKind standard = StabiliserKind::none;
  if (scene.dimension == 2 && scene.formulation == Formulation::stress_point &&
      !scene.kernel.support && !scene.body.is_cloud())
    standard = StabiliserKind::cell;
  if ((scene.dimension == 2 && scene.formulation == Formulation::variational) ||
      scene.formulation == Formulation::consistent)
    standard = StabiliserKind::pair;
  stabiliser.kind = view.choice_or("kind", standard);
  if (const Node* coefficient = view.find("coefficient"); coefficient && coefficient->is_number())
    stabiliser.coefficient = coefficient->number();
  stabiliser.action = view.choice_or("as", stabiliser.action);
  return stabiliser;
}

}  // namespace tlsph
