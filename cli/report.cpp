#include <taut/cli/report.h>

#include <fmt/format.h>
#include <sys/resource.h>

namespace taut::cli {

std::string cpu_text(const Seconds& seconds) {
  const std::string cpu = seconds_text(seconds.cpu) + " CPU";
  return seconds.cpu > 0.01 && seconds.wall < 0.9 * seconds.cpu ? cpu + ", " + seconds_text(seconds.wall) + " wall"
                                                                : cpu;
}

std::string peak_memory_text() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return fmt::format("{:.1f} MB", static_cast<double>(usage.ru_maxrss) / 1024);
}

}  // namespace taut::cli
