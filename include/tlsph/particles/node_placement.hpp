#pragma once
/// \file
/// Where nodes sit on a lattice.

namespace tlsph {

/// At the corners of its cells, so that some lie on the boundary, or at the centres of the cells.
enum class NodePlacement { on_boundary, cell_centred };

}  // namespace tlsph
