// The program `taut`: runs the subcommand that is asked for, turns what is thrown into a line and an exit code.
#include <exception>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/program.h>
#include <taut/cli/progress.h>
#include <taut/cli/ranks.h>
#include <taut/cli/run.h>
#include <taut/cli/stop.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

int run(const Command& command) {
  try {
    if (command.common->ranks) join_ranks(*command.common);
  } catch (const UsageError& error) {
    throw wrong_usage(command, error.what());
  }
  Run run(command.line->full_name().substr(std::string_view("taut ").size()), *command.common);
  start_watch(command.common->limits, progress_beat(*command.common));
  try {
    return command.run(run);
  } catch (const InputError& error) {
    complain(error.what());
    return run.refuse(error.what());
  } catch (const UsageError& error) {
    throw wrong_usage(command, error.what());
  }
}

// Large vectors that come and go get the same pages again: on worlds of a million walls a tenth of the time is spent on
// fresh ones. What is no longer needed goes back when the program ends.
void keep_pages() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 25);  // the largest that is allowed; what is larger would leave holes
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, 1 << 24);
#endif
}

int run(std::vector<std::string> words) {
  keep_pages();
  Program program;
  const Asked asked = program.parse(std::move(words));
  if (asked.command) return run(*asked.command);
  print(asked.text);
  return kFound;
}

[[noreturn]] void refused(const std::system_error& error) noexcept {
  stop(error.code() == std::errc::resource_unavailable_try_again ? "no further thread can be started" : error.what());
}

// A std::system_error is the operating system's refusal: no further thread, no file handle.
int guarded(int argc, char** argv) noexcept {
  try {
    return run({argv + 1, argv + argc});
  } catch (const UsageError& error) {
    complain(error.what());
    return kUsage;
  } catch (const InputError& error) {
    complain(error.what());
    return kInput;
  } catch (const WriteError& error) {
    complain(error.what());
    return kStopped;
  } catch (const std::bad_alloc&) {
    stop("out of memory");
  } catch (const std::system_error& error) {
    refused(error);
  } catch (const std::exception& error) {
    complain(std::string("internal error: ").append(error.what()));
    return kInternal;
  } catch (...) {
    complain("internal error");
    return kInternal;
  }
}

// Where an exception cannot be thrown further, as in a callback of a C library.
[[noreturn]] void end_badly() noexcept {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    stop("out of memory");
  } catch (const std::system_error& error) {
    refused(error);
  } catch (const std::exception& error) {
    complain(error.what());
  } catch (...) {
  }
  complain("internal error: ended in a place that cannot fail");
  ::_exit(kInternal);
}

}  // namespace

}  // namespace taut::cli

int main(int argc, char** argv) {
  std::set_terminate(taut::cli::end_badly);
  const int code = taut::cli::guarded(argc, argv);
  taut::cli::leave_ranks(code);
  return code;
}
