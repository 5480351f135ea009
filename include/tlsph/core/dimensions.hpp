#pragma once
/// \file
/// The dimensions a body may have: the one place where a number becomes a template argument.

#include <cassert>

namespace tlsph {

/// `work.template operator()<D>()` for D = `dimension`, 1 or 2:
///
///     in_dimension(scene.dimension, [&]<int D>() { return run_in<D>(scene); });
template <class Work>
decltype(auto) in_dimension(int dimension, const Work& work) {
  assert(dimension == 1 || dimension == 2);
  return dimension == 1 ? work.template operator()<1>() : work.template operator()<2>();
}

}  // namespace tlsph
