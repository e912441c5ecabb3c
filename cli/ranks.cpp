#include <taut/cli/ranks.h>

#include <taut/io/worlds/read_world.h>

#ifdef TAUT_HAS_MPI
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <boost/mpi.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/geometry/parallel.h>

namespace taut::cli {

namespace {

namespace mpi = boost::mpi;

constexpr int kOrder = 1, kReply = 2;  // tags
constexpr int kMostTries = 3;
constexpr useconds_t kNap = 200;
constexpr std::chrono::seconds kPatience{1};

using Order = std::vector<std::size_t>;  // items; none: it is over
using Clock = std::chrono::steady_clock;

/// Items with their bytes, and those that failed with the reason.
struct Reply {
  std::vector<std::pair<std::size_t, std::string>> done, lost;

  template <typename Archive>
  void serialize(Archive& archive, unsigned) {
    archive& done& lost;
  }
};

struct Together {
  mpi::environment environment{mpi::threading::funneled, false};
  mpi::communicator world;
  bool is_over = false;  // all items came back, and nobody waits
};

std::optional<Together>& together() {
  static std::optional<Together> ranks;
  return ranks;
}

/// MPI alone would take a whole core to wait.
mpi::status wait_for(const mpi::communicator& world, int tag) {
  for (;;) {
    if (const auto status = world.iprobe(mpi::any_source, tag)) return *status;
    ::usleep(kNap);
  }
}

/// Of tests: TAUT_LOSE=RANK fails at that rank's first item, TAUT_LOSE=RANK:SECONDS is at it for so long.
void lose_for_a_test(int rank) {
  static std::atomic<bool> is_lost{false};
  const char* const wish = std::getenv("TAUT_LOSE");
  if (wish == nullptr || std::atoi(wish) != rank || is_lost.exchange(true)) return;
  const std::string text = wish;
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) throw std::runtime_error("lost for a test");
  ::sleep(static_cast<unsigned>(std::stoul(text.substr(colon + 1))));
}

Reply done_by(const Order& order, const std::function<std::function<std::string(std::size_t)>()>& begin, unsigned jobs,
              int rank) {
  std::vector<std::string> bytes(order.size()), reasons(order.size());
  each_in_parallel(order.size(), {jobs}, [&] {
    return [&, work = begin()](std::size_t i) {
      try {
        lose_for_a_test(rank);
        bytes[i] = work(order[i]);
      } catch (const std::exception& error) {
        reasons[i] = error.what();
      }
    };
  });
  Reply reply;
  for (std::size_t i = 0; i < order.size(); ++i)
    (reasons[i].empty() ? reply.done : reply.lost)
        .emplace_back(order[i], std::move(reasons[i].empty() ? bytes[i] : reasons[i]));
  return reply;
}

[[noreturn]] void serve(Together& ranks, const Items& items, unsigned jobs) {
  items.prepare();
  Reply reply;
  for (;;) {
    ranks.world.send(0, kReply, reply);
    wait_for(ranks.world, kOrder);
    Order order;
    ranks.world.recv(0, kOrder, order);
    if (order.empty()) break;
    reply = done_by(order, items.begin, jobs, ranks.world.rank());
  }
  together().reset();  // waits for the others
  ::_exit(0);
}

/// What the first rank does.
class Dispatcher {
 public:
  Dispatcher(Together& ranks, const Items& items, unsigned jobs, double lost_after,
             const std::function<void(std::size_t, std::string_view)>& take)
      : world_(ranks.world), count_(items.count), jobs_(jobs), lost_after_(lost_after), take_(take) {
    for (std::size_t i = 0; i < count_; ++i) open_.insert(open_.end(), i);
  }

  /// True when no rank is still at something.
  bool run() {
    while (next_ < count_) {
      if (const auto status = world_.iprobe(mpi::any_source, kReply)) {
        hear(status->source());
      } else {
        ::usleep(kNap);
        look_for_lost();
      }
      while (!idle_.empty() && !open_.empty()) give();
    }
    dismiss();
    return at_work_.empty();
  }

 private:
  struct Given {
    std::size_t item;
    Clock::time_point since;
    bool is_named = false;
  };

  /// All that come within a while: some have still to hear that another one did what they are at, or to begin.
  void dismiss() {
    const Clock::time_point end = Clock::now() + kPatience;
    for (int left = world_.size() - 1; left > 0 && (at_work_.empty() || Clock::now() < end);) {
      if (idle_.empty())
        if (const auto status = world_.iprobe(mpi::any_source, kReply)) hear(status->source());
      left -= static_cast<int>(idle_.size());
      for (const int rank : std::exchange(idle_, {})) world_.send(rank, kOrder, Order{});
      if (left > 0) ::usleep(kNap);
    }
  }

