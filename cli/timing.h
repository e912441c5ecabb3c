// Wall-clock time.
#pragma once

#include <chrono>

#include <taut/cli/stop.h>

namespace taut::cli {

/// Of each stage.
struct StageSeconds {
  double read = 0, space = 0, roadmap = 0, search = 0, verify = 0, total = 0;
};

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What `work` gives; its time goes to `seconds`, its name to begin_stage.
template <typename Work>
auto timed(const char* stage, double& seconds, Work work) {
  begin_stage(stage);
  const Stopwatch watch;
  auto result = work();
  seconds = watch.seconds();
  return result;
}

}  // namespace taut::cli
