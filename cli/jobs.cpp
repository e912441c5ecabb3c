#include <taut/cli/jobs.h>

#include <string>

#include <taut/cli/options.h>
#include <taut/geometry/parallel.h>

namespace taut::cli {

namespace {

constexpr std::size_t kMost = 1024;

unsigned jobs_of(const std::string& text) {
  const std::size_t count = count_of(text);
  if (count > kMost) throw UsageError("'" + text + "' is more than 1024 threads");
  return count == 0 ? core_count() : static_cast<unsigned>(count);
}

}  // namespace

void add_jobs_option(CommandLine& app, Limits& limits) {
  app.add_option_function(
         "--jobs", [&limits](const std::string& text) { limits.jobs = jobs_of(text); },
         "How many threads share the work, 0: one a core (default: " + std::to_string(limits.jobs) +
             "); the results are the same")
      .type_name("N")
      .group("Limits");
}

}  // namespace taut::cli
