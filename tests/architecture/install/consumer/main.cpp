// The smallest use of an installed tlsph that needs a third party at the link.
#include <iomanip>
#include <iostream>
#include <tlsph/core/types.hpp>
#include <tlsph/linear/factorization.hpp>

int main() {
  tlsph::SparseMatrix A(3, 3);
  for (int i = 0; i < 3; ++i) A.insert(i, i) = 2.0;
  for (int i = 1; i < 3; ++i) A.insert(i, i - 1) = -1.0;
  const Eigen::Vector3d x = tlsph::Cholesky(A).solve(Eigen::Vector3d::Unit(0));
  std::cout << std::setprecision(12) << x(0) << ' ' << x(1) << ' ' << x(2) << '\n';
}
