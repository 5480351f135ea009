#include "tlsph/io/matrix_market.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <bit>
#include <cstdint>

#include "support.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using test::message_of;
using testing::HasSubstr;
using Dense = Eigen::MatrixXd;

class MatrixMarket : public test::TemporaryDirectory {
 protected:
  std::filesystem::path path = directory / "m.mtx";

  Dense read(const std::string& text) {
    test::write_text(path, text);
    return Dense(read_matrix_market(path));
  }
};

SparseMatrix awkward_matrix() {
  const auto values = test::awkward_doubles(60);
  std::vector<Eigen::Triplet<double, int>> entries;
  for (int k = 0; k < 60; ++k)
    entries.emplace_back(k % 7, (3 * k) % 11, values[static_cast<std::size_t>(k)]);
  SparseMatrix matrix(7, 11);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST_F(MatrixMarket, SparseMatrixComesBackBitForBitWithItsStoredZeros) {
  const SparseMatrix written = awkward_matrix();

  write_matrix_market(path, written, "gradient\nsecond line");
  const SparseMatrix read = read_matrix_market(path);

  ASSERT_EQ(read.rows(), 7);
  ASSERT_EQ(read.cols(), 11);
  ASSERT_EQ(read.nonZeros(), written.nonZeros());
  for (Index k = 0; k < written.nonZeros(); ++k) {
    ASSERT_EQ(read.innerIndexPtr()[k], written.innerIndexPtr()[k]);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read.valuePtr()[k]),
              std::bit_cast<std::uint64_t>(written.valuePtr()[k]));
  }
}

TEST_F(MatrixMarket, TextIsThatOfTheFormat) {
  SparseMatrix matrix(2, 3);
  matrix.insert(0, 2) = 0.1;
  matrix.insert(1, 0) = -3;

  write_matrix_market(path, matrix, "why");

  EXPECT_EQ(test::read_text(path),
            "%%MatrixMarket matrix coordinate real general\n% why\n2 3 2\n"
            "1 3 0.10000000000000001\n2 1 -3\n");
}

TEST_F(MatrixMarket, DiagonalsAndVectors) {
  const ScalarField values = Eigen::Vector3d(1.5, 0.0, -2.0);

  write_matrix_market_diagonal(path, values);
  EXPECT_EQ(Dense(read_matrix_market(path)), Dense(values.asDiagonal()));
  write_matrix_market_vector(path, values);
  EXPECT_EQ(Dense(read_matrix_market(path)), Dense(values));
}

TEST_F(MatrixMarket, EmptyMatrices) {
  write_matrix_market(path, SparseMatrix(0, 4));
  EXPECT_EQ(read_matrix_market(path).cols(), 4);
  write_matrix_market(path, SparseMatrix(3, 2));
  EXPECT_EQ(read_matrix_market(path).nonZeros(), 0);
}

TEST_F(MatrixMarket, ReadsWhatOthersWrite) {
  Dense expected(2, 2);
  expected << 1, -2, -2, 0;

  EXPECT_EQ(
      read("%%MatrixMarket matrix coordinate real symmetric\n%x\n\n2 2 2\n1 1 +1.0\n 2 1 -2e0 \n"),
      expected);
  EXPECT_EQ(read("%%MatrixMarket MATRIX Coordinate Integer General\r\n2 2 3\r\n1 1 1\r\n2 1 "
                 "-2\r\n1 2 -2\r\n"),
            expected);
  EXPECT_EQ(read("%%MatrixMarket matrix array real general\n2 2\n1\n-2\n-2\n0\n"), expected);
  EXPECT_EQ(read("%%MatrixMarket matrix array real symmetric\n2 2\n1\n-2\n0\n"), expected);
}

TEST_F(MatrixMarket, SymmetricArrayGoesDownItsColumns) {
  Dense expected(3, 3);
  expected << 1, 2, 3, 2, 4, 5, 3, 5, 6;

  EXPECT_EQ(read("%%MatrixMarket matrix array real symmetric\n3 3\n1\n2\n3\n4\n5\n6\n"), expected);
}

struct Broken {
  const char* name;
  const char* text;
  const char* message;  // with the line
};

class BrokenMatrixMarket : public MatrixMarket, public testing::WithParamInterface<Broken> {};

TEST_P(BrokenMatrixMarket, IsRefusedWithItsLine) {
  const auto message = message_of<InputError>([&] { read(GetParam().text); });

  EXPECT_THAT(message, HasSubstr(path.string() + GetParam().message));
}

#define HEADER "%%MatrixMarket matrix coordinate real general\n"
INSTANTIATE_TEST_SUITE_P(
    Texts, BrokenMatrixMarket,
    testing::Values(
        Broken{"Empty", "", ":1: must be"}, Broken{"NoHeader", "2 2 1\n1 1 1\n", ":1: must be"},
        Broken{"Complex", "%%MatrixMarket matrix coordinate complex general\n", ":1: field"},
        Broken{"Skew", "%%MatrixMarket matrix coordinate real skew-symmetric\n", ":1: symmetry"},
        Broken{"NoSize", HEADER "% only this\n", ":3: rows"},
        Broken{"NegativeSize", HEADER "-1 2 0\n", ":2: rows"},
        Broken{"SymmetricNotSquare", "%%MatrixMarket matrix coordinate real symmetric\n2 3 0\n",
               ":2: a symmetric"},
        Broken{"RowOutside", HEADER "2 2 1\n3 1 1\n", ":3: row 3"},
        Broken{"ColumnZero", HEADER "2 2 1\n1 0 1\n", ":3: column 0"},
        Broken{"NoNumber", HEADER "2 2 1\n1 1 1x\n", ":3: \"1x\" is not a number"},
        Broken{"NoInteger", HEADER "2 2 1\n1.5 1 1\n", ":3: \"1.5\" is not an integer"},
        Broken{"Short", HEADER "2 2 2\n1 1 1\n", ":4: 2 entries are announced, 1 are there"},
        Broken{"Long", HEADER "2 2 1\n1 1 1\n2 2 1\n", ":4: 1 entries are announced"},
        Broken{"Twice", HEADER "2 2 3\n1 1 1\n2 2 1\n1 1 4\n",
               ":5: entry 1 1 was given before, in line 3"},
        Broken{"MissingValue", HEADER "2 2 1\n1 1\n", ":3: must be"}),
    [](const auto& test) { return test.param.name; });
#undef HEADER

TEST_F(MatrixMarket, MissingFileAndUnwritablePlace) {
  EXPECT_THROW(read_matrix_market(directory / "none.mtx"), InputError);
  EXPECT_THROW(write_matrix_market(directory / "none" / "m.mtx", awkward_matrix()), OutputError);
}

}  // namespace
}  // namespace tlsph
