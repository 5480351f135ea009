#pragma once
/// \file
/// Sparse matrices factorised once and solved many times: Cholesky (symmetric positive definite),
/// LU (square), QR (least norm). This is the only door to SuiteSparse, and nothing of it shows
/// here.
///
/// A factorisation is immutable (but for Cholesky::refactorize), movable, and may be shared by
/// threads: what a solve writes lives in a SolveWorkspace, one for each thread. With a workspace at
/// hand a solve takes nothing from the heap, so it may stand inside a time step.
///
/// Every class throws NumericalError (time 0, particle −1) when the matrix cannot be factorised: a
/// value that is not finite, a singular or indefinite matrix. One that is too large for the memory,
/// or for 32-bit indices, is std::bad_alloc.

#include <memory>
#include <optional>
#include <string>

#include "tlsph/core/error.hpp"
#include "tlsph/core/types.hpp"

namespace tlsph {

/// Scratch memory of repeated solves, made by `factorization.workspace()` and good for that one.
class SolveWorkspace {
 public:
  ~SolveWorkspace();
  SolveWorkspace(const SolveWorkspace&) = delete;
  SolveWorkspace& operator=(const SolveWorkspace&) = delete;
  SolveWorkspace(SolveWorkspace&&) noexcept;
  SolveWorkspace& operator=(SolveWorkspace&&) noexcept;

 private:
  friend class Factorization;
  friend class Cholesky;
  friend class Lu;
  struct Impl;
  explicit SolveWorkspace(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// What can be done with any factorisation of a square matrix A (n×n).
class Factorization {
 public:
  ~Factorization();
  Factorization(const Factorization&) = delete;
  Factorization& operator=(const Factorization&) = delete;
  Factorization(Factorization&&) noexcept;
  Factorization& operator=(Factorization&&) noexcept;

  [[nodiscard]] Index rows() const;

  /// x with A x = b, for one right-hand side or a column for each; as many columns as b, known at
  /// compile time if those of b are.
  template <typename Rhs>
  [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, Rhs::ColsAtCompileTime> solve(
      const Eigen::MatrixBase<Rhs>& b) const {
    return solve_columns(b);
  }

  [[nodiscard]] SolveWorkspace workspace() const;
  /// As `solve`, n values from `rhs` to `x` (which must not overlap), without heap allocation.
  void solve_into(const double* rhs, double* x, SolveWorkspace& workspace) const;

  /// Estimate of ‖A‖₁ ‖A⁻¹‖₁ at the cost of a few solves (Hager 1984, Higham 1988): never above the
  /// true number, seldom below a third of it.
  [[nodiscard]] double condition_estimate() const;

 protected:
  struct Impl;
  explicit Factorization(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;

 private:
  [[nodiscard]] Eigen::MatrixXd solve_columns(const Eigen::Ref<const Eigen::MatrixXd>& b) const;
};

/// P A Pᵀ = L Lᵀ of a symmetric positive definite matrix (CHOLMOD, fill-reducing order, supernodal
/// where that pays).
class Cholesky : public Factorization {
 public:
  /// Only the lower triangle of A (n×n) is read, so A may be stored in full or by its lower half.
  explicit Cholesky(const SparseMatrix& A);

  /// Empty when A is not positive definite, and only then; every other failure throws.
  [[nodiscard]] static std::optional<Cholesky> attempt(const SparseMatrix& A);

  /// New values in the same pattern of non-zeros: the order and the symbolic analysis are kept.
  /// Another pattern is std::invalid_argument. If the new matrix is not positive definite it
  /// throws, and nothing may be solved before a refactorisation succeeds.
  void refactorize(const SparseMatrix& A);

 private:
  struct Factor;
  using Factorization::Factorization;
};

/// P R A Q = L U of a general square matrix (UMFPACK), with iterative refinement in each solve.
class Lu : public Factorization {
 public:
  /// `refinement_steps` is the most that a solve takes; it stops as soon as they no longer help.
  explicit Lu(const SparseMatrix& A, int refinement_steps = 2);

 private:
  struct Factor;
};

/// Which factorisation a square system may use: Cholesky where the matrix allows it and LU
/// elsewhere, or one of them.
enum class SolverChoice { automatic, cholmod, umfpack };

/// Cholesky where the matrix allows it and LU elsewhere; the factorisation decides, not a guess.
class SymmetricOrGeneral : public Factorization {
 public:
  /// `automatic` takes Cholesky for a matrix that is symmetric (to rounding) and positive definite,
  /// LU otherwise. `cholmod` for a matrix that is not both is an InputError at `place`, which says
  /// why.
  explicit SymmetricOrGeneral(const SparseMatrix& A, SolverChoice choice = SolverChoice::automatic,
                              const Place& place = {});

  /// The factorisation in use, `cholmod` or `umfpack`.
  [[nodiscard]] SolverChoice chosen() const { return chosen_; }
  /// Why it is in use, as a clause to print: "not symmetric: …", "symmetric, not positive
  /// definite".
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  SolverChoice chosen_ = SolverChoice::umfpack;
  std::string reason_;
};

/// The x of least ‖x‖₂ with A x = b, from Aᵀ E = Q R (SPQR). Backward stable: where the condition κ
/// of A is so large that A Aᵀ, with κ², is singular to rounding, x still meets its conditions to
/// rounding of ‖A‖ ‖x‖. A has no more rows than columns, and none depends on the others.
class LeastNorm {
 public:
  /// Of Aᵀ.
  explicit LeastNorm(const SparseMatrix& transposed);

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b);

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
};

/// What a Cholesky factorisation will cost, before it is made.
struct FactorCost {
  Index rows = 0;
  double entries = 0.0;  ///< of the factor
  double flops = 0.0;    ///< of a numerical factorisation
  double bytes = 0.0;    ///< of the factor, its indices and what making it takes beside it
};

/// From the order and the symbolic analysis that Cholesky would use for the matrix (its lower
/// triangle), at a small part of the cost; values are not looked at.
[[nodiscard]] FactorCost factor_cost(const SparseMatrix& A);

/// Floating point operations a second [1/s] that this machine reaches in factorisations: of a small
/// dense matrix, now, in less than a tenth of a second.
[[nodiscard]] double factorisation_speed();

/// Limits the BLAS behind the factorisations to `threads`, where it is OpenBLAS; another BLAS
/// follows its own environment variables. Several processes that factorise side by side would
/// otherwise wait for each other.
void set_blas_threads(int threads);

}  // namespace tlsph
