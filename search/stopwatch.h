// How long something took.
#pragma once

namespace taut {

/// A span of time: of all threads of the process, and by the clock on the wall. What is compared is `cpu`, which a busy
/// machine does not lengthen.
struct Seconds {
  double cpu = 0;
  double wall = 0;

  Seconds& operator+=(const Seconds& s) {
    cpu += s.cpu;
    wall += s.wall;
    return *this;
  }
};

/// Runs from the moment it is made. Asking costs under a microsecond.
class Stopwatch {
 public:
  Stopwatch();
  Seconds seconds() const;

 private:
  Seconds begin_;
};

}  // namespace taut
