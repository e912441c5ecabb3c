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
  /// Whose CPU time: of the whole process, or of the thread that made it, which then has to be the one that asks: what
  /// one item of a loop took that others share.
  enum class Of { process, thread };

  explicit Stopwatch(Of of = Of::process);
  Seconds seconds() const;

 private:
  Of of_;
  Seconds begin_;
};

}  // namespace taut
