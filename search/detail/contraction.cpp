#include <taut/search/detail/contraction.h>

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include <taut/geometry/length.h>

namespace taut::detail {

namespace {

using Edge = Contraction::Edge;

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr std::size_t kSettled = 60;  // of a search for another way: a superfluous edge does no harm

PrintedLength plus(const PrintedLength& a, const PrintedLength& b) {
  return {detail::plus(a.sum, b.sum), a.print + b.print};
}

class Contractor {
 public:
  Contractor(const HubGraph& graph, const BendTurns& turns)
      : turns_(turns),
        is_out_(graph.size(), false),
        depth_(graph.size(), 0),
        at_(graph.size(), kFar),
        ways_(graph.size()) {
    made_.up.resize(graph.size());
    for (std::uint32_t v = 0; v < graph.size(); ++v) add_legs(graph, v);
  }

  Contraction down_to(std::size_t core_size) && {
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
    const auto size = static_cast<std::uint32_t>(made_.up.size());
    for (std::uint32_t v = 0; v < size; ++v) open.push({cost(v), v});
    for (std::size_t left = size; left > core_size && !open.empty();) {
      const Candidate next = open.top();
      open.pop();
      if (const Candidate now{cost(next.bend), next.bend}; !open.empty() && open.top() < now) {
        open.push(now);
        continue;
      }
      take_out(next.bend);
      --left;
    }
    for (std::uint32_t v = 0; v < size; ++v)
      if (!is_out_[v]) made_.core.push_back(v);
    return std::move(made_);
  }

 private:
  struct Candidate {
    double cost;
    std::uint32_t bend;

    friend auto operator<=>(const Candidate&, const Candidate&) = default;
  };
  struct Open {
    double length;
    std::uint32_t bend;

    friend bool operator>(const Open& a, const Open& b) { return a.length > b.length; }
  };
  struct Shortcut {
    std::uint32_t from;
    Edge edge;
  };

  /// Each neighbour once: around the end of a wall a leg may be there twice.
  void add_legs(const HubGraph& graph, std::uint32_t v) {
    std::vector<Edge>& edges = made_.up[v];
    for (std::uint32_t e = graph.first[v]; e < graph.first[v + 1]; ++e) {
      const std::uint32_t to = graph.edges[e].to;
      if (std::any_of(edges.begin(), edges.end(), [&](const Edge& known) { return known.to == to; })) continue;
      edges.push_back({to, to, v, kNone, 0, 0, turns_.arriving(turns_.at(to), v), {graph.length(e), graph.print[e]}});
    }
  }

  /// Fewer edges, and neighbours that have not been taken in so often, are better.
  double cost(std::uint32_t v) {
    plan(v);
    return 2.0 * static_cast<double>(shortcuts_.size()) - static_cast<double>(made_.up[v].size()) + 0.5 * depth_[v];
  }

  /// The edges that are needed in the place of v.
  void plan(std::uint32_t v) {
    shortcuts_.clear();
    const std::vector<Edge>& edges = made_.up[v];
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      wanted_.clear();
      double farthest = 0;
      for (std::uint32_t j = i + 1; j < edges.size(); ++j) {
        if (!turns_.is_taut(turns_.at(edges[i].first_hop), edges[i].arriving, v, edges[j].first_hop, edges[j].arriving))
          continue;
        wanted_.push_back(j);
        farthest = std::max(farthest, edges[i].length.sum.high + edges[j].length.sum.high);
      }
      if (wanted_.empty()) continue;
      look_around(edges[i].to, v, farthest * (1 + kDoubt));
      for (const std::uint32_t j : wanted_) add_shortcut(v, i, j);
    }
  }

  void add_shortcut(std::uint32_t v, std::uint32_t i, std::uint32_t j) {
    const Edge &a = made_.up[v][i], &b = made_.up[v][j];
    const PrintedLength length = plus(a.length, b.length);
    if (const int order = at_[b.to] == kFar ? 1 : compare(ways_[b.to], length); order <= 0) return;
    const std::uint32_t arriving = turns_.arriving(turns_.at(a.last_hop), a.to);
    shortcuts_.push_back({a.to, {b.to, a.last_hop, b.last_hop, v, i, j, arriving, length}});
  }

  /// How far bends are from `from` without passing v, of those up to `limit` the nearest.
  void look_around(std::uint32_t from, std::uint32_t v, double limit) {
    for (const std::uint32_t u : reached_) at_[u] = kFar;
    reached_.clear();
    open_.clear();
    reach(from, {});
    for (std::size_t settled = 0; !open_.empty() && settled < kSettled;) {
      const Open next = open_.front();
      std::pop_heap(open_.begin(), open_.end(), std::greater<>());
      open_.pop_back();
      if (next.length != at_[next.bend]) continue;
      ++settled;
      for (const Edge& edge : made_.up[next.bend]) {
        const double length = next.length + edge.length.sum.high;
        if (edge.to == v || length > limit || length >= at_[edge.to]) continue;
        reach(edge.to, plus(ways_[next.bend], edge.length));
      }
    }
  }

