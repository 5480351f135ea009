#pragma once
/// \file
/// The corrections of a collocated gradient.

namespace tlsph {

/// Bonet & Lok (CMAME 180, 1999): `none` is the difference form (40), `gradient` (42)–(45), `mixed`
/// (54)–(58). `least_squares` fits a plane by moving least squares instead: exact for linear fields
/// too, and at boundaries its adjoint is several times nearer to the divergence theorem, for it
/// weighs with W where the others weigh with ∇W.
enum class Correction { none, gradient, mixed, least_squares };

}  // namespace tlsph
