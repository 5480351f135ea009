#include "tlsph/io/xdmf.hpp"

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

  std::string document_of_a_run(std::size_t dimension, bool cells = false) {
    const RunLayout shape = cells ? layout_of_cells(dimension) : layout(dimension);
    RunFile run =
        RunFile::create(path, shape, cells ? start_of_cells(dimension) : start(dimension));
    for (std::size_t frame = 0; frame < frames; ++frame) write_frame(run, frame, dimension);
    run.close();
    return xdmf_document(shape, run.frame_times(), "run.h5");
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

/// Part of an array: start, stride and count along each direction.
std::vector<double> part(const Hdf5Array<double>& array, const std::vector<std::size_t>& start,
                         const std::vector<std::size_t>& stride,
                         const std::vector<std::size_t>& count) {
  std::vector<double> values;
  std::vector<std::size_t> at(count.size(), 0);
  for (bool more = true; more;) {
    std::size_t index = 0;
    for (std::size_t a = 0; a < at.size(); ++a) {
      const std::size_t position = start[a] + stride[a] * at[a];
      EXPECT_LT(position, array.shape[a]);
      index = index * array.shape[a] + position;
    }
    values.push_back(array.values.at(index));
    more = false;
    for (std::size_t a = at.size(); a-- > 0 && !more; at[a] = more ? at[a] : 0)
      more = ++at[a] < count[a];
  }
  return values;
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

TEST_P(XdmfOfKinds, BothReadersAreToldTheSamePartOfTheRightFrame) {
  const std::size_t d = GetParam().dimension;
  const std::string text = document_of_a_run(d, GetParam().cells);
  const Hdf5File file = Hdf5File::open_read_only(path);
  const RunLayout shape = layout(d);

  const auto newer = matches(
      text,
      R"re(Dimensions="([0-9 ]+)">run\.h5:/frames/([a-z0-9]+)\|([0-9 ]+):([0-9 ]+):([0-9 ]+):([0-9 ]+)<)re");
  const auto older = matches(
      text,
      R"re("HyperSlab" Dimensions="([0-9 ]+)"><DataItem[^>]*>([0-9 ]+)</DataItem><DataItem[^>]*>run\.h5:/frames/([a-z0-9]+)<)re");
  const auto names = matches(text, R"re(<Attribute Name="([a-z0-9_]+)"[^>]*>\n)re");

  ASSERT_EQ(newer.size(), older.size());
  ASSERT_EQ(newer.size(), names.size());
  ASSERT_EQ(newer.size(), frames * (1 + d * d + 1));
  for (std::size_t i = 0; i < newer.size(); ++i) {
    const auto start = numbers(newer[i][3]), stride = numbers(newer[i][4]),
               count = numbers(newer[i][5]);
    std::vector<std::size_t> all = start;
    all.insert(all.end(), stride.begin(), stride.end());
    all.insert(all.end(), count.begin(), count.end());
    EXPECT_EQ(all, numbers(older[i][2]));
    EXPECT_EQ(newer[i][1], older[i][1]);
    EXPECT_EQ(newer[i][2], older[i][3]);
    const auto array = file.read_doubles("/frames/" + newer[i][2].str());
    EXPECT_EQ(array.shape, numbers(newer[i][6]));

    // The component that the name promises, from the frame that the position in the document
    // promises.
    const std::string name = names[i][1];
    const std::size_t f = name.starts_with("displacement") ? 0 : name.starts_with("pk1") ? 1 : 2;
    const std::size_t frame = i / (newer.size() / frames);
    const auto whole = field(f, frame, d);
    const std::size_t width = shape.components(shape.fields[f]);
    std::size_t component = 0, components = width;
    if (const auto mark = name.find('_'); mark != std::string::npos) {
      components = 1;
      for (char c : name.substr(mark + 1))
        component = component * d + static_cast<std::size_t>(c - 'x');
    }
    std::vector<double> expected;
    for (std::size_t row = 0; row < whole.size() / width; ++row)
      for (std::size_t c = 0; c < components; ++c)
        expected.push_back(whole[row * width + component + c]);
    EXPECT_EQ(part(array, start, stride, count), expected) << name << " in frame " << frame;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, XdmfOfKinds,
                         testing::Values(Kind{1, false}, Kind{1, true}, Kind{2, false},
                                         Kind{2, true}));

TEST_F(Xdmf, CellsInAPlaneAreOneSurfaceAFrame) {
  const std::string text = document_of_a_run(2, true);

  const auto surfaces = matches(
      text, R"re("Quadrilateral" NumberOfElements="2"><DataItem[^>]*>run\.h5:/points/cells<)re");
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
  const std::string text = xdmf_document(only_particles, times, "run.h5");

  const auto found = matches(text, R"re(<Time Value="([^"]+)"/>)re");

  ASSERT_EQ(found.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_EQ(std::strtod(found[i][1].str().c_str(), nullptr), times[i]);
}

TEST_F(Xdmf, PointsWithoutFieldsAreLeftOut) {
  RunLayout only_particles = layout();
  only_particles.fields.resize(1);

  const std::string text = xdmf_document(only_particles, std::vector<double>{0.0}, "run.h5");

  EXPECT_EQ(text.find("Spatial"), std::string::npos);
  EXPECT_EQ(text.find("/xdmf/points"), std::string::npos);
}

TEST_F(Xdmf, NamesAreEscapedAndFailuresTold) {
  const std::string text = xdmf_document(layout(), std::vector<double>{0.0}, "a&b<c>.h5");
  EXPECT_THAT(text, HasSubstr("a&amp;b&lt;c&gt;.h5:/frames/pk1"));

  const auto message = message_of<OutputError>(
      [&] { write_xdmf(directory / "none" / "run.xdmf", layout(), std::vector<double>{0.0}); });
  EXPECT_THAT(message, HasSubstr("run.xdmf"));
}

}  // namespace
}  // namespace tlsph
