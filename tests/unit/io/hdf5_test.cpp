#include "tlsph/io/hdf5.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <bit>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "hdf5_reading.hpp"
#include "support.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using test::message_of;
using testing::ElementsAre;
using testing::HasSubstr;

class Hdf5 : public test::TemporaryDirectory {
 protected:
  std::filesystem::path path = directory / "file.h5";
};

TEST_F(Hdf5, ArraysComeBackBitForBitWithTheirShapes) {
  auto values = test::awkward_doubles(60);
  values[7] = std::bit_cast<double>(0x7FF8000000000123ULL);  // a NaN with something to say
  const std::vector<std::int32_t> small{1, -2, 3};
  const std::vector<std::int64_t> large{std::int64_t{1} << 62, -1};
  Hdf5File file = Hdf5File::create(path);
  file.write("/a/b/doubles", values, {3, 4, 5});
  file.write("/small", small, {3});
  file.write("/large", large, {2, 1});
  file.write("/none", std::span<const double>(), {0, 2});
  file.close();

  const Hdf5File read = Hdf5File::open_read_only(path);
  const auto doubles = read.read_doubles("/a/b/doubles");

  EXPECT_THAT(doubles.shape, ElementsAre(3, 4, 5));
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(doubles.values[i]),
              std::bit_cast<std::uint64_t>(values[i]));
  EXPECT_THAT(test::read_integers(read, "/small"), ElementsAre(1, -2, 3));
  EXPECT_THAT(test::read_integers(read, "/large"), ElementsAre(std::int64_t{1} << 62, -1));
  EXPECT_THAT(read.read_doubles("/none").shape, ElementsAre(0, 2));
  EXPECT_THAT(read.names("/"), ElementsAre("a", "large", "none", "small"));
}

TEST_F(Hdf5, Attributes) {
  const std::string long_text(100000, 'x');  // above what an attribute holds by itself
  Hdf5File file = Hdf5File::create(path);
  file.make_group("/scene");
  file.set_attribute("/scene", "text", long_text);
  file.set_attribute("/scene", "empty", "");
  file.set_attribute("/scene", "count", 3);
  file.set_attribute("/scene", "count", std::int64_t{-5});  // replaces
  file.set_attribute("/scene", "names", std::vector<std::string>{"é", "", "b"});
  file.write("/length", std::vector<double>{1}, {1}, "m");
  file.close();

  const Hdf5File read = Hdf5File::open_read_only(path);

  EXPECT_THAT(test::texts_attribute(read, "/scene", "text"), ElementsAre(long_text));
  EXPECT_THAT(test::texts_attribute(read, "/scene", "empty"), ElementsAre(""));
  EXPECT_EQ(test::integer_attribute(read, "/scene", "count"), -5);
  EXPECT_THAT(test::texts_attribute(read, "/scene", "names"), ElementsAre("é", "", "b"));
  EXPECT_THAT(test::texts_attribute(read, "/length", "unit"), ElementsAre("m"));
  EXPECT_TRUE(read.exists("/scene"));
  EXPECT_FALSE(read.exists("/scene/deeper/still"));
}

// Row shape, chunk rows, rows at a time: rows smaller than a chunk, as large, larger, and empty
// ones.
class Hdf5Series
    : public Hdf5,
      public testing::WithParamInterface<std::tuple<Extents, std::size_t, std::size_t>> {
 protected:
  Extents row_shape = std::get<0>(GetParam());
  std::size_t chunk_rows = std::get<1>(GetParam()), at_once = std::get<2>(GetParam());
  std::size_t row_size =
      std::accumulate(row_shape.begin(), row_shape.end(), std::size_t{1}, std::multiplies<>());

  [[nodiscard]] std::vector<double> numbers(std::size_t first, std::size_t rows) const {
    std::vector<double> values(rows * row_size);
    std::iota(values.begin(), values.end(), static_cast<double>(first * row_size));
    return values;
  }
  void append(Hdf5File& file, std::size_t first, std::size_t last) const {
    for (std::size_t row = first; row < last; row += at_once)
      file.append("/s", numbers(row, std::min(at_once, last - row)));
  }
};

