// [kernel], [stabiliser] and consistency: the keys that choose the operators of a scene.
#include "keys.hpp"
#include "tlsph/kernels/families.hpp"

namespace tlsph {
namespace {

const FormulationTraits& traits(const Scene& scene) {
  return traits_of(scene.formulation);
}

bool is_always_corrected(const Scene& scene) {
  return traits(scene).corrected == Corrected::always;
}

std::size_t by_dimension(const Scene& scene) {
  return static_cast<std::size_t>(scene.dimension - 1);
}

/// The degrees that suit the formulation.
ConsistencyScene standard_degrees(const Scene& scene, Place place) {
  const auto [rows, columns] = traits(scene).degrees[by_dimension(scene)];
  return {rows, columns, true, std::move(place)};
}

std::optional<ConsistencyScene> read_consistency(const Node& node, const Scene& scene) {
  if (const bool* wanted = node.flag()) {
    if (*wanted) return standard_degrees(scene, node.place);
    if (is_always_corrected(scene))
      throw InputError(
          node.place, "formulation \"consistent\" is corrected; without it, it is \"variational\"");
    return std::nullopt;
  }
  const std::vector<double> degrees = read_vector(node, 2, "[rows, columns]");
  for (const auto& [rows, columns] : {std::pair{1, 0}, std::pair{1, 1}, std::pair{2, 1}})
    if (degrees[0] == rows && degrees[1] == columns)
      return ConsistencyScene{rows, columns, false, node.place};
  throw InputError(node.place, "must be [1, 0], [1, 1] or [2, 1], or true or false");
}

Node print_consistency(const std::optional<ConsistencyScene>& consistency) {
  if (!consistency) return node_of(false);
  if (consistency->standard) return node_of(true);
  return print_list(std::vector<int>{consistency->rows, consistency->columns});
}

std::vector<std::string> kernel_words() {
  const auto names = kernel_names();
  return {names.begin(), names.end()};
}

std::string standard_family(const KernelScene&, const Scene& scene) {
  return std::string(traits(scene).kernel);
}

int standard_order(const KernelScene&, const Scene& scene) {
  return is_always_corrected(scene) ? scene.consistency->rows : 1;
}

std::optional<double> standard_support(const KernelScene& kernel, const Scene& scene) {
  return traits(scene).default_support(scene.dimension, standard_order(kernel, scene));
}

Correction standard_correction(const KernelScene&, const Scene& scene) {
  return traits(scene).correction;
}

StabiliserKind standard_stabiliser(const StabiliserScene&, const Scene& scene) {
  const StabiliserKind kind = traits(scene).stabiliser[by_dimension(scene)];
  const bool on_cells = !scene.kernel.support && !scene.body.is_cloud();
  return kind == StabiliserKind::cell && !on_cells ? StabiliserKind::none : kind;
}

}  // namespace

Row<Scene> consistency_key() {
  return {{"",
           "consistency",
           flag | numbers,
           "",
           {},
           "degrees of the polynomials that the gradient and its adjoint are made exact for, "
           "[1, 0], [1, 1] or [2, 1]; true: the default for consistent, [1, 0] for stress-point",
           "",
           "(consistent: [2, 1], in 1D [1, 1]; else false)"},
          [](Scene& table, const TableView& view, const Scene& scene) {
            if (const Node* node = view.find("consistency"))
              table.consistency = read_consistency(*node, scene);
            else if (is_always_corrected(scene))
              table.consistency =
                  Defaulted(std::optional(standard_degrees(scene, view.place_of("consistency"))));
          },
          [](const Scene& scene, const Scene&, Printed printed) -> std::optional<Node> {
            if (printed == Printed::given && !scene.consistency.given()) return std::nullopt;
            return print_consistency(scene.consistency);
          }};
}

const Table<KernelScene>& kernel_keys() {
  static const Table<KernelScene> keys = {
      "kernel",
      {
          key(&KernelScene::family, "family", "", Allowed(kernel_words()), "shape of the kernel",
              "(wendland-c2; thesis and mirror: modified-mollifier)", standard_family),
          key(&KernelScene::support, "support", "spacings", not_below(1.0),
              "full radius of the kernel; the least-squares fit of a point whose nodes within it "
              "do not determine its polynomial takes a larger one, up to 2.5 times",
              "(2.5; consistent: 3.6, with linear gradients 2.6, in 1D 3.1; stress-point: the "
              "nodes of each cell)",
              standard_support),
          key(&KernelScene::order, "order", "", closed(1.0, 2.0),
              "degree of the polynomials a least-squares gradient is exact for",
              "(1; consistent: that of its rows)", standard_order),
          key(&KernelScene::correction, "correction", "", {},
              "gradients of collocated nodes: a fitted plane, the gradient or mixed correction of "
              "Bonet and Lok, or plain differences",
              "(least-squares; thesis and mirror: none)", standard_correction),
      }};
  return keys;
}

const Table<StabiliserScene>& stabiliser_keys() {
  static const Table<StabiliserScene> keys = {
      "stabiliser",
      {
          key(&StabiliserScene::kind, "kind", "", {},
              "pair: error of linear extrapolation between neighbours; cell: hourglass mode of a "
              "cell",
              "(consistent: pair; 2D: cell for stress-point on its cells, pair for variational; "
              "else none)",
              standard_stabiliser),
          key(&StabiliserScene::coefficient, "coefficient", "", not_below(0.0),
              "strength as a share of the shear modulus (cell: of E/(1 - nu^2)), as viscosity of "
              "density times speed of shear waves times spacing; auto: the value recommended for "
              "the kind")
              .or_word("auto"),
          key(&StabiliserScene::action, "as", "", {},
              "acts on displacements, which keeps energy and momenta, or on velocities: that "
              "dissipates, lets a body under load creep in modes that its gradients do not see, "
              "and keeps the angular momentum of small motions only"),
      }};
  return keys;
}

}  // namespace tlsph
