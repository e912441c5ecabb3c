// What is said about bad input.
#pragma once

#include <string>

#include <taut/geometry/errors.h>

namespace taut::test {

/// The message of the InputError that `work` throws; "accepted" when it throws none.
template <class Work>
std::string refusal_of(Work work) {
  try {
    work();
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace taut::test
