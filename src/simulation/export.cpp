#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "flat.hpp"
#include "in_scene.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/dynamics/stabiliser_forces.hpp"
#include "tlsph/io/cloud.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/io/matrices.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/simulation.hpp"
#include "tlsph/simulation/version.hpp"
#include "tlsph/stepping/critical_step.hpp"

namespace tlsph {
namespace {

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

/// Every name under which some export writes an operator.
std::vector<std::string> operator_names() {
  std::vector<std::string> names = {"W", "M", "S", "C"};
  for (const char* letter : {"G", "D", "D_folded"})
    for (const char* axis : axes) {
      names.push_back(fmt::format("{}_{}", letter, axis));
      for (const char* component : axes)
        names.push_back(fmt::format("{}_{}_u{}", letter, axis, component));
    }
  return names;
}

/// The report of the export before; empty if there is none that can be read.
Json earlier(const std::filesystem::path& report) {
  try {
    return Json::read(report);
  } catch (const InputError&) {
    return {};
  }
}

/// Writes operators one by one and describes each in the report. operators.h5 holds them all, and
/// beside them what they map between, /particles/{X, V, tag} and /points/{X, V}.
class Exporter {
 public:
  Exporter(const std::filesystem::path& directory, const CloudView& particles,
           const CloudView& points)
      : directory_(directory), file_(Hdf5File::create(directory / "operators.h5")) {
    write_cloud(file_, "/particles", particles);
    write_cloud(file_, "/points", points);
  }

  void write(const std::string& name, const SparseMatrix& matrix) {
    stop_point();
    write_matrix_market(directory_ / (name + ".mtx"), matrix);
    write_compressed_rows(file_, name, matrix);
    Json entry;
    entry.set("rows", matrix.rows());
    entry.set("columns", matrix.cols());
    entry.set("nonzeros", matrix.nonZeros());
    if (matrix.rows() == matrix.cols()) {
      const double size = matrix.norm();
      const SparseMatrix transposed = matrix.transpose();
      entry.set("symmetry_error",
                size > 0.0 ? SparseMatrix(matrix - transposed).norm() / size : 0.0);
    }
    report_.set("operators." + name, entry);
  }
  void set(const std::string& key, auto value) { report_.set(key, value); }
  [[nodiscard]] Json& report() { return report_; }
  /// Matrices of the export that was in this folder before, and are none of this one, go.
  void finish() {
    file_.close();
    const std::filesystem::path report = directory_ / "report.json";
    const Json before = earlier(report);
    for (const std::string& name : operator_names()) {
      if (!before.has("operators." + name) || report_.has("operators." + name)) continue;
      const std::filesystem::path file = directory_ / (name + ".mtx");
      std::error_code error;
      std::filesystem::remove(file, error);
      if (error)
        throw OutputError(file.string() + ": cannot remove this file of the export before");
    }
    report_.write(report);
  }

