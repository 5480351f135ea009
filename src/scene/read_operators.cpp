#include "read_operators.hpp"

#include <utility>

#include "tlsph/scene/names.hpp"

namespace tlsph {

std::optional<ConsistencyScene> read_consistency(const TableView& root, Formulation formulation,
                                                 int dimension) {
  const FormulationTraits& traits = traits_of(formulation);
  const bool always = traits.corrected == Corrected::always;
  const auto [rows, columns] = traits.degrees[static_cast<std::size_t>(dimension - 1)];
  ConsistencyScene standard{rows, columns, root.place_of("consistency")};
  const Node* node = root.find("consistency");
  if (node == nullptr) return always ? std::optional(standard) : std::nullopt;
  if (const bool* wanted = node->flag()) {
    if (*wanted) return standard;
    if (always)
      throw InputError(
          standard.place,
          "formulation \"consistent\" is corrected; without it, it is \"variational\"");
    return std::nullopt;
  }
  const std::vector<double> degrees = read_vector(*node, 2, "[rows, columns]");
  for (const auto& [r, c] : {std::pair{1, 0}, std::pair{1, 1}, std::pair{2, 1}})
    if (degrees[0] == r && degrees[1] == c) return ConsistencyScene{r, c, standard.place};
  throw InputError(standard.place, "must be [1, 0], [1, 1] or [2, 1], or true or false");
}

KernelScene read_kernel(const TableView& view, Formulation formulation,
                        const std::optional<ConsistencyScene>& consistency, int dimension) {
  const FormulationTraits& traits = traits_of(formulation);
  const int order = traits.corrected == Corrected::always ? consistency->rows : 1;
  KernelScene kernel;
  kernel.place = view.place();
  kernel.family = view.has("family") ? view.text("family") : std::string(traits.kernel);
  kernel.support = view.has("support") ? std::optional(view.number("support"))
                                       : traits.default_support(dimension, order);
  kernel.order = view.has("order") ? view.small_integer("order") : order;
  kernel.correction = view.choice_or("correction", traits.correction);
  return kernel;
}

StabiliserScene read_stabiliser(const TableView& view, const Scene& scene) {
  StabiliserScene stabiliser;
  stabiliser.place = view.place();
  StabiliserKind standard =
      traits_of(scene.formulation).stabiliser[static_cast<std::size_t>(scene.dimension - 1)];
  if (standard == StabiliserKind::cell && (scene.kernel.support || scene.body.is_cloud()))
    standard = StabiliserKind::none;
  stabiliser.kind = view.choice_or("kind", standard);
  if (const Node* coefficient = view.find("coefficient"); coefficient && coefficient->is_number())
    stabiliser.coefficient = coefficient->number();
  stabiliser.action = view.choice_or("as", stabiliser.action);
  return stabiliser;
}

}  // namespace tlsph
