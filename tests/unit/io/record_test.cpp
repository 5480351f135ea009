#include "tlsph/io/record.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <optional>

namespace tlsph {
namespace {

using testing::ElementsAre;

Record whole() {
  Record record;
  record.set("name", "bar, short");
  record.set("spacing", 0.1);
  record.set("particles", 11L);
  record.set("linear", true);
  record.set("lost_at", std::optional<long>());
  record.set("negative", std::optional<long>(2));
  record.set("growth", std::numeric_limits<double>::quiet_NaN());
  return record;
}

TEST(Record, SaysTheSameInBothFormats) {
  const Record record = whole();

  EXPECT_THAT(record.names(), ElementsAre("name", "spacing", "particles", "linear", "lost_at",
                                          "negative", "growth"));
  EXPECT_THAT(record.cells(),
              ElementsAre("bar, short", "0.10000000000000001", "11", "1", "", "2", ""));
  EXPECT_EQ(record.json().dump(-1),
            R"({"name":"bar, short","spacing":0.1,"particles":11,"linear":true,"lost_at":null,)"
            R"("negative":2,"growth":null})");
}

TEST(Record, AppendsAfterItsOwn) {
  Record record;
  record.set("family", "mirror");

  record.append(whole());

  EXPECT_EQ(record.names().size(), 8);
  EXPECT_EQ(record.names()[0], "family");
  EXPECT_EQ(record.cells()[1], "bar, short");
}

}  // namespace
}  // namespace tlsph