  void hear(int rank) {
    Reply reply;
    world_.recv(rank, kReply, reply);
    at_work_.erase(rank);
    for (auto& [item, bytes] : reply.done)
      if (item >= next_) results_.emplace(item, std::move(bytes));
    for (const auto& [item, reason] : reply.lost)
      lose(item, fmt::format("was lost by rank {}: {}", rank, reason), true);
    idle_.push_back(rank);
    for (auto at = results_.find(next_); at != results_.end(); at = results_.find(next_)) {
      take_(next_++, at->second);
      results_.erase(at);
    }
  }

  void lose(std::size_t item, const std::string& how, bool has_failed) {
    complain(fmt::format("item {} {}; given again", item, how));
    if (has_failed && ++failures_[item] >= kMostTries)
      throw std::runtime_error(fmt::format("item {} {}, for the {}rd time", item, how, kMostTries));
    open_.insert(item);
  }

  void look_for_lost() {
    if (idle_.empty() || !open_.empty()) return;
    for (auto& [rank, all] : at_work_)
      for (Given& given : all)
        if (!given.is_named && std::chrono::duration<double>(Clock::now() - given.since).count() > lost_after_) {
          given.is_named = true;
          if (given.item >= next_ && !results_.contains(given.item))
            lose(given.item, fmt::format("did not come back from rank {} for {} s", rank, lost_after_), false);
        }
  }

  void give() {
    const int rank = idle_.front();
    idle_.erase(idle_.begin());
    Order order;
    while (order.size() < jobs_ && !open_.empty()) {
      order.push_back(*open_.begin());
      open_.erase(open_.begin());
      at_work_[rank].push_back({order.back(), Clock::now()});
    }
    world_.send(rank, kOrder, order);
  }

  const mpi::communicator& world_;
  std::size_t count_, jobs_;
  double lost_after_;
  const std::function<void(std::size_t, std::string_view)>& take_;
  std::set<std::size_t> open_;
  std::map<int, std::vector<Given>> at_work_;  // by rank
  std::vector<int> idle_;
  std::map<std::size_t, std::string> results_;  // that wait for those before them
  std::map<std::size_t, int> failures_;
  std::size_t next_ = 0;
};

void do_alone(const Items& items, unsigned jobs, const std::function<void(std::size_t, std::string_view)>& take) {
  items.prepare();
  std::vector<std::string> results(items.count);
  std::size_t taken = 0;
  const auto take_until = [&](std::size_t over) {
    for (; taken < over; ++taken) take(taken, std::exchange(results[taken], {}));
  };
  each_in_parallel(items.count, {jobs, {}, take_until},
                   [&] { return [&, work = items.begin()](std::size_t i) { results[i] = work(i); }; });
}

}  // namespace

void join_ranks(CommonOptions& options) {
  // Its threads do not take the signals that the program waits for.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  together().emplace();
  if (together()->world.rank() == 0) return;
  options.quiet = true;
  options.json.clear();
  const int nothing = ::open("/dev/null", O_WRONLY);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(nothing, STDERR_FILENO);
  ::close(nothing);
}

bool are_ranks_joined() { return together().has_value(); }

std::string bytes_for_all(const std::string& file) {
  if (!together()) return read_bytes(file);
  std::string bytes;
  if (together()->world.rank() == 0) bytes = read_bytes(file);
  mpi::broadcast(together()->world, bytes, 0);
  return bytes;
}

void do_by_ranks(const Items& items, const Limits& limits, double lost_after,
                 const std::function<void(std::size_t, std::string_view)>& take) {
  Together& ranks = *together();
  if (ranks.world.rank() > 0) serve(ranks, items, limits.jobs);
  if (ranks.world.size() == 1) do_alone(items, limits.jobs, take);
  ranks.is_over = ranks.world.size() == 1 || Dispatcher(ranks, items, limits.jobs, lost_after, take).run();
}

void leave_ranks(int code) {
  if (!together()) return;
  if (!together()->is_over) together()->world.abort(code);
  together().reset();
}

}  // namespace taut::cli

#else

namespace taut::cli {

void join_ranks(CommonOptions&) {
  throw UsageError("--mpi: this taut was built without MPI; configure it with -DTAUT_MPI=ON");
}

bool are_ranks_joined() { return false; }

std::string bytes_for_all(const std::string& file) { return read_bytes(file); }

void do_by_ranks(const Items&, const Limits&, double, const std::function<void(std::size_t, std::string_view)>&) {}

void leave_ranks(int) {}

}  // namespace taut::cli

#endif
