#include "tlsph/io/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>

#include "tlsph/io/files.hpp"

namespace tlsph {
namespace {

using Text = fmt::memory_buffer;

template <class... Values>
void add(Text& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

std::string escaped(const std::string& raw) {
  const std::map<char, std::string> entities = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string text;
  for (char c : raw) text += entities.contains(c) ? entities.at(c) : std::string(1, c);
  return text;
}

/// Entries of a field that a viewer sees as one: a vector, or a component.
struct View {
  std::string name;
  std::size_t first = 0, width = 1;

  [[nodiscard]] bool is_vector() const { return width > 1; }
};

std::vector<View> views_of(const RunLayout& layout, const FrameField& field) {
  const std::size_t d = layout.dimension;
  if (field.rank == Rank::scalar) return {{field.name}};
  if (field.rank == Rank::vector && d > 1) return {{field.name, 0, d}};
  const std::vector<std::string> components = component_names(field.rank, d);
  std::vector<View> views;
  for (std::size_t c = 0; c < components.size(); ++c)
    views.push_back({fmt::format("{}_{}", field.name, components[c]), c});
  return views;
}

std::string item_of(std::size_t frame, const View& view) {
  return fmt::format("/{}/{}", frame, view.name);
}

struct Document {
  const RunLayout& layout;
  std::string run_file, view_file;
  Text text{};

  void field(const FrameField& field, std::size_t frame) {
    const std::size_t rows = layout.rows(field);
    const bool cells = layout.points_are_cells && field.site == Site::points;
    for (const View& view : views_of(layout, field))
      add(text,
          "<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\"><DataItem Format=\"HDF\" "
          "NumberType=\"Float\" Precision=\"8\" Dimensions=\"{}{}\">{}:{}</DataItem></Attribute>\n",
          escaped(view.name), view.is_vector() ? "Vector" : "Scalar", cells ? "Cell" : "Node", rows,
          view.is_vector() ? " 3" : "", escaped(view_file), escaped(item_of(frame, view)));
  }

  /// All points of one kind as vertices.
  void vertices(const std::string& group, std::size_t count) {
    add(text,
        "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{0}\" NodesPerElement=\"1\">"
        "<DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"4\" Dimensions=\"{0} 1\">"
        "{1}/vertices</DataItem></Topology>\n",
        count, group);
  }

  /// `count` cells of that many corners each.
  void cells(const char* type, std::size_t count, std::size_t corners, const char* item) {
    add(text,
        "<Topology TopologyType=\"{}\" NumberOfElements=\"{}\" NodesPerElement=\"{}\">"
        "<DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"4\" Dimensions=\"{} {}\">"
        "{}:{}</DataItem></Topology>\n",
        type, count, corners, count, corners, escaped(run_file), item);
  }

  /// One grid with the fields of these sites, their positions those of the first.
  void grid(const char* name, std::initializer_list<Site> sites, std::size_t frame, double time) {
    const bool nodes = *sites.begin() == Site::particles;
    const std::string group = escaped(run_file) + (nodes ? ":/xdmf/particles" : ":/xdmf/points");
    const std::size_t count = nodes ? layout.particles : layout.points;
    add(text, "<Grid Name=\"{}\" GridType=\"Uniform\">\n", name);
    add(text, "<Time Value=\"{:.17g}\"/>\n", time);
    if (nodes && layout.triangles > 0)
      cells("Triangle", layout.triangles, 3, "/particles/triangles");
    else if (layout.points_are_cells)
      cells(layout.dimension == 1 ? "Polyline" : "Quadrilateral", layout.points,
            std::size_t{1} << layout.dimension, "/points/cells");
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

  /// A collection of the grids of all frames.
  void series(const char* name, std::initializer_list<Site> sites, std::span<const double> times) {
    add(text, "<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", name);
    for (std::size_t frame = 0; frame < times.size(); ++frame)
      grid(name, sites, frame, times[frame]);
    add(text, "</Grid>\n");
  }
};

}  // namespace

std::string xdmf_document(const RunLayout& layout, std::span<const double> times,
                          const std::string& run_file, const std::string& view_file) {
  Document document{layout, run_file, view_file};
  add(document.text,
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n");
  if (layout.points_are_cells || layout.points_are_nodes) {
    document.series("body", {Site::particles, Site::points}, times);
  } else {
    // The particles last: a reader that takes one collection only takes the last.
    if (layout.points > 0 && std::ranges::any_of(layout.fields, [](const auto& entry) {
          return entry.site == Site::points;
        }))
      document.series("points", {Site::points}, times);
    document.series("particles", {Site::particles}, times);
  }
  add(document.text, "</Domain>\n</Xdmf>\n");
  return fmt::to_string(document.text);
}

void write_views(const std::filesystem::path& path, const RunLayout& layout, std::size_t frames,
                 const std::string& run_file) {
  Hdf5File file = Hdf5File::create(path.string() + ".tmp");
  for (std::size_t frame = 0; frame < frames; ++frame)
    for (const FrameField& field : layout.fields) {
      const std::size_t rows = layout.rows(field);
      for (const View& view : views_of(layout, field)) {
        Hdf5Part part{run_file, "/frames/" + field.name, {frame + 1, rows}, {frame, 0}, {1, rows}};
        if (field.rank != Rank::scalar) {
          part.shape.push_back(layout.components(field));
          part.start.push_back(view.first);
          part.count.push_back(view.width);
        }
        if (view.is_vector())
          file.write_view(item_of(frame, view), {rows, 3}, {rows, view.width}, part);
        else
          file.write_view(item_of(frame, view), {rows}, {rows}, part);
      }
    }
  file.flush();
  file.rename(path);
  file.close();
}

void write_xdmf(const std::filesystem::path& path, const RunLayout& layout,
                std::span<const double> times, const std::string& run_file) {
  write_text_file(path, xdmf_document(layout, times, run_file, view_file_of(path).filename()));
}

std::filesystem::path view_file_of(const std::filesystem::path& xdmf) {
  return xdmf.string() + ".h5";
}

}  // namespace tlsph
