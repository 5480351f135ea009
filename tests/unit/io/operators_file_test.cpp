#include "tlsph/io/operators_file.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "support.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using Dense = Eigen::MatrixXd;

class Operators : public test::TemporaryDirectory {
 protected:
  std::filesystem::path path = directory / "operators.h5";
  std::vector<double> X{0, 0, 1, 0, 1, 1}, V{0.5, 0.25, 0.25}, point_X{0.5, 0.5}, point_V{1};
  std::vector<std::int64_t> tag{1, 0, 2};
  CloudView particles{2, X, V, tag, {"left", "right"}}, points{2, point_X, point_V, {}, {}};
};

TEST_F(Operators, AreCompressedRowsAsScipyTakesThem) {
  SparseMatrix matrix(3, 2);
  matrix.insert(0, 1) = 2.0;
  matrix.insert(2, 0) = -1.0;
  matrix.insert(2, 1) = 0.1;
  OperatorsFile operators(path, particles, points);
  operators.write("G_x", matrix);  // not compressed
  operators.write_diagonal("M", Eigen::Vector3d(1, 2, 3));
  operators.close();

  const Hdf5File file = Hdf5File::open_read_only(path);

  EXPECT_THAT(file.read_integers("/G_x/indptr").values, ElementsAre(0, 1, 1, 3));
  EXPECT_THAT(file.read_integers("/G_x/indices").values, ElementsAre(1, 0, 1));
  EXPECT_THAT(file.read_doubles("/G_x/data").values, ElementsAre(2.0, -1.0, 0.1));
  EXPECT_THAT(file.read_integers("/G_x/shape").values, ElementsAre(3, 2));
  EXPECT_EQ(Dense(read_operator(file, "G_x")), Dense(matrix));
  EXPECT_EQ(Dense(read_operator(file, "M")), Dense(Eigen::Vector3d(1, 2, 3).asDiagonal()));
}

TEST_F(Operators, ParticlesAndPointsStandBeside) {
  OperatorsFile(path, particles, points).close();

  const Hdf5File file = Hdf5File::open_read_only(path);

  EXPECT_THAT(file.read_doubles("/particles/X").shape, ElementsAre(3, 2));
  EXPECT_EQ(file.read_doubles("/particles/X").values, X);
  EXPECT_EQ(file.read_doubles("/particles/V").values, V);
  EXPECT_EQ(file.text_attribute("/particles/V", "unit"), "m^2");
  EXPECT_EQ(file.read_integers("/particles/tag").values, tag);
  EXPECT_THAT(file.texts_attribute("/particles/tag", "patches"), ElementsAre("left", "right"));
  EXPECT_EQ(file.read_doubles("/points/X").values, point_X);
  EXPECT_FALSE(file.exists("/points/tag"));
}

TEST_F(Operators, EmptyMatrix) {
  OperatorsFile operators(path, particles, points);
  operators.write("none", SparseMatrix(3, 0));
  operators.close();

  const SparseMatrix read = read_operator(Hdf5File::open_read_only(path), "none");

  EXPECT_EQ(read.rows(), 3);
  EXPECT_EQ(read.cols(), 0);
}

TEST_F(Operators, ArraysThatDoNotFitAreRefused) {
  Hdf5File file = Hdf5File::create(path);
  file.write("/A/shape", std::vector<std::int64_t>{2, 2}, {2});
  file.write("/A/indptr", std::vector<std::int32_t>{0, 1, 2}, {3});
  file.write("/A/indices", std::vector<std::int32_t>{0, 2}, {2});  // column 2 of 2
  file.write("/A/data", std::vector<double>{1, 1}, {2});

  EXPECT_THROW(read_operator(file, "A"), InputError);
  EXPECT_THROW(read_operator(file, "B"), InputError);
}

}  // namespace
}  // namespace tlsph
