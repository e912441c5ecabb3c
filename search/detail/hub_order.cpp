#include <queue>
#include <utility>

#include <taut/geometry/draws.h>
#include <taut/search/detail/hub_labels.h>

namespace taut::detail {

namespace {

/// A tree of shortest paths, and how many of its vertices no chosen one lies before.
struct Sample {
  std::vector<std::uint32_t> before, child, sibling;
  std::vector<std::uint32_t> behind;
};

class Coverage {
 public:
  Coverage(std::uint32_t size, std::size_t samples) : score_(size, 0), passed_(size), samples_(samples) {}

  void add(std::size_t sample, HubTree& tree, std::uint32_t root) {
    Sample& s = samples_[sample];
    const std::size_t size = score_.size();
    s.before.assign(size, kNone);
    s.child = s.sibling = s.before;
    s.behind.assign(size, 0);
    std::vector<std::uint32_t> order;
    tree.grow(root, [&](std::uint32_t v, const PrintedLength&) {
      if (s.behind[v] == 0) order.push_back(v);
      s.behind[v] = 1;
      return true;
    });
    for (const std::uint32_t v : order) {
      s.behind[v] = tree.is_needed(v);
      if (v == root) continue;
      s.before[v] = tree.before(v);
      s.sibling[v] = std::exchange(s.child[s.before[v]], v);
    }
    for (std::size_t i = order.size(); i-- > 1;) s.behind[s.before[order[i]]] += s.behind[order[i]];
    for (const std::uint32_t v : order) score_[v] += s.behind[v];
  }

  std::vector<std::uint32_t> order() {
    passed_ = score_;
    std::priority_queue<Candidate> open;
    for (std::uint32_t v = 0; v < score_.size(); ++v) open.push(candidate(v));
    std::vector<std::uint32_t> order;
    while (!open.empty()) {
      const Candidate next = open.top();
      open.pop();
      if (const Candidate now = candidate(next.vertex); now < next) {
        open.push(now);
        continue;
      }
      order.push_back(next.vertex);
      for (Sample& s : samples_) take_out(s, next.vertex);
    }
    return order;
  }

 private:
  struct Candidate {
    std::uint64_t score, passed;
    std::uint32_t vertex;

    friend auto operator<=>(const Candidate&, const Candidate&) = default;
  };
  /// Where no path is left to cover, the one that once was on most.
  Candidate candidate(std::uint32_t v) const { return {score_[v], passed_[v], v}; }

  void take_out(Sample& s, std::uint32_t v) {
    const std::uint32_t behind = s.behind[v];
    if (behind == 0) return;
    for (std::uint32_t u = s.before[v]; u != kNone; u = s.before[u]) {
      s.behind[u] -= behind;
      score_[u] -= behind;
    }
    open_.assign(1, v);
    while (!open_.empty()) {
      const std::uint32_t u = open_.back();
      open_.pop_back();
      score_[u] -= std::exchange(s.behind[u], 0);
      for (std::uint32_t c = s.child[u]; c != kNone; c = s.sibling[c])
        if (s.behind[c] != 0) open_.push_back(c);
    }
  }

  std::vector<std::uint64_t> score_, passed_;
  std::vector<Sample> samples_;
  std::vector<std::uint32_t> open_;
};

}  // namespace

std::vector<std::uint32_t> hub_order(const HubGraph& graph, HubTree& tree, std::size_t samples) {
  if (graph.size() == 0) return {};
  Coverage coverage(graph.size(), samples);
  Draws draws(1);
  for (std::size_t i = 0; i < samples; ++i) coverage.add(i, tree, draws.below(graph.size()));
  return coverage.order();
}

}  // namespace taut::detail
