#include <taut/geometry/detail/crew.h>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <stdexcept>
#include <system_error>

namespace taut::detail {

void work_together(unsigned jobs, void (*work)(void*), void* context) {
  try {
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, jobs);
    tbb::task_arena arena(static_cast<int>(jobs));
    arena.execute([&] {
      tbb::parallel_for(
          0U, jobs, 1U, [&](unsigned) { work(context); }, tbb::simple_partitioner{});
    });
  } catch (const std::runtime_error& error) {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again), error.what());
  }
}

int cores() { return tbb::info::default_concurrency(); }

}  // namespace taut::detail
