#include <taut/search/stopwatch.h>

#include <ctime>

namespace taut {

namespace {

double now(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

Seconds now(Stopwatch::Of of) {
  return {now(of == Stopwatch::Of::process ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_THREAD_CPUTIME_ID), now(CLOCK_MONOTONIC)};
}

}  // namespace

Stopwatch::Stopwatch(Of of) : of_(of), begin_(now(of)) {}

Seconds Stopwatch::seconds() const {
  const Seconds end = now(of_);
  return {end.cpu - begin_.cpu, end.wall - begin_.wall};
}

}  // namespace taut
