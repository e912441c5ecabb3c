// Threads that work side by side: the one file that knows oneTBB.
#pragma once

namespace taut::detail {

/// Up to `jobs` threads, the calling one among them, call `work(context)`, as many times together as there are jobs;
/// comes back when all calls are over. More threads than cores, too, when they are asked for. `work` must not throw.
/// Throws std::system_error where no thread can be made.
///
/// A thread sanitizer does not see how oneTBB hands work on, so that file is compiled without it (CMakeLists.txt), and
/// who calls this makes visible what the threads share.
void work_together(unsigned jobs, void (*work)(void*), void* context);

/// The cores that this process may use.
int cores();

}  // namespace taut::detail
