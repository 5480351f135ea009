#include "tlsph/io/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "tlsph/io/files.hpp"

namespace tlsph {
namespace {

using Text = fmt::memory_buffer;

template <class... Values>
void add(Text& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

std::string escaped(const std::string& raw) {
  std::string text;
  for (char c : raw) {
    if (c == '&')
      text += "&amp;";
    else if (c == '<')
      text += "&lt;";
    else if (c == '>')
      text += "&gt;";
    else if (c == '"')
      text += "&quot;";
    else
      text += c;
  }
  return text;
}

struct Document {
  const RunLayout& layout;
  std::string run_file;
  std::size_t frames;
  Text text{};

  /// `width` components from `first` on of one frame of a field.
  ///
  /// ParaView has two readers for these files. The older one takes part of a data set by a
  /// HyperSlab, which the newer one does not know; the newer one takes it by numbers behind the
  /// path (start:stride:count:shape), which the older one does not know. Each looks at the first
  /// child it knows, and only the newer one knows an Attribute within an Attribute: so that comes
  /// first.
  void attribute(const std::string& name, const char* type, const FrameField& field,
                 std::size_t frame, std::size_t first, std::size_t width) {
    const std::size_t rows = layout.rows(field), all = layout.components(field);
    const bool scalar = field.rank == Rank::scalar;
    const auto triple = [&](std::size_t a, std::size_t b, std::size_t c) {
      return scalar ? fmt::format("{} {}", a, b) : fmt::format("{} {} {}", a, b, c);
    };
    const std::string start = triple(frame, 0, first), stride = triple(1, 1, 1),
                      count = triple(1, rows, width), shape = triple(frames, rows, all);
    const std::string item = escaped(run_file + ":/frames/" + field.name);
    const std::string label = escaped(name);
    const std::string taken =
        width == 1 ? fmt::format("{}", rows) : fmt::format("{} {}", rows, width);
    constexpr const char* number = R"(Format="HDF" NumberType="Float" Precision="8")";
    const char* centre = draws_cells(layout) && field.site == Site::points ? "Cell" : "Node";
    const std::string head = fmt::format(
        "<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">", label, type, centre);
    add(text, "{0}\n{0}", head);
    add(text, "<DataItem {} Dimensions=\"{}\">{}|{}:{}:{}:{}</DataItem></Attribute>\n", number,
        taken, item, start, stride, count, shape);
    add(text, "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{}\">", taken);
    add(text, "<DataItem Format=\"XML\" NumberType=\"Int\" Dimensions=\"3 {}\">{} {} {}</DataItem>",
        scalar ? 2 : 3, start, stride, count);
    add(text, "<DataItem {} Dimensions=\"{}\">{}</DataItem></DataItem>\n", number, shape, item);
    add(text, "</Attribute>\n");
  }

  void field(const FrameField& field, std::size_t frame) {
    const std::size_t d = layout.dimension;
    if (field.rank == Rank::scalar) return attribute(field.name, "Scalar", field, frame, 0, 1);
    if (field.rank == Rank::vector && d > 1)
      return attribute(field.name, "Vector", field, frame, 0, d);
    const std::string axes = "xyz";
    for (std::size_t c = 0; c < layout.components(field); ++c) {
      const std::string component = field.rank == Rank::vector
                                        ? std::string(1, axes[c])
                                        : std::string{axes[c / d], axes[c % d]};
      attribute(field.name + "_" + component, "Scalar", field, frame, c, 1);
    }
  }

  /// All points of one kind as vertices.
  void vertices(const std::string& group, std::size_t count) {
    add(text,
        "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{0}\" NodesPerElement=\"1\">"
        "<DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"4\" Dimensions=\"{0}\">"
        "{1}/vertices</DataItem></Topology>\n",
        count, group);
  }

  /// A surface of `count` cells of that many corners each.
  void surface(const char* type, std::size_t count, std::size_t corners, const char* item) {
    add(text,
        "<Topology TopologyType=\"{}\" NumberOfElements=\"{}\">"
        "<DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"4\" Dimensions=\"{} {}\">"
        "{}:{}</DataItem></Topology>\n",
        type, count, count, corners, escaped(run_file), item);
  }

  /// One grid with the fields of these sites, their positions those of the first.
  void grid(const char* name, std::initializer_list<Site> sites, std::size_t frame, double time) {
    const bool nodes = *sites.begin() == Site::particles;
    const std::string group = escaped(run_file) + (nodes ? ":/xdmf/particles" : ":/xdmf/points");
    const std::size_t count = nodes ? layout.particles : layout.points;
    add(text, "<Grid Name=\"{}\" GridType=\"Uniform\">\n", name);
    add(text, "<Time Value=\"{:.17g}\"/>\n", time);
    if (nodes && layout.triangles > 0)
      surface("Triangle", layout.triangles, 3, "/particles/triangles");
    else if (sites.size() > 1)
      surface("Quadrilateral", layout.points, 4, "/points/cells");
    else
      vertices(group, count);
    add(text,
        "<Geometry GeometryType=\"XYZ\"><DataItem Format=\"HDF\" NumberType=\"Float\" "
        "Precision=\"8\" Dimensions=\"{} 3\">{}/positions</DataItem></Geometry>\n",
        count, group);
    for (const auto& entry : layout.fields)
      if (std::ranges::find(sites, entry.site) != sites.end()) field(entry, frame);
    add(text, "</Grid>\n");
  }

  /// All grids of a frame.
  void whole_frame(std::size_t frame, double time) {
    if (draws_cells(layout) || (layout.triangles > 0 && layout.points_are_nodes))
      return grid("body", {Site::particles, Site::points}, frame, time);
    const bool points =
        layout.points > 0 && std::ranges::any_of(layout.fields, [](const auto& entry) {
          return entry.site == Site::points;
        });
    if (!points) return grid("particles", {Site::particles}, frame, time);
    add(text, "<Grid Name=\"frame\" GridType=\"Collection\" CollectionType=\"Spatial\">\n");
    add(text, "<Time Value=\"{:.17g}\"/>\n", time);
    grid("particles", {Site::particles}, frame, time);
    grid("points", {Site::points}, frame, time);
    add(text, "</Grid>\n");
  }
};

}  // namespace

bool draws_cells(const RunLayout& layout) {
  return layout.points_are_cells && layout.dimension == 2;
}

std::string xdmf_document(const RunLayout& layout, std::span<const double> times,
                          const std::string& run_file) {
  Document document{layout, run_file, times.size()};
  add(document.text,
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n");
  add(document.text, "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n");
  for (std::size_t frame = 0; frame < times.size(); ++frame)
    document.whole_frame(frame, times[frame]);
  add(document.text, "</Grid>\n</Domain>\n</Xdmf>\n");
  return fmt::to_string(document.text);
}

void write_xdmf(const std::filesystem::path& path, const RunLayout& layout,
                std::span<const double> times, const std::string& run_file) {
  write_text_file(path, xdmf_document(layout, times, run_file));
}

}  // namespace tlsph
