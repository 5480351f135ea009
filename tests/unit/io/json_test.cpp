#include "tlsph/io/json.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "support.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using test::message_of;
using testing::HasSubstr;

class JsonFile : public test::TemporaryDirectory {};

TEST(Json, KeepsTheOrderAndNestsByDots) {
  Json json;
  json.set("zeta", 1);
  json.set("energy.kinetic", 0.5);
  json.set("alpha", "text");
  json.set("energy.elastic", 2.0);
  json.set("flag", true);
  json.set("failure", nullptr);
  json.set("list", std::vector<double>{1.0, 2.5});

  EXPECT_EQ(json.dump(-1),
            R"({"zeta":1,"energy":{"kinetic":0.5,"elastic":2.0},"alpha":"text","flag":true,)"
            R"("failure":null,"list":[1.0,2.5]})");
}

TEST(Json, DoublesComeBackBitForBit) {
  const auto values = test::awkward_doubles(5000);
  Json json;
  json.set("values", values);

  const auto read = Json::parse(json.dump()).numbers("values");

  ASSERT_EQ(read.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read[i]), std::bit_cast<std::uint64_t>(values[i]));
}

TEST(Json, NothingIsNull) {
  Json json;
  json.set("known", std::optional<double>(0.5));
  json.set("unknown", std::optional<double>());
  json.set("text", Json::text_or_null("said"));
  json.set("silent", Json::text_or_null(""));

  EXPECT_EQ(json.dump(-1), R"({"known":0.5,"unknown":null,"text":"said","silent":null})");
}

TEST(Json, WhatIsNoNumberBecomesNull) {
  Json json;
  json.set("nan", std::numeric_limits<double>::quiet_NaN());
  json.set("infinite", -std::numeric_limits<double>::infinity());
  json.set("list", std::vector<double>{1.0, std::numeric_limits<double>::quiet_NaN()});

  EXPECT_EQ(json.dump(-1), R"({"nan":null,"infinite":null,"list":[1.0,null]})");
}

TEST(Json, IntegersKeepAllDigitsAndTextsTheirQuotes) {
  Json json;
  json.set("large", std::int64_t{9007199254740993});  // not a double
  json.set("size", std::size_t{12});
  json.set("text", std::string("a \"b\"\n\\ é"));

  const Json read = Json::parse(json.dump());

  EXPECT_EQ(read.integer("large"), 9007199254740993);
  EXPECT_EQ(read.integer("size"), 12);
  EXPECT_EQ(read.text("text"), "a \"b\"\n\\ é");
}

TEST(Json, IsMadeOfAValueAndGivesItBack) {
  using testing::VariantWith;

  EXPECT_THAT(Json(true).scalar(), VariantWith<bool>(true));
  EXPECT_THAT(Json(7).scalar(), VariantWith<std::int64_t>(7));
  EXPECT_THAT(Json(0.5).scalar(), VariantWith<double>(0.5));
  EXPECT_THAT(Json("text").scalar(), VariantWith<std::string>("text"));
  for (const Json& none : {Json(), Json(nullptr), Json(std::numeric_limits<double>::infinity()),
                           Json(std::vector<double>{1.0}), Json::text_or_null("")})
    EXPECT_THAT(none.scalar(), VariantWith<std::monostate>(std::monostate())) << none.dump();
  EXPECT_EQ(Json(std::vector<Json>{1, "two", std::optional<double>()}).dump(-1),
            "[1,\"two\",null]");
}

TEST(Json, TextThatIsNotUtf8CostsNoDocument) {
  Json json;
  json.set("path", std::string("a\xff"));

  EXPECT_EQ(Json::parse(json.dump()).text("path"), "a\xEF\xBF\xBD");
}

TEST(Json, ListsOfObjectsMakeTables) {
  Json table, row;
  std::vector<Json> both;
  for (const int n : {1, 2}) {
    row.set("n", n);
    both.push_back(row);
  }
  table.set("rows", both);
  table.set("copy", table);

  const auto rows = table.list("copy.rows");

  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].integer("n"), 1);
  EXPECT_EQ(rows[1].integer("n"), 2);
}

TEST(Json, CopiesAreDeep) {
  Json a;
  a.set("x", 1);
  Json b = a;
  b.set("x", 2);
  Json c;
  c = a;
  c.set("x", 3);

  EXPECT_EQ(a.integer("x"), 1);
  EXPECT_EQ(b.integer("x"), 2);
}

TEST(Json, AnswersWhatIsThereAndNamesWhatIsNot) {
  const Json json = Json::parse(R"({"a": {"b": 1.5, "c": null}, "s": "x"})");

  EXPECT_TRUE(json.has("a.b"));
  EXPECT_FALSE(json.has("a.b.c"));
  EXPECT_TRUE(json.is_null("a.c"));
  EXPECT_FALSE(json.is_null("a.b"));
  EXPECT_DOUBLE_EQ(json.number("a.b"), 1.5);
  EXPECT_THAT(message_of<InputError>([&] { (void)json.number("a.x"); }), HasSubstr("a.x"));
  EXPECT_THROW((void)json.number("s"), InputError);
  EXPECT_THROW((void)json.integer("a.b"), InputError);
  EXPECT_THROW((void)json.text("a"), InputError);
  EXPECT_THROW((void)json.list("a"), InputError);
  EXPECT_THAT(message_of<InputError>([] { Json::parse("{\n 1}", "f.json"); }), HasSubstr("f.json"));
}

TEST_F(JsonFile, WritesAndReadsAFile) {
  Json json;
  json.set("a", 1);
  json.write(directory / "summary.json");

  EXPECT_EQ(test::read_text(directory / "summary.json"), "{\n  \"a\": 1\n}\n");
  EXPECT_EQ(Json::read(directory / "summary.json").integer("a"), 1);
  EXPECT_THROW(Json::read(directory / "none.json"), InputError);
  EXPECT_THROW(json.write(directory / "none" / "summary.json"), OutputError);
}

}  // namespace
}  // namespace tlsph
