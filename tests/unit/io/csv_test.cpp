#include "tlsph/io/csv.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <bit>
#include <csignal>
#include <cstdint>
#include <limits>

#include "support.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using test::message_of;
using testing::HasSubstr;

class Csv : public test::TemporaryDirectory {
 protected:
  std::filesystem::path path = directory / "probes.csv";
};

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

TEST_F(Csv, SeventeenDigitsBringBackEveryBit) {
  const auto values = test::awkward_doubles(3000);

  {
    CsvWriter csv(path, {"a", "b", "c"});
    for (std::size_t i = 0; i < values.size(); i += 3) csv.row(std::span(values).subspan(i, 3));
    EXPECT_EQ(csv.rows().count, 1000u);
    csv.close();
  }

  const auto lines = lines_of(path);
  ASSERT_EQ(lines.size(), 1001u);
  EXPECT_EQ(lines[0], "a,b,c");
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::string line = lines[1 + i / 3];
    for (std::size_t skip = i % 3; skip > 0; --skip) line.erase(0, line.find(',') + 1);
    const double read = std::strtod(line.c_str(), nullptr);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(values[i])) << line;
  }
}

TEST_F(Csv, WidestRowsFillTheBufferExactlyOften) {
  // More columns than the buffer was first made for, each as wide as a double can be.
  const std::vector<double> row(5000, -std::numeric_limits<double>::denorm_min() * 3);
  std::vector<std::string> columns(row.size(), "c");

  CsvWriter csv(path, columns);
  for (int i = 0; i < 5; ++i) csv.row(row);
  csv.close();

  const auto lines = lines_of(path);
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(std::ranges::count(lines[5], ','), 4999);
}

TEST_F(Csv, NamesAreQuotedWhereNeeded) {
  CsvWriter csv(path, {"name", "say \"hi\""});
  csv.close();

  EXPECT_EQ(test::read_text(path), "name,\"say \"\"hi\"\"\"\n");
}

TEST(CsvLine, QuotesTextsWhereNeeded) {
  EXPECT_EQ(csv_line(std::vector<std::string>{"plain", "", "a,b", "two\nlines"}),
            "plain,,\"a,b\",\"two\nlines\"\n");
}

TEST(CsvNumber, BringsBackEveryBitAndIsEmptyForNone) {
  for (const double value : test::awkward_doubles(1000)) {
    const std::string text = csv_number(value);
    if (!std::isfinite(value)) {
      EXPECT_EQ(text, "");
      continue;
    }
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(value));
  }
}

TEST_F(Csv, FlushedRowsOutliveAKilledProgram) {
  const int status = test::in_child([&] {
    auto* csv = new CsvWriter(path, {"t"});
    for (double t : {0.5, 1.5}) csv->row(std::span(&t, 1));
    csv->flush();
    ::raise(SIGKILL);
  });

  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(test::read_text(path), "t\n0.5\n1.5\n");
}

class CsvResume : public Csv, public testing::WithParamInterface<std::size_t> {};

TEST_P(CsvResume, GoesOnAsIfNeverStopped) {
  constexpr std::size_t total = 20000;  // several buffers
  const auto write = [](CsvWriter& csv, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const double row[] = {static_cast<double>(i) / 7.0, static_cast<double>(i)};
      csv.row(std::span<const double>(row));
    }
  };
  CsvWriter whole(directory / "whole.csv", {"t", "x"});
  write(whole, 0, total);
  whole.close();
  CsvWriter first(path, {"t", "x"});
  write(first, 0, GetParam());
  const CsvRows rows = first.rows();
  write(first, GetParam(), total);
  first.close();
  std::ofstream(path, std::ios::app) << "0.123";  // a line cut short by the end of the program

  CsvWriter second = CsvWriter::resume(path, {"t", "x"}, rows);
  EXPECT_EQ(second.rows().count, GetParam());
  write(second, GetParam(), total);
  second.close();

  EXPECT_TRUE(test::read_text(path) == test::read_text(directory / "whole.csv"));
}

INSTANTIATE_TEST_SUITE_P(Rows, CsvResume, testing::Values(0, 1, 777, 19999, 20000));

TEST_F(Csv, ResumeRefusesOtherHeadersAndMissingRows) {
  CsvWriter csv(path, {"t", "x"});
  csv.row(std::vector<double>{1, 2});
  csv.close();

  EXPECT_THROW(CsvWriter::resume(directory / "none.csv", {"t"}, {}), InputError);
  EXPECT_THROW(CsvWriter::resume(path, {"t"}, {}), InputError);
  EXPECT_THROW(CsvWriter::resume(path, {"t", "y"}, {}), InputError);
  const auto message = message_of<InputError>([&] {
    CsvWriter::resume(path, {"t", "x"}, {2, CheckSum()});
  });

  EXPECT_THAT(message, HasSubstr(path.string()));
  EXPECT_THAT(message, HasSubstr("2 rows are needed to go on, 1 are there"));
  EXPECT_EQ(test::read_text(path), "t,x\n1,2\n");
}

TEST_F(Csv, ResumeRefusesRowsThatAreNotThoseWritten) {
  CsvWriter csv(path, {"t", "x"});
  csv.row(std::vector<double>{1, 2});
  csv.row(std::vector<double>{3, 4});
  const CsvRows rows = csv.rows();
  csv.close();
  std::ofstream(path) << "t,x\n1,2\n3,5\n6,7\n";

  const auto message = message_of<InputError>([&] { CsvWriter::check(path, {"t", "x"}, rows); });

  EXPECT_THAT(message, HasSubstr("damaged"));
  EXPECT_EQ(message, message_of<InputError>([&] { CsvWriter::resume(path, {"t", "x"}, rows); }));
  EXPECT_EQ(test::read_text(path), "t,x\n1,2\n3,5\n6,7\n");
}

TEST_F(Csv, FullDiskIsAnOutputError) {
  EXPECT_THROW(CsvWriter("/dev/full", {"t"}), OutputError);
  const int status = test::in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    CsvWriter csv(path, {"t"});
    for (double t = 0; t < 1000; ++t) csv.row(std::span(&t, 1));
    const auto message = message_of<OutputError>([&] { csv.close(); });
    ::_exit(message.find("probes.csv") != std::string::npos ? 0 : 2);
  });

  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace tlsph
