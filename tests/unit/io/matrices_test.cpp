#include "tlsph/io/matrices.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cstdint>
#include <sstream>

#include "hdf5_reading.hpp"
#include "support.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/cloud.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;

class Matrices : public test::TemporaryDirectory {
 protected:
  std::filesystem::path path = directory / "m.mtx", operators = directory / "operators.h5";
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

TEST_F(Matrices, TextComesBackBitForBitWithItsStoredZeros) {
  const SparseMatrix written = awkward_matrix();

  write_matrix_market(path, written);

  std::istringstream text(test::read_text(path));
  std::string header;
  std::getline(text, header);
  Index rows = 0, columns = 0, entries = 0;
  text >> rows >> columns >> entries;
  ASSERT_EQ(rows, 7);
  ASSERT_EQ(columns, 11);
  ASSERT_EQ(entries, written.nonZeros());
  for (Index row = 0; row < 7; ++row)
    for (SparseMatrix::InnerIterator entry(written, row); entry; ++entry) {
      Index found_row = 0, found_column = 0;
      std::string value;
      text >> found_row >> found_column >> value;
      ASSERT_EQ(found_row, row + 1);
      ASSERT_EQ(found_column, entry.col() + 1);
      ASSERT_EQ(std::bit_cast<std::uint64_t>(std::strtod(value.c_str(), nullptr)),
                std::bit_cast<std::uint64_t>(entry.value()));
    }
}

TEST_F(Matrices, TextIsThatOfTheFormat) {
  SparseMatrix matrix(2, 3);
  matrix.insert(0, 2) = 0.1;
  matrix.insert(1, 0) = -3;

  write_matrix_market(path, matrix);

  EXPECT_EQ(test::read_text(path),
            "%%MatrixMarket matrix coordinate real general\n2 3 2\n"
            "1 3 0.10000000000000001\n2 1 -3\n");
}

TEST_F(Matrices, EmptyOnesAreText) {
  write_matrix_market(path, SparseMatrix(0, 4));
  EXPECT_THAT(test::read_text(path), testing::EndsWith("general\n0 4 0\n"));
  write_matrix_market(path, SparseMatrix(3, 2));
  EXPECT_THAT(test::read_text(path), testing::EndsWith("general\n3 2 0\n"));
}

TEST_F(Matrices, UnwritablePlace) {
  EXPECT_THROW(write_matrix_market(directory / "none" / "m.mtx", awkward_matrix()), OutputError);
}

TEST_F(Matrices, CompressedRowsAreAsScipyTakesThem) {
  SparseMatrix matrix(3, 2);
  matrix.insert(0, 1) = 2.0;
  matrix.insert(2, 0) = -1.0;
  matrix.insert(2, 1) = 0.1;
  Hdf5File file = Hdf5File::create(operators);
  write_compressed_rows(file, "G_x", matrix);  // not compressed
  write_compressed_rows(file, "none", SparseMatrix(3, 0));
  file.close();

  const Hdf5File read = Hdf5File::open_read_only(operators);

  EXPECT_THAT(test::texts_attribute(read, "/G_x", "format"), ElementsAre("csr"));
  EXPECT_THAT(test::read_integers(read, "/G_x/indptr"), ElementsAre(0, 1, 1, 3));
  EXPECT_THAT(test::read_integers(read, "/G_x/indices"), ElementsAre(1, 0, 1));
  EXPECT_THAT(read.read_doubles("/G_x/data").values, ElementsAre(2.0, -1.0, 0.1));
  EXPECT_THAT(test::read_integers(read, "/G_x/shape"), ElementsAre(3, 2));
  EXPECT_THAT(test::read_integers(read, "/none/indptr"), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(test::read_integers(read, "/none/shape"), ElementsAre(3, 0));
}

TEST_F(Matrices, ParticlesAndPointsStandBeside) {
  const std::vector<double> X{0, 0, 1, 0, 1, 1}, V{0.5, 0.25, 0.25}, point_X{0.5, 0.5}, point_V{1};
  const std::vector<std::int64_t> tag{1, 0, 2};
  Hdf5File written = Hdf5File::create(operators);
  write_cloud(written, "/particles", {2, X, V, tag, {"left", "right"}});
  write_cloud(written, "/points", {2, point_X, point_V, {}, {}});
  written.close();

  const Hdf5File file = Hdf5File::open_read_only(operators);

  EXPECT_THAT(file.read_doubles("/particles/X").shape, ElementsAre(3, 2));
  EXPECT_EQ(file.read_doubles("/particles/X").values, X);
  EXPECT_EQ(file.read_doubles("/particles/V").values, V);
  EXPECT_THAT(test::texts_attribute(file, "/particles/V", "unit"), ElementsAre("m^2"));
  EXPECT_EQ(test::read_integers(file, "/particles/tag"), tag);
  EXPECT_THAT(test::texts_attribute(file, "/particles/tag", "patches"),
              ElementsAre("left", "right"));
  EXPECT_EQ(file.read_doubles("/points/X").values, point_X);
  EXPECT_FALSE(file.exists("/points/tag"));
}

}  // namespace
}  // namespace tlsph
