#include "tlsph/io/table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <limits>
#include <optional>

namespace tlsph {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Bar {
  std::string name;
  double spacing = 0.1;
  long particles = 11;
  bool linear = true;
  std::optional<long> lost_at = std::nullopt;
  double growth = nan;
  std::vector<double> times = {0.5, 2.0};
  [[nodiscard]] double length() const { return spacing * 10.0; }
};

const std::vector<Bar> bars = {{.name = "bar, short"},
                               {.name = "a \"long\" one", .particles = 1'000'000, .lost_at = 2}};

TEST(Table, HasTheSameValuesInBothKindsOfFiles) {
  const Table<Bar> table = {{"name", &Bar::name},           {"spacing", &Bar::spacing},
                            {"particles", &Bar::particles}, {"linear", &Bar::linear},
                            {"lost_at", &Bar::lost_at},     {"growth", &Bar::growth},
                            {"length", &Bar::length},       {"times", &Bar::times}};

  EXPECT_EQ(table.csv(bars),
            "name,spacing,particles,linear,lost_at,growth,length,times\n"
            "\"bar, short\",0.10000000000000001,11,1,,,1,\n"
            "\"a \"\"long\"\" one\",0.10000000000000001,1000000,1,2,,1,\n");
  EXPECT_EQ(table.json(bars)[0].dump(-1),
            R"({"name":"bar, short","spacing":0.1,"particles":11,"linear":true,"lost_at":null,)"
            R"("growth":null,"length":1.0,"times":[0.5,2.0]})");
  EXPECT_EQ(table.json(bars)[1].integer("lost_at"), 2);
}

TEST(Table, HasColumnsOfOneKindOfOutputOnly) {
  const Table<Bar> table = {{"count", &Bar::particles, Medium::csv},
                            {"size.particles", &Bar::particles, Medium::json},
                            {"", &Bar::particles, {"number", ">8"}}};

  EXPECT_EQ(table.csv(bars), "count\n11\n1000000\n");
  EXPECT_EQ(table.json(bars)[0].dump(-1), R"({"size":{"particles":11}})");
  EXPECT_EQ(table.text(bars), "  number\n      11\n 1000000\n");
}

TEST(Table, AlignsColumnsByTheirCodePointsAndWidensThem) {
  const auto percent = [](double value) { return fmt::format("{:.0f} %", 100.0 * value); };
  const Table<Bar> table = {{"", &Bar::name, {"name", "<6"}},
                            {"", &Bar::spacing, {"Δ [m]", " >7.2e"}},
                            {"", &Bar::growth, {"growth", " >.3f"}},
                            {"", &Bar::spacing, {"of 1", "  >4", percent}},
                            {"", [](const Bar&) { return "–"; }, {"note", "  <6"}}};

  EXPECT_EQ(table.text(bars),
            "name            Δ [m] growth  of 1  note\n"
            "bar, short   1.00e-01      -  10 %  –\n"
            "a \"long\" one 1.00e-01      -  10 %  –\n");
}

TEST(Table, IsATableInMarkdown) {
  const Table<Bar> table = {{"", [](const Bar&) { return "a|b"; }, {"text", "<"}},
                            {"", &Bar::spacing, {"spacing", "  >.2f"}}};

  EXPECT_EQ(table.markdown(bars),
            "| text | spacing |\n|---|---:|\n| a\\|b | 0.10 |\n| a\\|b | 0.10 |\n");
}

struct Beam {
  std::string family;
  Bar bar;
};

TEST(Table, TakesTheColumnsOfAPart) {
  const Table<Bar> part = {{"name", &Bar::name}, {"particles", &Bar::particles}};
  const Table<Beam> table = Table<Beam>{{"family", &Beam::family}} + part.of(&Beam::bar);

  EXPECT_EQ(table.csv({{"mirror", bars[0]}}), "family,name,particles\nmirror,\"bar, short\",11\n");
}

TEST(Table, HoldsTablesAndListsOfTexts) {
  const Table<Bar> inner = {{"particles", &Bar::particles}};
  const Table<Beam> table = {{"bars", [&](const Beam& beam) { return inner.json({beam.bar}); }},
                             {"names", [](const Beam& beam) {
                                return std::vector{beam.family, beam.bar.name};
                              }}};

  EXPECT_EQ(table.json({{"mirror", bars[0]}})[0].dump(-1),
            R"({"bars":[{"particles":11}],"names":["mirror","bar, short"]})");
}

TEST(Table, IsItsHeadWithoutRows) {
  const Table<Bar> table = {{"name", &Bar::name, {"name", "<"}}};

  EXPECT_EQ(table.csv({}), "name\n");
  EXPECT_TRUE(table.json({}).empty());
  EXPECT_EQ(table.text({}), "name\n");
}

}  // namespace
}  // namespace tlsph
