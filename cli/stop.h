// Limits and interrupts: what ends the program before it is done, with exit code 4.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace taut::cli {

/// How the program ends.
enum ExitCode : int {
  kFound = 0,     ///< also: done, valid
  kNone = 1,      ///< there is no path, proven; the path to check is not valid
  kUsage = 2,     ///< the command line makes no sense
  kInput = 3,     ///< the input is wrong, start or goal in a wall included; an output file cannot be made
  kStopped = 4,   ///< a limit or an interrupt; an output file could not be written to its end
  kInternal = 70  ///< a defect of the program, such as an answer that its own check refuses (EX_SOFTWARE)
};

struct Limits {
  std::optional<double> seconds;      ///< wall clock, from start_watch()
  std::optional<std::size_t> memory;  ///< bytes of address space
  unsigned jobs = 1;                  ///< threads that share the work
};

/// What ended the program.
struct Stop {
  std::string reason;  ///< `interrupted`, `--max-seconds 2`, `out of memory`
  std::string stage;   ///< the last one begun, may be empty
};

/// What the watching thread does every so many seconds, with the name of the stage. It must not wait for long.
struct Beat {
  double seconds = 0;
  std::function<void(const char* stage)> work{};  ///< empty: nothing
};

/// From now on SIGINT, SIGTERM and the end of the seconds stop the program: a thread of its own waits for them, so no
/// computation has to ask. Memory that cannot be had is std::bad_alloc; GMP, which would abort, stops the program as
/// well. Call once, before any work.
void start_watch(const Limits& limits, Beat beat = {});

/// Names what is being done, for messages. `stage` must live for ever.
void begin_stage(const char* stage) noexcept;

/// What else to do when stopped, say write a result that says so; replaces the one before. It runs in the watching
/// thread and must hold copies of all it needs. Its exceptions are swallowed.
void on_stop(std::function<void(const Stop&)> last_words);

/// This process group is killed, too, when the program is stopped; 0: none.
void kill_with_us(int group) noexcept;

/// From now on SIGINT and SIGTERM do not stop the program but call `work`, in the watching thread: for what goes on
/// until somebody ends it, and then has ended well. The end of the seconds still stops it.
void instead_of_stopping(std::function<void()> work);

/// The work is done, results will be written: the seconds no longer count, and the last words are dropped. Does not
/// return when the program is being stopped already.
void finish();

/// Says so on stderr, speaks the last words and exits with code 4.
[[noreturn]] void stop(const char* reason) noexcept;

}  // namespace taut::cli
