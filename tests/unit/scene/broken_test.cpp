// Every broken scene of tests/data/broken_scenes.txt is refused with file, line, column, key and
// words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "scenes.hpp"

namespace tlsph {
namespace {

struct BrokenScene {
  std::string name, text, line, key, phrase;
};

void PrintTo(const BrokenScene& scene, std::ostream* stream) {
  *stream << scene.name;
}

using Lines = std::vector<std::string>;

std::string join(const Lines& lines) {
  std::string text;
  for (const auto& line : lines) text += line + '\n';
  return text;
}

/// Takes "- x" lines out of the base and puts "+ y" lines in their place.
Lines edit(Lines base, const Lines& edits) {
  auto at = static_cast<std::ptrdiff_t>(base.size());
  for (const auto& change : edits) {
    const std::string line = change.substr(2);
    if (change[0] == '-') {
      const auto found = std::find(base.begin(), base.end(), line);
      if (found == base.end()) throw std::runtime_error("the base has no line " + line);
      at = base.erase(found) - base.begin();
    } else {
      base.insert(base.begin() + at, line);
      ++at;
    }
  }
  return base;
}

struct SceneTable {
  std::map<std::string, Lines> bases;
  std::vector<BrokenScene> scenes;
};

SceneTable read_table() {
  std::ifstream file(TLSPH_SOURCE_DIR "/tests/data/broken_scenes.txt");
  SceneTable table;
  std::string base;
  Lines edits;
  Lines* target = nullptr;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("== base ", 0) == 0) {
      target = &table.bases[line.substr(8)];
    } else if (line.rfind("== ", 0) == 0) {
      const auto colon = line.rfind(" : ");
      table.scenes.push_back({line.substr(3, colon - 3), "", "", "", ""});
      base = line.substr(colon + 3);
      edits.clear();
      target = &edits;
    } else if (line.rfind("? ", 0) == 0) {
      BrokenScene& scene = table.scenes.back();
      std::istringstream words(line.substr(2));
      words >> scene.line >> scene.key;
      scene.phrase = line.substr(line.find(" | ") + 3);
      scene.text = join(edit(table.bases.at(base), edits));
    } else if (target && !line.empty()) {
      target->push_back(line);
    }
  }
  return table;
}

class Broken : public testing::TestWithParam<BrokenScene> {};

TEST_P(Broken, IsRefusedWithPlaceAndRemedy) {
  const BrokenScene& scene = GetParam();
  std::string message;

  try {
    static_cast<void>(read_scene_text(scene.text, "broken.toml"));
  } catch (const InputError& error) {
    message = error.what();
  }

  const std::string key = scene.key == "-" ? "" : scene.key + ": ";
  std::string pattern;
  for (const char c : key)
    pattern +=
        std::string("[]").find(c) != std::string::npos ? std::string("\\") + c : std::string(1, c);
  EXPECT_THAT(message, testing::MatchesRegex("broken\\.toml:" + scene.line + ":[0-9]+: " + pattern +
                                             "(.|\n)*"));
  EXPECT_THAT(message, testing::HasSubstr(scene.phrase));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Broken, testing::ValuesIn(read_table().scenes),
                         [](const auto& scene) {
                           std::string name = scene.param.name;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); },
                               '_');
                           return name;
                         });

TEST(BrokenScenes, AreManyAndStartFromSoundOnes) {
  const SceneTable table = read_table();

  EXPECT_GE(table.scenes.size(), 40U);
  for (const auto& [name, lines] : table.bases)
    EXPECT_NO_THROW(static_cast<void>(read_scene_text(join(lines), name))) << name;
}

struct BadText {
  std::string text, message;
};

void PrintTo(const BadText& bad, std::ostream* stream) {
  *stream << bad.message;
}

class NotAScene : public testing::TestWithParam<BadText> {};

TEST_P(NotAScene, IsRefused) {
  std::string message;

  try {
    static_cast<void>(read_scene_text(GetParam().text, "x.toml"));
  } catch (const InputError& error) {
    message = error.what();
  }

  EXPECT_THAT(message, testing::StartsWith(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Texts, NotAScene,
    testing::Values(BadText{"", "x.toml:1:1: empty"}, BadText{"# nothing\n", "x.toml:1:1: empty"},
                    BadText{std::string("a = 1\nb = \0", 11), "x.toml:2:5: a binary file"},
                    BadText{"a = \"\xff\"", "x.toml:1:6: byte 0xff is not UTF-8"},
                    BadText{"a = \"\xc0\xaf\"", "x.toml:1:6: byte 0xc0 is not UTF-8"},
                    BadText{"a = \"\xed\xa0\x80\"", "x.toml:1:6: byte 0xed is not UTF-8"},
                    BadText{"a = \"\xf5\x80\x80\x80\"", "x.toml:1:6: byte 0xf5 is not UTF-8"},
                    BadText{"a = \"é", "x.toml:1:"}));

struct BadFile {
  std::string path, message;
};

void PrintTo(const BadFile& bad, std::ostream* stream) {
  *stream << bad.message;
}

class Unreadable : public testing::TestWithParam<BadFile> {};

TEST_P(Unreadable, IsRefused) {
  try {
    static_cast<void>(read_scene(GetParam().path));
    FAIL() << "read " << GetParam().path;
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().path + ": " + GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Unreadable,
                         testing::Values(BadFile{"no/such/scene.toml", "no such file"},
                                         BadFile{TLSPH_SOURCE_DIR, "a directory, not a scene file"},
                                         BadFile{"/dev/zero",
                                                 "larger than 16 MiB: not a scene file"}));

}  // namespace
}  // namespace tlsph
