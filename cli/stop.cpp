#include <taut/cli/stop.h>

#include <fmt/format.h>
#ifndef TAUT_BOOST_NUMBERS
#include <gmp.h>
#endif
#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <system_error>

#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/geometry/parallel.h>

namespace taut::cli {

namespace {

// Lives as long as the process: the watching thread outlives main().
struct Shared {
  std::mutex mutex;  // of last_words and on_signal
  std::function<void()> on_signal;
  std::function<void(const Stop&)> last_words;
  std::atomic<const char*> stage{""};
  std::atomic<int> group{0};        // of a program that was started
  std::atomic<bool> ending{false};  // finishing or stopping, whoever came first
  std::unique_ptr<char[]> reserve;  // memory to say that there is none
  sigset_t signals{};
  std::optional<timespec> deadline;
  std::string deadline_reason;
  Beat beat;
};

Shared& shared() {
  static auto* const instance = new Shared;
  return *instance;
}

[[noreturn]] void wait_for_the_end() {
  for (;;) ::pause();
}

timespec now() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t;
}

timespec in_seconds(double seconds) {
  timespec t = now();
  const double whole = std::floor(std::min(seconds, 1e9));
  t.tv_sec += static_cast<time_t>(whole);
  t.tv_nsec += static_cast<long>((std::min(seconds, 1e9) - whole) * 1e9);
  if (t.tv_nsec >= 1'000'000'000) {
    ++t.tv_sec;
    t.tv_nsec -= 1'000'000'000;
  }
  return t;
}

bool is_before(const timespec& a, const timespec& b) {
  return a.tv_sec != b.tv_sec ? a.tv_sec < b.tv_sec : a.tv_nsec < b.tv_nsec;
}

timespec until(const timespec& deadline) {
  const timespec t = now();
  timespec rest{deadline.tv_sec - t.tv_sec, deadline.tv_nsec - t.tv_nsec};
  if (rest.tv_nsec < 0) {
    --rest.tv_sec;
    rest.tv_nsec += 1'000'000'000;
  }
  return rest.tv_sec < 0 ? timespec{} : rest;
}

[[noreturn]] void leave() {
  abandon_files();
  if (const int group = shared().group.load(); group > 0) {
    ::kill(-group, SIGKILL);
    ::waitpid(group, nullptr, 0);
  }
  ::_exit(kStopped);
}

// The results are being written. What is not yet in place is dropped.
[[noreturn]] void stop_while_finishing() {
  complain("interrupted while writing");
  leave();
}

// Was there something else to do?
bool do_instead() {
  const std::lock_guard lock(shared().mutex);
  if (shared().on_signal) shared().on_signal();
  return shared().on_signal != nullptr;
}

/// The next time, where that one has come and the work is done.
std::optional<timespec> beaten(const std::optional<timespec>& at) {
  Shared& s = shared();
  if (!s.beat.work) return std::nullopt;
  if (at && is_before(now(), *at)) return at;
  if (at && !s.ending.load()) s.beat.work(s.stage.load());
  return in_seconds(s.beat.seconds);
}

void* watch(void*) {
  Shared& s = shared();
  for (std::optional<timespec> beat;;) {
    beat = beaten(beat);
    const bool beats_first = beat && (!s.deadline || is_before(*beat, *s.deadline));
    const std::optional<timespec> next = beats_first ? beat : s.deadline;
    const timespec rest = next ? until(*next) : timespec{};
    const int signal = sigtimedwait(&s.signals, nullptr, next ? &rest : nullptr);
    if (signal < 0 && (errno == EINTR || beats_first)) continue;
    if (signal > 0 && s.ending.load()) stop_while_finishing();
    if (signal > 0 && do_instead()) continue;
    if (signal > 0) stop(signal == SIGTERM ? "terminated" : "interrupted");
    if (!s.ending.load()) stop(s.deadline_reason.c_str());
    s.deadline.reset();
  }
}

#ifndef TAUT_BOOST_NUMBERS
void* allocated(void* memory, std::size_t size) {
  if (!memory && size > 0) stop("out of memory");
  return memory;
}
void* gmp_allocate(std::size_t size) { return allocated(std::malloc(size), size); }
void* gmp_reallocate(void* old, std::size_t, std::size_t size) { return allocated(std::realloc(old, size), size); }
void gmp_free(void* memory, std::size_t) { std::free(memory); }
void prepare_numbers() { mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free); }
#else
void prepare_numbers() {}
#endif

void start_thread() {
  Shared& s = shared();
  sigemptyset(&s.signals);
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction current {};
    sigaction(signal, nullptr, &current);
    if (current.sa_handler != SIG_IGN) sigaddset(&s.signals, signal);  // nohup and the like stay respected
  }
  pthread_sigmask(SIG_BLOCK, &s.signals, nullptr);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, 512 * 1024);
  pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
  pthread_t thread{};
  const int error = pthread_create(&thread, &attributes, watch, nullptr);
  pthread_attr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), "cannot start a thread");
}

void limit_memory(std::size_t bytes) {
  shared().reserve = std::make_unique<char[]>(1 << 20);
  prepare_numbers();
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);  // one that is there already may only be lowered
  limit.rlim_cur = limit.rlim_max = std::min<rlim_t>(bytes, limit.rlim_max);
  if (setrlimit(RLIMIT_AS, &limit) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot limit the memory");
}

}  // namespace

void start_watch(const Limits& limits, Beat beat) {
  shared().beat = std::move(beat);
  if (limits.memory) mallopt(M_ARENA_MAX, 1);  // a second heap would reserve 128 MB of address space
  if (limits.seconds) {
    shared().deadline = in_seconds(*limits.seconds);
    shared().deadline_reason = fmt::format("--max-seconds {}", *limits.seconds);
  }
  start_thread();
  if (!limits.memory) return;
  if (limits.jobs > 1) start_threads(limits.jobs);  // later there may be no memory for their stacks
  limit_memory(*limits.memory);
}

void begin_stage(const char* stage) noexcept { shared().stage = stage; }

void kill_with_us(int group) noexcept { shared().group = group; }

void on_stop(std::function<void(const Stop&)> last_words) {
  const std::lock_guard lock(shared().mutex);
  shared().last_words = std::move(last_words);
}

void instead_of_stopping(std::function<void()> work) {
  const std::lock_guard lock(shared().mutex);
  shared().on_signal = std::move(work);
}

void finish() {
  if (shared().ending.exchange(true)) wait_for_the_end();
  begin_stage("");
}

void stop(const char* reason) noexcept {
  Shared& s = shared();
  if (s.ending.exchange(true)) {
    // Memory ran out while the results were written, or two threads stop at once: the first one ends the program.
    if (std::string_view(s.stage.load()).empty()) {
      complain(reason);
      leave();
    }
    wait_for_the_end();
  }
  s.reserve.reset();
  try {
    const std::string stage = s.stage.load();
    complain(stage.empty() ? fmt::format("stopped: {}", reason)
                           : fmt::format("stopped in stage `{}`: {}", stage, reason));
    const std::lock_guard lock(s.mutex);
    if (s.last_words) s.last_words({reason, stage});
  } catch (...) {
    complain("and could not write the result that says so");
  }
  leave();
}

}  // namespace taut::cli
