#include "tlsph/scene/edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string text = R"(title = "old"
[body]
spacing = 0.1
[[probe]]
name = "a"
[[probe]]
name = "b"
[[probe]]
name = "c"
)";

TEST(EditSceneText, TakesKeysOutAndPutsOthersIn) {
  const std::string edited =
      edit_scene_text(text, "scene", {"title", "body.spacing"}, {"body.jitter=0.2", "dimension=1"});

  EXPECT_THAT(edited, Not(HasSubstr("title")));
  EXPECT_THAT(edited, Not(HasSubstr("spacing")));
  EXPECT_THAT(edited, HasSubstr("jitter = 0.2"));
  EXPECT_THAT(edited, HasSubstr("dimension = 1"));
}

TEST(EditSceneText, TakesEntriesOfListsOut) {
  const std::string edited = edit_scene_text(text, "scene", {"probe[2]", "probe[0]"}, {});

  EXPECT_THAT(edited, HasSubstr("\"b\""));
  EXPECT_THAT(edited, Not(HasSubstr("\"a\"")));
  EXPECT_THAT(edited, Not(HasSubstr("\"c\"")));
}

TEST(EditSceneText, TakesAKeyOfAnEntryOut) {
  EXPECT_THAT(edit_scene_text(text, "scene", {"probe[1].name"}, {}), Not(HasSubstr("\"b\"")));
}

TEST(EditSceneText, LeavesWhatIsNotThere) {
  EXPECT_EQ(
      edit_scene_text(text, "scene",
                      {"kernel.support", "probe[7]", "title.deeper", "body[0]", "kernel"}, {}),
      edit_scene_text(text, "scene", {}, {}));
}

TEST(EditSceneText, RefusesWhatIsNoPath) {
  EXPECT_THROW((void)edit_scene_text(text, "scene", {"body."}, {}), InputError);
  EXPECT_THROW((void)edit_scene_text("body = ", "scene", {}, {}), InputError);
}

}  // namespace
}  // namespace tlsph
