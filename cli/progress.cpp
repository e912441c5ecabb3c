#include <taut/cli/progress.h>

#include <chrono>
#include <cstdlib>
#include <string_view>

#include <taut/cli/messages.h>
#include <taut/cli/meter.h>

namespace taut::cli {

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Lives as long as the process: the watching thread outlives main().
Meter& meter() {
  static auto* const instance = new Meter(is_progress_shown() ? Surface::terminal : Surface::file, now);
  return *instance;
}

bool is_wanted(const CommonOptions& options) {
  const char* wish = std::getenv("TAUT_PROGRESS");
  return !options.quiet && !(wish && std::string_view(wish) == "0");
}

void show(const char* stage) {
  try {
    if (const auto line = meter().due(stage)) progress("taut: " + *line);
  } catch (...) {  // no memory: nothing that must be said
  }
}

}  // namespace

TellProgress shown_progress(const CommonOptions& options) {
  if (!is_wanted(options)) return {};
  return [](const Progress& progress) { meter().told(progress); };
}

Beat progress_beat(const CommonOptions& options) {
  if (!is_wanted(options)) return {};
  return {meter().period(), show};
}

void progress_over() noexcept {
  meter().over();
  end_progress();
}

}  // namespace taut::cli
