#include "tlsph/io/points_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support.hpp"

namespace tlsph {
namespace {

using test::message_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PointsFile : public test::TemporaryDirectory {
 protected:
  PointsTable read(const std::string& text, std::size_t dimension = 2) {
    std::ofstream(directory / "points.csv") << text;
    return read_points(directory / "points.csv", dimension);
  }
};

TEST_F(PointsFile, IsReadInAnyOrderOfColumns) {
  const PointsTable table =
      read("# by hand\nvolume, y, tag, x\n0.5, 2, left  top, 1\n\n1e-3,-4,,+3.25\r\n");

  EXPECT_EQ(table.size(), 2u);
  EXPECT_THAT(table.X, ElementsAre(1.0, 2.0, 3.25, -4.0));
  EXPECT_THAT(table.V, ElementsAre(0.5, 1e-3));
  EXPECT_THAT(table.tags, ElementsAre(ElementsAre("left", "top"), IsEmpty()));
  EXPECT_THAT(table.line, ElementsAre(3, 5));
}

TEST_F(PointsFile, NeedsNeitherVolumesNorTags) {
  const PointsTable table = read("\xEF\xBB\xBFx\n0\n1\n", 1);

  EXPECT_THAT(table.X, ElementsAre(0.0, 1.0));
  EXPECT_THAT(table.V, IsEmpty());
  EXPECT_THAT(table.tags, IsEmpty());
}

TEST_F(PointsFile, IsRefusedWithLineAndColumn) {
  struct Case {
    const char* text;
    const char* message;
  };
  for (const auto& [text, message] : {
           Case{"x,z\n0,0\n", "points.csv:1:3: unknown column \"z\"; allowed: x, y, volume, tag"},
           Case{"x,volume\n0,0\n", "points.csv:1:1: the column \"y\" is missing"},
           Case{"x,y,x\n0,0,0\n", "points.csv:1:5: the column \"x\" is there twice"},
           Case{"x,y\n0,0\n1\n", "points.csv:3:1: 1 cells where the header has 2"},
           Case{"x,y\n0, nought\n", "points.csv:2:4: \"nought\" is no finite number"},
           Case{"x,y\n0,inf\n", "points.csv:2:3: \"inf\" is no finite number"},
           Case{"x,y\n0,\n", "points.csv:2:3: \"\" is no finite number"},
           Case{"x,y\n", "points.csv:1:1: no points below the header"},
           Case{"", "points.csv:1:1: empty"},
       })
    EXPECT_THAT(message_of<InputError>([&, text = text] { (void)read(text); }), HasSubstr(message))
        << text;
  EXPECT_THAT(message_of<InputError>([&] { (void)read_points(directory / "no.csv", 2); }),
              HasSubstr("no.csv: no such file"));
}

}  // namespace
}  // namespace tlsph
