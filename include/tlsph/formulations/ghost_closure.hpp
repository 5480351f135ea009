#pragma once
/// \file
/// How the formulation `thesis` closes its boundary.

namespace tlsph {

/// The modified SPH matrix (2.46) with the coupling to the inner particles that is missing in
/// print, the same as printed, or the η corrections (2.42), (2.45) in 1D.
enum class GhostClosure { consistent, as_printed, eta };

}  // namespace tlsph