 private:
  std::filesystem::path directory_;
  Hdf5File file_;
  Json report_;
};

/// max |G^a 1| and max |G^a X^b − δ_ab|, both over rows and directions; G in units of 1/Δ.
template <int D>
void report_consistency(Exporter& out, const Discretisation<D>& body) {
  double row_sum = 0.0;
  double moment = 0.0;
  double adjointness = 0.0;
  double size = 0.0;
  const int components = body.gradient.per_component() ? D : 1;
  for (int i = 0; i < components; ++i)
    for (int a = 0; a < D; ++a) {
      const SparseMatrix G = body.gradient.matrix(a, i);
      const ScalarField ones = G * ScalarField::Ones(G.cols());
      row_sum = std::max(row_sum, ones.cwiseAbs().maxCoeff() * body.spacing);
      for (int b = 0; b < D; ++b) {
        const ScalarField linear = G * body.particles.X.col(b);
        moment = std::max(moment, (linear.array() - (a == b ? 1.0 : 0.0)).abs().maxCoeff());
      }
      const SparseMatrix force = body.divergence.matrix(a, i);
      const SparseMatrix adjoint = SparseMatrix(G.transpose()) * body.points.V.asDiagonal();
      adjointness += SparseMatrix(force + adjoint).squaredNorm();
      size += force.squaredNorm();
    }
  out.set("gradient.row_sum_residual", row_sum);
  out.set("gradient.linear_moment_residual", moment);
  out.set("gradient.adjointness_error", size > 0.0 ? std::sqrt(adjointness / size) : 0.0);
}

template <int D>
void write_vector_operator(Exporter& out, const char* letter, const VectorOperator<D>& op) {
  for (int a = 0; a < D; ++a) {
    if (!op.per_component()) {
      out.write(fmt::format("{}_{}", letter, axes[static_cast<std::size_t>(a)]), op.matrix(a));
      continue;
    }
    // Mirrored boundaries: the weights of each component, G_x_ux acts on u_x.
    for (int i = 0; i < D; ++i)
      out.write(fmt::format("{}_{}_u{}", letter, axes[static_cast<std::size_t>(a)],
                            axes[static_cast<std::size_t>(i)]),
                op.matrix(a, i));
  }
}

template <int D>
void export_in(const Scene& scene, const std::filesystem::path& directory) {
  const auto body = build<D>(scene);
  may_end_at_once() = false;
  make_output_directory(directory);
  auto [tags, patches] = patch_tags<D>(body.particles);
  VectorField<D> X = body.particles.X;
  ScalarField V = body.particles.V;
  if (body.ghosts) {
    const GhostLattice<D>& lattice = body.ghosts->lattice();
    X = lattice.X;
    V = ScalarField::Constant(X.rows(), body.particles.spacings.prod());
    tags.resize(static_cast<std::size_t>(X.rows()), std::int64_t{1} << 62);
  }
  const CloudView particles{D, flat(X), flat(V), tags, patches};
  // With ghosts, nodes are the material points of the strong form: one cloud, lattice volumes.
  Exporter out(directory, particles,
               body.ghosts ? CloudView{D, flat(X), flat(V)}
                           : CloudView{D, flat(body.points.X), flat(body.points.V)});
  out.set("scene", scene.file);
  out.set("version", version());
  out.set("dimension", D);
  out.set("formulation", name_of(scene.formulation));
  out.set("particles", body.nodes());
  out.set("ghosts", body.ghosts ? body.ghosts->lattice().ghosts() : Index{0});
  out.set("points", body.points.size());

  if (body.ghosts) {
    out.write("W", body.ghosts->kernel_matrix());
    write_vector_operator<D>(out, "G", body.ghosts->plain_gradient());
    write_vector_operator<D>(out, "D", body.ghosts->plain_gradient().row_scaled(V));
    // The force operator of the run, the ghosts of the stress eliminated.
    write_vector_operator<D>(out, "D_folded", body.divergence);
    out.report().set("boundary_systems", body.ghosts->report());
  } else {
    if (scene.kernel.support) {
      const auto kernel = kernel_by_name(scene.kernel.family);
      out.write("W", kernel_matrix<D>(*kernel, *scene.kernel.support * body.spacing,
                                      body.particles.X, body.particles.V));
    }
    write_vector_operator<D>(out, "G", body.gradient);
    report_consistency<D>(out, body);
    write_vector_operator<D>(out, "D", body.divergence);
  }
  SparseMatrix mass(body.nodes(), body.nodes());
  mass.setIdentity();
  mass.diagonal() = body.mass;
  out.write("M", mass);
  if (has_stabiliser(body)) out.write("S", stabiliser_matrix<D>(body));
  if (body.viscosity.nonZeros() > 0) out.write("C", body.viscosity);

  InitialState<D> initial = build_initial<D>(scene, body);
  State<D> state =
      make_state<D>(body, std::move(initial.displacement), std::move(initial.velocity));
  evaluate<D>(body, state);
  const CriticalStep critical = critical_step<D>(body, state);
  out.set("spectrum.dt_critical", critical.dt);
  out.set("spectrum.dt_critical_scaled", critical.scaled);
  out.set("spectrum.largest_angular_frequency", 2.0 / critical.dt);
  if (critical.growth) out.set("spectrum.largest_growth_rate", *critical.growth);
  out.finish();
}

}  // namespace

void export_operators(const Scene& scene, const std::filesystem::path& out) {
  const NewFiles made(out);
  try {
    in_scene(scene,
             [&] { in_dimension(scene.dimension, [&]<int D>() { export_in<D>(scene, out); }); });
  } catch (...) {  // half of the operators are of no use
    made.remove();
    throw;
  }
}

}  // namespace tlsph