  void reach(std::uint32_t v, const PrintedLength& length) {
    if (at_[v] == kFar) reached_.push_back(v);
    at_[v] = length.sum.high;
    ways_[v] = length;
    open_.push_back({at_[v], v});
    std::push_heap(open_.begin(), open_.end(), std::greater<>());
  }

  void take_out(std::uint32_t v) {
    plan(v);
    is_out_[v] = true;
    for (const Edge& edge : made_.up[v]) {
      std::erase_if(made_.up[edge.to], [&](const Edge& back) { return back.to == v; });
      depth_[edge.to] = std::max(depth_[edge.to], depth_[v] + 1);
    }
    for (const Shortcut& s : shortcuts_) {
      put(s.from, s.edge);
      Edge back = s.edge;
      back.to = s.from;
      std::swap(back.first_hop, back.last_hop);
      std::swap(back.first_child, back.last_child);
      back.arriving = turns_.arriving(turns_.at(back.first_hop), s.edge.to);
      put(s.edge.to, back);
    }
  }

  /// Of two edges between the same bends the shorter one stays: behind the other no shortest path goes on.
  void put(std::uint32_t from, const Edge& edge) {
    for (Edge& known : made_.up[from]) {
      if (known.to != edge.to) continue;
      const int order = compare(edge.length, known.length);
      if (order == 2 ? is_shorter_exactly(from, edge, known) : order < 0) known = edge;
      return;
    }
    made_.up[from].push_back(edge);
  }

  bool is_shorter_exactly(std::uint32_t from, const Edge& a, const Edge& b) const {
    std::vector<Segment> legs_a, legs_b;
    made_.legs(from, a, turns_, legs_a);
    made_.legs(from, b, turns_, legs_b);
    return compare_lengths(legs_a, legs_b) < 0;
  }

  const BendTurns& turns_;
  Contraction made_;
  std::vector<bool> is_out_;
  std::vector<std::uint32_t> depth_;
  std::vector<double> at_;  // of the search for other ways
  std::vector<PrintedLength> ways_;
  std::vector<std::uint32_t> reached_, wanted_;
  std::vector<Open> open_;
  std::vector<Shortcut> shortcuts_;
};

}  // namespace

void Contraction::legs(std::uint32_t from, const Edge& edge, const BendTurns& turns, std::vector<Segment>& out) const {
  if (edge.middle == kNone) {
    out.push_back({turns.at(from).point, turns.at(edge.to).point});
    return;
  }
  legs(edge.middle, up[edge.middle][edge.first_child], turns, out);
  legs(edge.middle, up[edge.middle][edge.last_child], turns, out);
}

Contraction contraction(const HubGraph& graph, const BendTurns& turns, std::size_t core_size) {
  return Contractor(graph, turns).down_to(core_size);
}

HubGraph core_graph(const Contraction& contraction, const BendTurns& turns, std::vector<std::uint32_t>& edge_of) {
  HubGraph made;
  std::vector<std::uint32_t> number(contraction.up.size(), kNone), order;
  for (std::uint32_t i = 0; i < contraction.core.size(); ++i) number[contraction.core[i]] = i;
  made.first.push_back(0);
  for (const std::uint32_t v : contraction.core) {
    const std::vector<Edge>& edges = contraction.up[v];
    order.resize(edges.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    turns.sort_around(v, order, [&](std::uint32_t i) { return edges[i].first_hop; });
    for (const std::uint32_t i : order) {
      edge_of.push_back(i);
      made.edges.push_back({edges[i].length.sum.high, number[edges[i].to], 0, 0});
      made.low.push_back(edges[i].length.sum.low);
      made.print.push_back(edges[i].length.print);
    }
    made.first.push_back(static_cast<std::uint32_t>(made.edges.size()));
  }
  made.find_backs();
  const auto hop = [&](std::uint32_t e) {
    return contraction.up[contraction.core[made.edges[made.back[e]].to]][edge_of[e]].first_hop;
  };
  for (std::uint32_t e = 0; e < made.edges.size(); ++e) {
    HubGraph::Edge& edge = made.edges[e];
    const std::uint32_t at = contraction.core[edge.to], first = made.first[edge.to], last = made.first[edge.to + 1];
    const TurnPlace& from = turns.at(hop(made.back[e]));
    const std::uint32_t arriving = turns.arriving(from, at);
    const auto side = [&](std::uint32_t next) { return turns.side(from, turns.at(at), turns.at(hop(next))); };
    std::uint32_t right = first, left = last;
    if (arriving & kMayTurnRight)
      while (right < last && side(right) <= 0) ++right;
    if (arriving & kMayTurnLeft)
      while (left > right && side(left - 1) >= 0) --left;
    edge.right = right - first;
    edge.left = left - first;
  }
  made.legs = [&contraction, &turns, &edge_of](const HubGraph& graph, std::uint32_t e, std::vector<Segment>& out) {
    const std::uint32_t from = contraction.core[graph.edges[graph.back[e]].to];
    contraction.legs(from, contraction.up[from][edge_of[e]], turns, out);
  };
  return made;
}

}  // namespace taut::detail
