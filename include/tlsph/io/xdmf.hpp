#pragma once
/// \file
/// run.xdmf: tells ParaView where in run.h5 the frames lie. Where the material points are cells of
/// nodes in a plane, every frame is a surface of quadrilaterals, with the fields of the particles
/// at its nodes and those of the points on its cells. Elsewhere it is a grid of vertices for the
/// particles and one for the material points if a field lives there. Positions are those of the
/// reference configuration, "Warp By Vector" with `displacement` shows the deformed body.
///
/// Vectors in 2D are vectors; tensors and all fields in 1D are scalars with the component in their
/// name (pk1_xy, displacement_x).

#include <filesystem>
#include <span>
#include <string>

#include "tlsph/io/run_file.hpp"

namespace tlsph {

/// Whether the frames of such a run are surfaces of quadrilaterals.
[[nodiscard]] bool draws_cells(const RunLayout& layout);

/// The document for frames at `times` [s] in the file `run_file`, a path relative to the document.
std::string xdmf_document(const RunLayout& layout, std::span<const double> times,
                          const std::string& run_file);

/// Writes the document whole or not at all, so that a viewer may reload it at any time.
void write_xdmf(const std::filesystem::path& path, const RunLayout& layout,
                std::span<const double> times, const std::string& run_file = "run.h5");

}  // namespace tlsph
