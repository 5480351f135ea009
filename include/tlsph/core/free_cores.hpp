#pragma once
/// \file
/// Whether the machine has cores for this process.

namespace tlsph {

/// Whether so many threads run at once now, each on a core that nobody else wants; takes some ten
/// milliseconds. For libraries with threads of their own, which wait for one another.
[[nodiscard]] bool cores_are_free(int threads);

}  // namespace tlsph
