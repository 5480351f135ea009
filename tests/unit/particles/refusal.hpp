#pragma once
/// \file
/// What a refused input is told.

#include <string>

#include "tlsph/core/error.hpp"

namespace tlsph {

/// The text of the InputError that the call throws, "no error" if it throws none.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace tlsph
