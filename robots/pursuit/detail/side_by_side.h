// Two searches at a time.
#pragma once

#include <exception>
#include <thread>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

inline constexpr std::size_t kWorthAThread = 10'000;  // cells

/// Both, with the same result in whatever order. Throws what either throws, of two what `here`
/// throws; std::system_error where no thread can be had.
template <typename F, typename G>
void side_by_side(const Workspace& work, F here, G beside) {
  if (work.map().index_count() < kWorthAThread) {
    here();
    return beside();
  }
  std::exception_ptr failure;
  {
    const std::jthread thread([&] {
      try {
        beside();
      } catch (...) {
        failure = std::current_exception();
      }
    });
    here();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace taut::pursuit::detail
