#include <taut/search/detail/arc_hierarchy.h>

#include <algorithm>
#include <queue>

namespace taut::detail {

namespace {

using Edge = ArcHierarchy::Edge;

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostShortcuts = 8;  // in the place of a node that is taken out
constexpr std::size_t kSettled = 16;       // of a search for another way: a superfluous edge does no harm

class Contractor {
 public:
  explicit Contractor(const TurnableGraph& graph)
      : turned_(graph.turned), out_(graph.size()), depth_(graph.size(), 0), at_(graph.size(), kFar) {
    for (std::uint32_t n = 0; n < graph.size(); ++n)
      for (std::uint32_t e = graph.first[n]; e < graph.first[n + 1]; ++e)
        put(n, {graph.edges[e].to, kNone, graph.edges[e].length});
  }

  /// Of the core, to one another. is_core: of each node.
  std::vector<std::vector<Edge>> edges_up(std::vector<std::uint8_t>& is_core) && {
    is_core.assign(turned_.size(), 1);
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
    for (std::uint32_t n = 0; n < turned_.size(); ++n)
      if (n <= turned_[n]) open.push({cost(n), n});
    while (!open.empty()) {
      const Candidate next = open.top();
      open.pop();
      if (const Candidate now{cost(next.node), next.node}; !open.empty() && open.top() < now) {
        open.push(now);
        continue;
      }
      if (shortcuts_.size() > kMostShortcuts) break;
      take_out(next.node);
      is_core[next.node] = is_core[turned_[next.node]] = 0;
    }
    return std::move(out_);
  }

 private:
  struct Candidate {
    double cost;
    std::uint32_t node;

    friend auto operator<=>(const Candidate&, const Candidate&) = default;
  };
  struct Open {
    double length;
    std::uint32_t node;

    friend bool operator>(const Open& a, const Open& b) { return a.length > b.length; }
  };
  struct Shortcut {
    std::uint32_t from;
    Edge edge;
  };

  /// Fewer edges, and neighbours that have not been taken in so often, are better.
  double cost(std::uint32_t n) {
    plan(n);
    const double ends = static_cast<double>(out_[n].size() + out_[turned_[n]].size());
    return 2.0 * static_cast<double>(shortcuts_.size()) - ends + 0.5 * depth_[n];
  }

  /// The edges that are needed in the place of n; those of its turned node are these turned.
  void plan(std::uint32_t n) {
    shortcuts_.clear();
    const std::vector<Edge>& in = out_[turned_[n]];
    const std::vector<Edge>& out = out_[n];
    const bool looks = in.size() > 1 && out.size() > 1;
    for (const Edge& a : in) {
      const std::uint32_t from = turned_[a.to];
      if (looks) look_around(from, n, farthest(out) + a.length);
      for (const Edge& b : out)
        if (b.to != from && b.to != a.to && !(looks && at_[b.to] <= a.length + b.length))
          shortcuts_.push_back({from, {b.to, n, a.length + b.length}});
    }
  }

  static double farthest(const std::vector<Edge>& edges) {
    double most = 0;
    for (const Edge& edge : edges) most = std::max(most, edge.length);
    return most;
  }

  /// How far nodes are from `from` without passing n, of those up to `limit` the nearest.
  void look_around(std::uint32_t from, std::uint32_t n, double limit) {
    for (const std::uint32_t u : reached_) at_[u] = kFar;
    reached_.clear();
    open_.clear();
    reach(from, 0);
    for (std::size_t settled = 0; !open_.empty() && settled < kSettled;) {
      const Open next = open_.front();
      std::pop_heap(open_.begin(), open_.end(), std::greater<>());
      open_.pop_back();
      if (next.length != at_[next.node]) continue;
      ++settled;
      for (const Edge& edge : out_[next.node]) {
        const double length = next.length + edge.length;
        if (edge.to != n && edge.to != turned_[n] && length <= limit && length < at_[edge.to]) reach(edge.to, length);
      }
    }
  }

  void reach(std::uint32_t n, double length) {
    if (at_[n] == kFar) reached_.push_back(n);
    at_[n] = length;
    open_.push_back({length, n});
    std::push_heap(open_.begin(), open_.end(), std::greater<>());
  }

  void take_out(std::uint32_t n) {
    plan(n);
    leave(n, turned_[n]);
    if (turned_[n] != n) leave(turned_[n], n);
    for (const Shortcut& s : shortcuts_) {
      put(s.from, s.edge);
      put(turned_[s.edge.to], {turned_[s.from], turned_[n], s.edge.length});
    }
  }

  /// What leads from n keeps its edges no more, as far as they lead back to the turned n.
  void leave(std::uint32_t n, std::uint32_t back) {
    for (const Edge& edge : out_[n]) {
      const std::uint32_t to = turned_[edge.to];
      std::erase_if(out_[to], [&](const Edge& e) { return e.to == back; });
      depth_[to] = depth_[edge.to] = std::max(depth_[to], depth_[n] + 1);
    }
  }

  /// Of two edges between the same nodes the shorter one stays.
  void put(std::uint32_t from, const Edge& edge) {
    if (edge.to == from || edge.to == turned_[from]) return;
    for (Edge& known : out_[from]) {
      if (known.to != edge.to) continue;
      if (edge.length < known.length) known = edge;
      return;
    }
    out_[from].push_back(edge);
  }

  const std::vector<std::uint32_t>& turned_;
  std::vector<std::vector<Edge>> out_;
  std::vector<std::uint32_t> depth_;
  std::vector<double> at_;  // of the search for other ways
  std::vector<std::uint32_t> reached_;
  std::vector<Open> open_;
  std::vector<Shortcut> shortcuts_;
};

}  // namespace

ArcHierarchy::ArcHierarchy(const TurnableGraph& graph) : turned_(graph.turned) {
  const std::vector<std::vector<Edge>> up = Contractor(graph).edges_up(is_core_);
  first_.push_back(0);
  for (const std::vector<Edge>& edges : up) {
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    first_.push_back(static_cast<std::uint32_t>(edges_.size()));
  }
}

const Edge& ArcHierarchy::edge_to(std::uint32_t from, std::uint32_t to) const {
  const std::span<const Edge> edges = up(from);
  return *std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) { return edge.to == to; });
}

void ArcHierarchy::follow(std::uint32_t from, const Edge& edge, std::vector<std::uint32_t>& nodes) const {
  follow(from, edge.to, edge.middle, nodes);
}

/// The way down to the middle is one up, turned.
void ArcHierarchy::follow(std::uint32_t from, std::uint32_t to, std::uint32_t middle,
                          std::vector<std::uint32_t>& nodes) const {
  if (middle == kNone) return nodes.push_back(to);
  const std::uint32_t before = edge_to(turned_[middle], turned_[from]).middle;
  follow(from, middle, before == kNone ? kNone : turned_[before], nodes);
  follow(middle, to, edge_to(middle, to).middle, nodes);
}

}  // namespace taut::detail
