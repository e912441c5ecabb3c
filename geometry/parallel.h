// Loops that several threads share.
#pragma once

#include <cstddef>
#include <functional>

namespace taut {

/// How a loop is shared.
struct Parallel {
  /// Threads, the calling one among them. Up to 1: the calling one alone, and none is started.
  unsigned jobs = 1;
  /// Asked by the calling thread before each item that it takes; once it says so, no further item is begun.
  std::function<bool()> is_over{};
  /// Told how many items, from the first on, are over, whenever that grows: by any thread, one call at a time,
  /// ascending. What the items wrote can be read there.
  std::function<void(std::size_t)> finished{};
};

/// How many threads can run at once here: the cores that this process may use, at least 1.
unsigned core_count();

/// Calls `work(i)` once for each i below `count`, and comes back when all are over.
///
///  1. Items are begun in ascending order. So whatever an item writes of its own is the same for any number of jobs.
///  2. An item that throws ends the loop: no later one is begun, all before it are finished, and of those that threw
///     the exception of the lowest one, which is the same for any number of jobs, goes on to the caller. What `is_over`
///     or `finished` throw ends it likewise.
///  3. The threads are oneTBB's: made when first asked for, and kept asleep. A loop within a loop is fine. Throws
///     std::system_error where no thread can be made.
void each_in_parallel(std::size_t count, const Parallel& how, const std::function<void(std::size_t)>& work);

/// Likewise, where each thread works with memory of its own: `begin` is called by each that takes part, before its
/// first item, and gives its `work`. A `begin` that throws is an item that throws.
void each_in_parallel(std::size_t count, const Parallel& how,
                      const std::function<std::function<void(std::size_t)>()>& begin);

/// Makes the threads that loops of `jobs` will share now: for programs that limit their memory later, when none could
/// be made. Where there are none to be had, loops do with fewer.
void start_threads(unsigned jobs);

/// How long the blocks of a loop over `count` small things should be: about `blocks` for each job, at least `least`.
/// Only for loops whose results do not depend on where blocks end.
std::size_t block_length(std::size_t count, unsigned jobs, std::size_t least, std::size_t blocks = 16);

}  // namespace taut
