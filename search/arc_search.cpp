#include <taut/search/arc_search.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <taut/search/detail/arc_ends.h>
#include <taut/search/detail/arc_hierarchy_query.h>
#include <taut/search/detail/arc_walk.h>

namespace taut {

namespace {

using detail::ArcEnds;
using detail::ArcExit;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kUnprepared = 24;  // queries

std::optional<ArcSearchResult> blocked(const TangentParts& graph, Point p, DiscStatus status) {
  if (graph.walls().space().locate(p).kind == Location::Kind::outside) return ArcSearchResult{status, {}, kNone, 0};
  const std::uint32_t wall = graph.walls().too_near(p, graph.r);
  if (wall == kNone) return std::nullopt;
  return ArcSearchResult{status, {}, wall, 0};
}

}  // namespace

struct ArcQueries::Impl {
  explicit Impl(TangentGraph of)
      : tangents(std::move(of)), graph(tangents.parts()), walk(graph), labels(walk.nodes()) {}

  ArcSearchResult find(Point s, Point g) {
    if (auto at_start = blocked(graph, s, DiscStatus::start_blocked)) return *at_start;
    if (auto at_goal = blocked(graph, g, DiscStatus::goal_blocked)) return *at_goal;
    if (s == g) return {DiscStatus::found, {graph.r, s, g, {}, {}}, kNone, 0};
    if (!prepared && ++queries > kUnprepared) prepare();
    ends = detail::join_ends(graph, s, g);
    return prepared ? prepared_search(s, g) : search(s, g);
  }

  void prepare() {
    if (!prepared) prepared = std::make_unique<Prepared>(turnable());
  }

 private:
  static constexpr std::uint32_t kStart = kNone;

  struct Label {
    Interval length;
    double estimate = 0;  // of what is left
    std::uint32_t before = kStart;
    std::uint32_t version = 0;
    std::uint32_t query = 0;
  };
  struct Open {
    double least;
    std::uint32_t node;
    std::uint32_t version;
    bool operator<(const Open& other) const { return least != other.least ? least > other.least : node > other.node; }
  };
  /// The best way to the goal so far: along `node` and out, or apart from the graph.
  struct Best {
    Interval length{kInfinite};
    std::uint32_t node = kNone;
    std::uint32_t number = 0;  // of the exit, or of the way apart
    bool found = false;
  };

  struct Prepared {
    explicit Prepared(const detail::TurnableGraph& of) : hierarchy(of), query(hierarchy) {}

    detail::ArcHierarchy hierarchy;
    detail::ArcHierarchyQuery query;
  };

  detail::TurnableGraph turnable() {
    detail::TurnableGraph result;
    result.first.push_back(0);
    for (std::uint32_t n = 0; n < walk.nodes(); ++n) {
      result.turned.push_back(walk.turned(n));
      const bool is_used = n % 2 == 0 || walk.turned(n) != n;
      if (is_used)
        walk.onward(n, [&](std::uint32_t m, const Interval& length) { result.edges.push_back({m, length.middle()}); });
      result.first.push_back(static_cast<std::uint32_t>(result.edges.size()));
    }
    return result;
  }

  /// Lengths are sums of doubles here: off by less than the enclosures of their pieces are wide.
  ArcSearchResult prepared_search(Point s, Point g) {
    const auto doors = [](const std::vector<ArcExit>& all) {
      std::vector<detail::ArcDoor> result;
      result.reserve(all.size());
      for (const ArcExit& door : all) result.push_back({door.node, door.length.middle()});
      return result;
    };
    const detail::ArcHierarchyQuery::Way way = prepared->query.find(doors(ends.entries), doors(ends.exits));
    const auto apart = std::min_element(
        ends.apart.begin(), ends.apart.end(),
        [](const ArcEnds::Apart& a, const ArcEnds::Apart& b) { return a.length.middle() < b.length.middle(); });
    ArcSearchResult result;
    result.expanded = way.settled;
    if (apart != ends.apart.end() && apart->length.middle() <= way.length)
      result.path = path_apart(s, g, *apart);
    else if (!way.nodes.empty())
      result.path = path(s, g, ends.entries[way.entry], way.nodes, ends.exits[way.exit]);
    else
      return result;
    result.status = DiscStatus::found;
    return result;
  }

  ArcSearchResult search(Point s, Point g) {
    ++query;
    goal = g;
    open.clear();
    best = {};
    for (std::uint32_t i = 0; i < ends.apart.size(); ++i) arrive(ends.apart[i].length, kNone, i);
    for (std::uint32_t i = 0; i < ends.entries.size(); ++i)
      reach(ends.entries[i].node, ends.entries[i].length, kStart - 1 - i);
    ArcSearchResult result;
    while (!open.empty()) {
      const Open next = open.front();
      if (next.least > best.length.hi) break;
      std::pop_heap(open.begin(), open.end());
      open.pop_back();
      if (next.version != labels[next.node].version) continue;
      ++result.expanded;
      expand(next.node);
    }
    if (!best.found) return result;
    result.status = DiscStatus::found;
    result.path = path(s, g);
    return result;
  }

