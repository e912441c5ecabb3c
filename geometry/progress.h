// How far long work has come, for those who want to show it.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>

namespace taut {

/// So much of some work is done.
struct Progress {
  const char* unit = "";  ///< what is counted, in the plural, as `corners`; lives for ever
  std::size_t done = 0;
  std::size_t all = 0;  ///< 0 where nobody knows
};

/// What long work tells, where one is given.
///
///  1. First with nothing done, last with all of it, in between after every item or few; `done` never falls but where
///     another unit begins.
///  2. By any thread that shares the work, one call at a time. It has to be quick.
///  3. It changes nothing of the result.
using TellProgress = std::function<void(const Progress&)>;

/// Counts what several threads do, and tells. `tell` may be empty, and has to outlive it.
class ProgressCount {
 public:
  ProgressCount(const char* unit, std::size_t all, const TellProgress& tell) : unit_(unit), all_(all), tell_(tell) {
    if (tell_) tell_({unit_, 0, all_});
  }
  ProgressCount(const ProgressCount&) = delete;
  ProgressCount& operator=(const ProgressCount&) = delete;

  void add(std::size_t items = 1) {
    if (!tell_) return;
    done_ += items;
    const std::lock_guard lock(mutex_);
    tell_({unit_, done_, all_});
  }

 private:
  const char* unit_;
  std::size_t all_;
  const TellProgress& tell_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
};

}  // namespace taut
