#include "tlsph/io/xdmf.hpp"

#include <fmt/format.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <regex>
#include <sstream>

#include "run_fixture.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using test::message_of;
using testing::HasSubstr;

class Xdmf : public test::SmallRun {
 protected:
  static constexpr std::size_t frames = 3;
  std::filesystem::path views = directory / "run.xdmf.h5";

  std::string document_of_a_run(std::size_t dimension, bool cells = false) {
    const RunLayout shape = cells ? layout_of_cells(dimension) : layout(dimension);
    RunFile run = RunFile(path, shape, cells ? start_of_cells(dimension) : start(dimension));
    for (std::size_t frame = 0; frame < frames; ++frame) write_frame(run, frame, dimension);
    run.close();
    write_views(views, shape, frames + 2);  // more than there are frames
    return xdmf_document(shape, run.frame_times(), "run.h5", "run.xdmf.h5");
  }
};

std::vector<std::smatch> matches(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  return {std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()};
}

std::vector<std::size_t> numbers(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::size_t>(stream), {}};
}

TEST_F(Xdmf, IsWellFormed) {
  const std::string text = document_of_a_run(2);
  std::vector<std::string> open;

  for (const auto& tag : matches(text, "<(/?)([A-Za-z]+)[^<>]*?(/?)>")) {
    if (tag[3].length() > 0) continue;
    if (tag[1].length() == 0) {
      open.push_back(tag[2]);
    } else {
      ASSERT_FALSE(open.empty());
      ASSERT_EQ(open.back(), tag[2]);
      open.pop_back();
    }
  }

  EXPECT_TRUE(open.empty());
  EXPECT_EQ(text.find("<?xml"), 0u);
}

/// Dimension, and whether the points are cells.
struct Kind {
  std::size_t dimension;
  bool cells;
};

void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.dimension << "D" << (kind.cells ? " cells" : " points");
}

class XdmfOfKinds : public Xdmf, public testing::WithParamInterface<Kind> {};

TEST_P(XdmfOfKinds, EveryWholeDataSetIsThereInItsShape) {
  const std::string text = document_of_a_run(GetParam().dimension, GetParam().cells);
  const Hdf5File file = Hdf5File::open_read_only(path);

  const auto items = matches(text, R"re(Dimensions="([0-9 ]+)">run\.h5:([^<|]+)<)re");

  ASSERT_FALSE(items.empty());
  for (const auto& item : items) EXPECT_EQ(file.shape(item[2]), numbers(item[1])) << item[2];
}

TEST_P(XdmfOfKinds, EveryAttributeIsAWholeDataSetOfTheRightFrame) {
  const std::size_t d = GetParam().dimension;
  const std::string text = document_of_a_run(d, GetParam().cells);
  const Hdf5File file = Hdf5File::open_read_only(views);
  const RunLayout shape = layout(d);

  const auto found = matches(
      text,
      R"re(<Attribute Name="([a-z0-9_]+)" AttributeType="([A-Za-z]+)"[^>]*><DataItem[^>]* Dimensions="([0-9 ]+)">run\.xdmf\.h5:/([0-9]+)/([a-z0-9_]+)<)re");

  std::size_t attributes = 0;
  for (std::size_t at = text.find("<Attribute"); at != std::string::npos;
       at = text.find("<Attribute", at + 1))
    ++attributes;
  ASSERT_EQ(found.size(), attributes);
  ASSERT_EQ(found.size(), frames * (1 + d * d + 1));
  for (const auto& attribute : found) {
    const std::string name = attribute[1];
    EXPECT_EQ(attribute[5], name);
    const auto array = file.read_doubles(fmt::format("/{}/{}", attribute[4].str(), name));
    EXPECT_EQ(array.shape, numbers(attribute[3]));

    // A vector with its third component, or the component that the name promises.
    const std::size_t f = name.starts_with("displacement") ? 0 : name.starts_with("pk1") ? 1 : 2;
    const auto whole = field(f, std::stoul(attribute[4]), d);
    const std::size_t width = shape.components(shape.fields[f]);
    std::vector<double> expected;
    std::size_t component = 0;
    if (const auto mark = name.find('_'); mark != std::string::npos)
      for (char c : name.substr(mark + 1))
        component = component * d + static_cast<std::size_t>(c - 'x');
    for (std::size_t row = 0; row < whole.size() / width; ++row)
      if (attribute[2] == "Vector")
        expected.insert(expected.end(), {whole[row * width], whole[row * width + 1], 0.0});
      else
        expected.push_back(whole[row * width + component]);
    EXPECT_EQ(array.values, expected) << name << " in frame " << attribute[4];
    EXPECT_EQ(attribute[2], d == 2 && f == 0 ? "Vector" : "Scalar");
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, XdmfOfKinds,
                         testing::Values(Kind{1, false}, Kind{1, true}, Kind{2, false},
                                         Kind{2, true}));

TEST_F(Xdmf, CellsInAPlaneAreOneSurfaceAFrame) {
  const std::string text = document_of_a_run(2, true);

  const auto surfaces = matches(
      text,
      R"re("Quadrilateral" NumberOfElements="2"[^>]*><DataItem[^>]*>run\.h5:/points/cells<)re");
  const auto positions = matches(text, R"re(run\.h5:([a-z/]+)/positions<)re");

  EXPECT_EQ(surfaces.size(), frames);
  EXPECT_EQ(text.find("Polyvertex"), std::string::npos);
  ASSERT_EQ(positions.size(), frames);
  for (const auto& item : positions) EXPECT_EQ(item[1], "/xdmf/particles");
  for (const auto& found :
       matches(text, R"re(Name="([a-z]+)[^"]*" AttributeType="[A-Za-z]+" Center="([A-Za-z]+)")re"))
    EXPECT_EQ(found[2], found[1] == "displacement" ? "Node" : "Cell") << found[1];
}

TEST_F(Xdmf, TimesKeepEveryBit) {
  const auto times = test::awkward_doubles(50);
  RunLayout only_particles = layout();
  only_particles.fields.resize(1);
  const std::string text = xdmf_document(only_particles, times, "run.h5", "run.xdmf.h5");

  const auto found = matches(text, R"re(<Time Value="([^"]+)"/>)re");

  ASSERT_EQ(found.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_EQ(std::strtod(found[i][1].str().c_str(), nullptr), times[i]);
}

TEST_F(Xdmf, PointsWithoutFieldsAreLeftOut) {
  RunLayout only_particles = layout();
  only_particles.fields.resize(1);

  const std::string text =
      xdmf_document(only_particles, std::vector<double>{0.0}, "run.h5", "run.xdmf.h5");

  EXPECT_EQ(text.find("/xdmf/points"), std::string::npos);
}

TEST_F(Xdmf, NamesAreEscapedAndFailuresTold) {
  const std::string text = xdmf_document(layout(), std::vector<double>{0.0}, "a&b<c>.h5", "<d>.h5");
  EXPECT_THAT(text, HasSubstr("a&amp;b&lt;c&gt;.h5:/xdmf/particles"));
  EXPECT_THAT(text, HasSubstr("&lt;d&gt;.h5:/0/pk1_xx"));

  const auto message = message_of<OutputError>(
      [&] { write_xdmf(directory / "none" / "run.xdmf", layout(), std::vector<double>{0.0}); });
  EXPECT_THAT(message, HasSubstr("run.xdmf"));
  EXPECT_THAT(message_of<OutputError>(
                  [&] { write_views(directory / "none" / "run.xdmf.h5", layout(), 1); }),
              HasSubstr("run.xdmf.h5"));
}

}  // namespace
}  // namespace tlsph
