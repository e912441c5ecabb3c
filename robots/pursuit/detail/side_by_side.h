// Two searches at a time.
#pragma once

#include <taut/geometry/parallel.h>
#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

inline constexpr std::size_t kWorthAThread = 10'000;  // cells

/// Both, with the same result in whatever order. Throws what either throws, of two what `here`
/// throws.
template <typename F, typename G>
void side_by_side(const Workspace& work, F here, G beside) {
  const unsigned jobs = work.map().index_count() < kWorthAThread ? 1 : work.jobs;
  each_in_parallel(2, {jobs}, [&](std::size_t i) { i == 0 ? here() : beside(); });
}

}  // namespace taut::pursuit::detail
