// Two searches at a time.
#pragma once

#include <optional>
#include <thread>

#include <taut/robots/pursuit/detail/reduced.h>

namespace taut::pursuit::detail {

inline constexpr std::size_t kWorthAThread = 10'000;  // cells

/// Both, with the same result in whatever order. Throws SearchStopped when either does.
template <typename F, typename G>
void side_by_side(const Workspace& work, F here, G beside) {
  if (work.map().index_count() < kWorthAThread) {
    here();
    return beside();
  }
  std::optional<SearchStopped> stopped;
  {
    const std::jthread thread([&] {
      try {
        beside();
      } catch (const SearchStopped& stop) {
        stopped = stop;
      }
    });
    here();
  }
  if (stopped) throw *stopped;
}

}  // namespace taut::pursuit::detail