  void arrive(const Interval& length, std::uint32_t node, std::uint32_t number) {
    if (!best.found || length.hi < best.length.lo) best = {length, node, number, true};
  }

  double estimate(std::uint32_t n) const {
    const TangentPoint& p = graph.points[n / 2];
    const double r = p.here.side == 0 ? 0 : graph.r;
    const double x = p.here.centre.x + r * p.x.middle() - goal.x, y = p.here.centre.y + r * p.y.middle() - goal.y;
    const double far = std::sqrt(x * x + y * y);
    return std::max(0.0, far - 1e-13 * (far + std::abs(goal.x) + std::abs(goal.y)));
  }

  void reach(std::uint32_t n, const Interval& length, std::uint32_t before) {
    Label& label = labels[n];
    if (label.query != query)
      label = {Interval(kInfinite), estimate(n), kStart, label.version, query};
    else if (length.hi >= label.length.lo)
      return;
    const double least = std::max(0.0, length.lo) + label.estimate;
    if (!(least <= best.length.hi)) return;
    label.length = length;
    label.before = before;
    open.push_back({least, n, ++label.version});
    std::push_heap(open.begin(), open.end());
  }

  void expand(std::uint32_t n) {
    const Interval so_far = labels[n].length;
    for (std::uint32_t i = 0; i < ends.exits.size(); ++i)
      if (ends.exits[i].node == n) arrive(so_far + ends.exits[i].length, n, i);
    walk.onward(n, [&](std::uint32_t m, const Interval& length) { reach(m, so_far + length, n); });
  }

  bool is_entry(std::uint32_t before) const { return before >= kStart - ends.entries.size() && before < kStart; }

  ArcPath path(Point s, Point g) const {
    if (best.node == kNone) return path_apart(s, g, ends.apart[best.number]);
    std::vector<std::uint32_t> nodes;
    std::uint32_t n = best.node;
    for (; !is_entry(n); n = labels[n].before) nodes.push_back(n);
    std::reverse(nodes.begin(), nodes.end());
    return path(s, g, ends.entries[kStart - 1 - n], nodes, ends.exits[best.number]);
  }

  ArcPath path_apart(Point s, Point g, const ArcEnds::Apart& apart) const {
    ArcPath path{graph.r, s, g, {}, {}};
    if (apart.by_arc) path.bends.push_back(bend_of(ends.from_start[apart.start_leg]));
    path.length = length_of(pieces(path));
    return path;
  }

  ArcPath path(Point s, Point g, const ArcExit& entry, const std::vector<std::uint32_t>& nodes,
               const ArcExit& exit) const {
    ArcPath path{graph.r, s, g, {}, {}};
    // The stops: the site and the side, and how many points of its circle the path stops at.
    std::vector<std::pair<ArcBend, std::size_t>> stops;
    std::uint32_t last = kNone;
    const auto stop = [&](std::uint32_t site, int side) {
      if (site == last) return void(++stops.back().second);
      last = site;
      stops.push_back({{graph.sites()[site].at, graph.sites()[site].round ? side : 0}, 1});
    };
    if (entry.by_arc) stop(ends.from_start[entry.leg].site, ends.from_start[entry.leg].side);
    for (const std::uint32_t n : nodes) stop(graph.site_of[n / 2], n % 2 == 1 ? 1 : -1);
    if (exit.by_arc) stop(ends.to_goal[exit.leg].site, ends.to_goal[exit.leg].side);
    for (const auto& [bend, points] : stops)
      if (bend.turn == 0 || points > 1) path.bends.push_back(bend);
    path.length = length_of(pieces(path));
    return path;
  }

  ArcBend bend_of(const detail::ArcEndLeg& leg) const {
    const TangentSite& site = graph.sites()[leg.site];
    return {site.at, site.round ? leg.side : 0};
  }

 public:
  TangentGraph tangents;

 private:
  const TangentParts& graph;
  detail::ArcWalk walk;
  std::vector<Label> labels;
  std::vector<Open> open;
  std::unique_ptr<Prepared> prepared;
  ArcEnds ends;
  Best best;
  Point goal;
  std::size_t queries = 0;
  std::uint32_t query = 0;
};

ArcQueries::ArcQueries(TangentGraph graph) : impl_(std::make_unique<Impl>(std::move(graph))) {}
ArcQueries::~ArcQueries() = default;
ArcQueries::ArcQueries(ArcQueries&&) noexcept = default;
ArcQueries& ArcQueries::operator=(ArcQueries&&) noexcept = default;

const TangentGraph& ArcQueries::graph() const { return impl_->tangents; }
ArcSearchResult ArcQueries::find(Point s, Point g) { return impl_->find(s, g); }
void ArcQueries::prepare() { impl_->prepare(); }

ArcSearchResult arc_search(const TangentGraph& graph, Point s, Point g) { return ArcQueries(graph).find(s, g); }

}  // namespace taut