TEST_P(Hdf5Series, GrowsIsReadAndGrowsAgain) {
  Hdf5File file = Hdf5File::create(path);
  file.create_series("/s", row_shape, chunk_rows);
  append(file, 0, 5);
  EXPECT_EQ(file.read_doubles("/s").values, numbers(0, 5));
  append(file, 5, 11);
  EXPECT_EQ(file.rows("/s"), 11u);
  file.close();

  const Hdf5File read = Hdf5File::open_read_only(path);
  Extents shape{11};
  shape.insert(shape.end(), row_shape.begin(), row_shape.end());
  EXPECT_EQ(read.shape("/s"), shape);
  EXPECT_EQ(read.read_doubles("/s").values, numbers(0, 11));
  EXPECT_EQ(read.read_rows("/s", 4, 3).values, numbers(4, 3));
  EXPECT_THROW((void)read.read_rows("/s", 9, 3), InputError);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Hdf5Series,
                         testing::Values(std::tuple{Extents{}, 0, 1}, std::tuple{Extents{}, 2, 1},
                                         std::tuple{Extents{}, 4, 3}, std::tuple{Extents{3}, 0, 1},
                                         std::tuple{Extents{5, 2}, 3, 2},
                                         std::tuple{Extents{5, 2}, 1, 1},
                                         std::tuple{Extents{70000, 2}, 0, 1},  // rows above 1 MiB
                                         std::tuple{Extents{150001, 4}, 0, 1},
                                         std::tuple{Extents{0, 2}, 0, 1}));

TEST_F(Hdf5, AnyoneMayReadWhileItIsWritten) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t writer = ::fork();
  if (writer == 0) {
    Hdf5File file = Hdf5File::create(path);
    file.create_series("/s", {2});
    file.append("/s", std::vector<double>{1, 2});
    file.flush();
    file.append("/s", std::vector<double>{3, 4});
    const bool told = ::write(ready[1], "x", 1) == 1;
    ::pause();
    ::_exit(told ? 0 : 1);
  }
  char told = 0;
  ASSERT_EQ(::read(ready[0], &told, 1), 1);

  EXPECT_THAT(Hdf5File::open_read_only(path).read_doubles("/s").values, ElementsAre(1, 2));

  ::kill(writer, SIGKILL);
  ::waitpid(writer, nullptr, 0);
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST_F(Hdf5, FailuresNameFileItemAndReason) {
  const auto create = message_of<OutputError>([&] { Hdf5File::create(directory / "no" / "f.h5"); });
  EXPECT_THAT(create, HasSubstr((directory / "no" / "f.h5").string()));
  EXPECT_THAT(create, HasSubstr("No such file or directory"));
  EXPECT_THAT(message_of<InputError>([&] { Hdf5File::open_read_only(path); }),
              HasSubstr("No such file"));
  test::write_text(path, "not HDF5");
  EXPECT_THAT(message_of<InputError>([&] { Hdf5File::open_read_only(path); }),
              HasSubstr(path.string()));

  Hdf5File file = Hdf5File::create(path);
  file.write("/a", std::vector<double>{1}, {1});
  const auto twice =
      message_of<OutputError>([&] { file.write("/a", std::vector<double>{1}, {1}); });
  EXPECT_THAT(twice, HasSubstr(path.string() + ":/a: cannot write this data set: "));
  EXPECT_THAT(message_of<OutputError>([&] { file.set_attribute("/b", "unit", "m"); }),
              HasSubstr("/b@unit"));
  EXPECT_THAT(message_of<InputError>([&] { (void)file.read_doubles("/b"); }), HasSubstr(":/b"));
}

TEST_F(Hdf5, ReadOnlyFilesRefuseToBeWritten) {
  Hdf5File::create(path).close();
  Hdf5File file = Hdf5File::open_read_only(path);

  EXPECT_THROW(file.write("/a", std::vector<double>{1}, {1}), OutputError);
}

TEST_F(Hdf5, TornFileIsRefused) {
  Hdf5File file = Hdf5File::create(path);
  file.write("/a", std::vector<double>(10000, 1.0), {10000});
  file.close();
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);

  EXPECT_THROW(Hdf5File::open_read_only(path), InputError);
}

TEST_F(Hdf5, FullDiskIsAnOutputErrorAndTheProgramEndsInPeace) {
  const int status = test::in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{300000, 300000};
    Hdf5File file = Hdf5File::create(path);
    file.create_series("/s", {1000});
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto message = message_of<OutputError>([&] {
      for (int row = 0; row < 1000; ++row) {
        file.append("/s", std::vector<double>(1000, 1.0));
        file.flush();
      }
    });
    const bool named = message.find("file.h5") != std::string::npos &&
                       message.find("File too large") != std::string::npos;
    const bool closed = message_of<OutputError>([&] { file.close(); }).empty();
    std::exit(!named ? 2 : closed ? 3 : 0);  // as main does, HDF5's own clean-up included
  });

  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace tlsph
