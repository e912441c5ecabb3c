// What is said of long work while it goes on: how much is done, how fast, how long the rest will take.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include <taut/geometry/progress.h>

namespace taut::cli {

/// Where lines of progress go.
enum class Surface {
  terminal,  ///< one line that is written again and again
  file       ///< a line every 10 seconds
};

/// Remembers what was told last, and says when that is worth a line. For any number of threads.
class Meter {
 public:
  /// Seconds that only grow.
  using Clock = std::function<double()>;

  Meter(Surface surface, Clock clock);

  /// How long to wait between questions whether a line is due, in seconds.
  double period() const;

  void told(const Progress& progress);
  /// Nothing is counted any more, until something is told again.
  void over();

  /// `roadmap: 1200 of 8000 corners, 150 a second, about 46 s left`, where it is time for it: work that is not over has
  /// been going on for a while, and so long ago was the last line. The rate is that since its first count.
  std::optional<std::string> due(std::string_view stage);

 private:
  double patience() const;
  std::string line(std::string_view stage, double since) const;

  const Surface surface_;
  const Clock clock_;
  std::mutex mutex_;  // of what follows
  bool is_counting_ = false;
  Progress first_, last_;  // of what is being counted
  double begun_ = 0;
  std::optional<double> shown_;  // the last line, or the first count of all
};

}  // namespace taut::cli
