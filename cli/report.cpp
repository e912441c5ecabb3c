#include <taut/cli/report.h>

#include <fmt/format.h>
#include <sys/resource.h>

#include <taut/cli/messages.h>

namespace taut::cli {

void note_stage(const char* stage, double seconds, const std::string& what) {
  note(fmt::format("{:<12}{:>9.4f} s   {}", stage, seconds, what));
}

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
