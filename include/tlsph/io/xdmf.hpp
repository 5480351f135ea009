#pragma once
/// \file
/// run.xdmf: tells viewers where in run.h5 the frames lie. Where the material points are cells of
/// nodes, every frame is a grid of those cells, with the fields of the particles at its nodes and
/// those of the points on its cells; where the points are the nodes, all fields are at nodes, of
/// triangles if the body has some and of vertices if not. Elsewhere there are two grids, one of the
/// material points, if a field lives there, and one of the particles. Positions are those of the
/// reference configuration, "Warp By Vector" with `displacement` shows the deformed body.
///
/// Vectors in 2D have three components, the third of them 0; tensors and all fields in 1D are
/// scalars with the component in their name (pk1_xy, displacement_x). Viewers want each as a data
/// set of its own: run.xdmf.h5 has them as virtual data sets, which show the numbers of run.h5 and
/// hold none.

#include <filesystem>
#include <span>
#include <string>

#include "tlsph/io/run_file.hpp"

namespace tlsph {

/// The document for frames at `times` [s] in the file `run_file`, seen through `view_file`; both
/// are paths relative to the document.
std::string xdmf_document(const RunLayout& layout, std::span<const double> times,
                          const std::string& run_file, const std::string& view_file);

/// Writes the document whole or not at all, so that a viewer may reload it at any time.
void write_xdmf(const std::filesystem::path& path, const RunLayout& layout,
                std::span<const double> times, const std::string& run_file = "run.h5");

/// <document>.h5, beside the document.
[[nodiscard]] std::filesystem::path view_file_of(const std::filesystem::path& xdmf);

/// Writes that file whole or not at all: for so many frames, of which `run_file`, relative to it,
/// need not have any yet.
void write_views(const std::filesystem::path& path, const RunLayout& layout, std::size_t frames,
                 const std::string& run_file = "run.h5");

}  // namespace tlsph
