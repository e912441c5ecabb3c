#include <taut/geometry/parallel.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <taut/geometry/detail/crew.h>

namespace taut {

namespace {

using Work = std::function<void(std::size_t)>;

/// Items are handed out by one counter, so when one fails all before it were begun and will be finished: which failure
/// is the lowest does not depend on the threads.
class Loop {
 public:
  Loop(std::size_t count, const Parallel& how, const std::function<Work()>& begin)
      : count_(count), how_(how), begin_(begin), over_(how.finished ? count : 0, false) {}

  void run() {
    const auto jobs = static_cast<unsigned>(std::min<std::size_t>(how_.jobs, count_));
    if (jobs <= 1) {
      take_part();
    } else {
      share(jobs);
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  /// What the caller wrote is seen by the threads that join it, and what they wrote by the caller.
  void share(unsigned jobs) {
    doors_.store(1, std::memory_order_release);
    detail::work_together(
        jobs,
        [](void* loop) {
          Loop& self = *static_cast<Loop*>(loop);
          self.doors_.load(std::memory_order_acquire);
          self.take_part();
          self.doors_.fetch_add(1, std::memory_order_release);
        },
        this);
    doors_.load(std::memory_order_acquire);
  }

  void take_part() {
    Work work;
    const bool is_caller = std::this_thread::get_id() == caller_;
    while (!is_over_.load()) {
      if (is_caller && how_.is_over && asked()) return;
      const std::size_t item = next_++;
      if (item >= count_) return;
      try {
        if (!work) work = begin_();
        work(item);
        note_finished(item);
      } catch (...) {
        fail(item);
      }
    }
  }

  bool asked() {
    try {
      if (!how_.is_over()) return false;
      is_over_ = true;
    } catch (...) {
      fail(count_);
    }
    return true;
  }

  void note_finished(std::size_t item) {
    if (!how_.finished) return;
    const std::lock_guard lock(mutex_);
    over_[item] = true;
    const std::size_t before = prefix_;
    while (prefix_ < count_ && over_[prefix_]) ++prefix_;
    if (prefix_ > before) how_.finished(prefix_);
  }

  void fail(std::size_t item) {
    is_over_ = true;
    const std::lock_guard lock(failing_);
    if (failure_ && failed_ <= item) return;
    failure_ = std::current_exception();
    failed_ = item;
  }

  const std::size_t count_;
  const Parallel& how_;
  const std::function<Work()>& begin_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<unsigned> doors_{0};  // that were passed
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> is_over_{false};
  std::mutex mutex_;  // of over_ and prefix_, and of how_.finished
  std::vector<bool> over_;
  std::size_t prefix_ = 0;
  std::mutex failing_;
  std::exception_ptr failure_;
  std::size_t failed_ = 0;
};

}  // namespace

unsigned core_count() { return static_cast<unsigned>(std::max(1, detail::cores())); }

void each_in_parallel(std::size_t count, const Parallel& how, const std::function<void(std::size_t)>& work) {
  const std::function<Work()> begin = [&work] { return [&work](std::size_t item) { work(item); }; };
  Loop(count, how, begin).run();
}

void each_in_parallel(std::size_t count, const Parallel& how, const std::function<Work()>& begin) {
  Loop(count, how, begin).run();
}

void start_threads(unsigned jobs) {
  // Each is busy until all are, or for so long that there are no more.
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
  std::atomic<unsigned> begun{0};
  each_in_parallel(jobs, {jobs}, [&](std::size_t) {
    ++begun;
    while (begun < jobs && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  });
}

std::size_t block_length(std::size_t count, unsigned jobs, std::size_t least, std::size_t blocks) {
  if (jobs <= 1) return std::max<std::size_t>(count, 1);
  return std::max(least, count / (std::size_t{jobs} * blocks) + 1);
}

}  // namespace taut
