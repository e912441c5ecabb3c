#include <taut/search/stopwatch.h>

#include <ctime>

namespace taut {

namespace {

double now(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

Seconds now() { return {now(CLOCK_PROCESS_CPUTIME_ID), now(CLOCK_MONOTONIC)}; }

}  // namespace

Stopwatch::Stopwatch() : begin_(now()) {}

Seconds Stopwatch::seconds() const {
  const Seconds end = now();
  return {end.cpu - begin_.cpu, end.wall - begin_.wall};
}

}  // namespace taut
