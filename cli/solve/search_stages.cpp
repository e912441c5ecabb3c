#include <taut/cli/solve/search_stages.h>

#include <algorithm>
#include <new>

#include <taut/search/stopwatch.h>

namespace taut::cli {

namespace {

constexpr std::size_t kConesABend = 16;
constexpr std::size_t kNodesABend = 16;
constexpr double kWinding = 1.1;
constexpr std::size_t kManyBends = 20000;

}  // namespace

std::size_t SearchStages::stage_of(std::size_t number) const {
  return static_cast<std::size_t>(std::upper_bound(from_.begin(), from_.end(), number) - from_.begin()) - 1;
}

bool SearchStages::weigh(const QueryAnswer& answer) {
  if (is_settled()) return false;
  ++weighed_;
  if (answer.status != QueryAnswer::Status::found) return false;
  nodes_ += answer.nodes;
  lengths_ += answer.length;
  straight_ += answer.straight;
  const std::size_t bends = now().mesh().bends.size();
  return nodes_ > (now().has_graph() ? kNodesABend : kConesABend) * bends && lengths_ > kWinding * straight_;
}

Seconds SearchStages::go_on() {
  const Stopwatch watch;
  const std::size_t bends = now().mesh().bends.size();
  try {
    made_.push_back(now().has_graph() ? now().with_landmarks(bends > kManyBends ? 16 : 8) : now().with_graph(jobs_));
    from_.push_back(weighed_);
  } catch (const std::bad_alloc&) {
    is_full_ = true;
  }
  nodes_ = 0;
  return watch.seconds();
}

}  // namespace taut::cli
