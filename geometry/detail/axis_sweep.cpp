#include <taut/geometry/detail/axis_sweep.h>

#include <algorithm>
#include <stdexcept>

#include <taut/geometry/detail/rank_set.h>

namespace taut::detail {

namespace {

/// A vertex on the rim, and what lies below the way to the next: a half-edge, or with kSlot an edge, of which the
/// triangle on one side or on neither is known.
struct Node {
  std::uint32_t vertex;
  std::uint32_t before = kNone;
  std::uint32_t next = kNone;
  std::uint32_t link = kNone;
};

constexpr std::uint32_t kSlot = 0x80000000;

/// The rim between two vertical edges: nodes.
struct Rim {
  std::uint32_t head = kNone;
  std::uint32_t tail = kNone;
  std::uint32_t last = kNone;  ///< the one that came last
};

class Sweep {
 public:
  Sweep(std::span<const LatticePoint> points, std::span<const AxisStar> stars, std::size_t edge_count)
      : points_(points), stars_(stars), edge_count_(edge_count), rank_of_(ranks()), active_(rank_count_ + 1) {
    rims_.resize(rank_count_ + 1);
    half_of_.assign(edge_count, kNone);
    active_.insert(0);  // what lies left of everything
    nodes_.reserve(points.size() / 4);
    mesh_.reserve(2 * points.size());
  }

  std::vector<RawTriangle> run() {
    for (std::uint32_t v = 0; v < points_.size(); ++v) pass(v);
    return std::move(mesh_);
  }

 private:
  /// By point: 1 + the number of different x below its own.
  std::vector<std::uint32_t> ranks() {
    std::vector<std::int32_t> xs(points_.size());
    for (std::size_t i = 0; i < xs.size(); ++i) xs[i] = points_[i].x;
    std::vector<std::uint32_t> result(xs.size());
    const auto [least, most] = std::minmax_element(xs.begin(), xs.end());
    if (xs.empty() || static_cast<std::size_t>(*most - *least) < 4 * xs.size()) {
      for (std::size_t i = 0; i < xs.size(); ++i) result[i] = 1 + static_cast<std::uint32_t>(points_[i].x - *least);
      rank_count_ = xs.empty() ? 0 : 1 + static_cast<std::size_t>(*most - *least);
      return result;
    }
    std::sort(xs.begin(), xs.end());
    xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = 1 + static_cast<std::uint32_t>(std::lower_bound(xs.begin(), xs.end(), points_[i].x) - xs.begin());
    rank_count_ = xs.size();
    return result;
  }

  /// Does c lie to the left of a -> b?
  bool turns_left(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const LatticePoint p = points_[a], q = points_[b], r = points_[c];
    return (std::int64_t{q.x} - p.x) * (std::int64_t{r.y} - p.y) >
           (std::int64_t{q.y} - p.y) * (std::int64_t{r.x} - p.x);
  }

  std::uint32_t add_node(std::uint32_t vertex) {
    if (spare_.empty()) {
      nodes_.push_back({vertex});
      return static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    const std::uint32_t n = spare_.back();
    spare_.pop_back();
    nodes_[n] = {vertex};
    return n;
  }

  /// The half-edge and what lies across.
  void join(std::uint32_t half, std::uint32_t link) {
    if (!(link & kSlot)) {
      mesh_[half / 3].twins[half % 3] = link;
      mesh_[link / 3].twins[link % 3] = half;
      return;
    }
    const std::uint32_t slot = link & ~kSlot;
    if (slot < edge_count_) mesh_[half / 3].edges[half % 3] = slot;
    if (half_of_[slot] == kNone)
      half_of_[slot] = half;
    else
      join(half, half_of_[slot]);
  }

  /// The triangle of a node, the next and v above them: its first half-edge. What lies below is joined.
  std::uint32_t add_triangle(std::uint32_t node, std::uint32_t v) {
    const auto half = static_cast<std::uint32_t>(3 * mesh_.size());
    mesh_.push_back(
        {{nodes_[node].vertex, nodes_[nodes_[node].next].vertex, v}, {kNone, kNone, kNone}, {kNone, kNone, kNone}});
    join(half + 2, nodes_[node].link);
    return half;
  }

  bool sees(std::uint32_t node, std::uint32_t v) const {
    return turns_left(nodes_[node].vertex, nodes_[nodes_[node].next].vertex, v);
  }

  /// Joins v with what it sees of the rim to the left of node n, whose way to v is `link`. Returns the way from the
  /// first node on that is still on the rim, which n becomes.
  std::uint32_t fill_left(const Rim& rim, std::uint32_t& n, std::uint32_t v, std::uint32_t link) {
    while (n != rim.head && sees(nodes_[n].before, v)) {
      const std::uint32_t p = nodes_[n].before, half = add_triangle(p, v);
      join(half, link);
      link = half + 1;
      n = p;
    }
    return link;
  }

  std::uint32_t fill_right(const Rim& rim, std::uint32_t& n, std::uint32_t v, std::uint32_t link) {
    while (n != rim.tail && sees(n, v)) {
      const std::uint32_t half = add_triangle(n, v);
      join(half + 1, link);
      link = half;
      n = nodes_[n].next;
    }
    return link;
  }

  /// Gives back the nodes after `from` up to `to`, not including either.
  void drop_between(std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t n = nodes_[from].next; n != to; n = nodes_[n].next) spare_.push_back(n);
  }

  void connect(std::uint32_t a, std::uint32_t b, std::uint32_t link) {
    nodes_[a].next = b;
    nodes_[a].link = link;
    nodes_[b].before = a;
  }

  /// The rim after v, where its right edge ends.
  Rim end_right(const Rim& rim, std::uint32_t v, std::uint32_t edge) {
    std::uint32_t n = rim.tail;
    const std::uint32_t link = fill_left(rim, n, v, edge | kSlot);
    for (std::uint32_t m = rim.tail; m != n; m = nodes_[m].before) spare_.push_back(m);
    const std::uint32_t end = add_node(v);
    connect(n, end, link);
    return {rim.head, end, end};
  }

  Rim end_left(const Rim& rim, std::uint32_t v, std::uint32_t edge) {
    std::uint32_t n = rim.head;
    const std::uint32_t link = fill_right(rim, n, v, edge | kSlot);
    for (std::uint32_t m = rim.head; m != n; m = nodes_[m].next) spare_.push_back(m);
    const std::uint32_t end = add_node(v);
    connect(end, n, link);
    return {end, rim.tail, end};
  }

  /// Both edges end at v: all of the rim is filled.
  void close(const Rim& rim, std::uint32_t v, std::uint32_t left, std::uint32_t right) {
    std::uint32_t n = rim.head;
    const std::uint32_t link = fill_right(rim, n, v, left | kSlot);
    if (n != rim.tail || (link & kSlot)) throw std::logic_error("edges meet elsewhere than at their ends");
    join(link, right | kSlot);
    for (std::uint32_t m = rim.head; m != rim.tail; m = nodes_[m].next) spare_.push_back(m);
    spare_.push_back(rim.tail);
  }

  /// No edge ends at v: it is joined with the point that came last, and what lies left and right of that way goes on.
  std::pair<Rim, Rim> split(const Rim& rim, std::uint32_t v) {
    if (rim.head == kNone) return {alone(v), alone(v)};
    const auto way = static_cast<std::uint32_t>(half_of_.size()) | kSlot;
    half_of_.push_back(kNone);
    std::uint32_t a = rim.last, b = rim.last, tail = rim.tail;
    const std::uint32_t left = fill_left(rim, a, v, way), right = fill_right(rim, b, v, way);
    if (a == b) {
      b = add_node(nodes_[a].vertex);
      if (a == rim.tail)
        tail = b;
      else
        connect(b, nodes_[a].next, nodes_[a].link);
    } else {
      drop_between(a, b);
    }
    const std::uint32_t left_end = add_node(v), right_end = add_node(v);
    connect(a, left_end, left);
    connect(right_end, b, right);
    return {{rim.head, left_end, left_end}, {right_end, tail, right_end}};
  }

  /// No edge begins at v, where both end.
  Rim merge(const Rim& left, const Rim& right) {
    if (right.head == right.tail) {
      spare_.push_back(right.head);
      return {left.head, left.tail, left.tail};
    }
    connect(left.tail, nodes_[right.head].next, nodes_[right.head].link);
    spare_.push_back(right.head);
    return {left.head, right.tail, left.tail};
  }

  Rim alone(std::uint32_t v) {
    const std::uint32_t n = add_node(v);
    return {n, n, n};
  }

  void pass(std::uint32_t v) {
    const AxisStar& star = stars_[v];
    const std::uint32_t rank = rank_of_[v];
    if (star.west == kNone) left_of_ = active_.before(rank);
    auto [left, right] = end_edges(v, star, rank);
    if (star.south != kNone && star.north == kNone) active_.erase(rank);
    if (star.north == kNone && star.east == kNone) {
      rims_[left_of_] = merge(left, right);
      return;
    }
    rims_[left_of_] = left;
    if (star.north != kNone) {
      if (star.south == kNone) active_.insert(rank);
      rims_[rank] = star.east == kNone ? right : alone(v);
      left_of_ = rank;
    }
    if (star.east != kNone) below_ = right;
  }

  std::pair<Rim, Rim> end_edges(std::uint32_t v, const AxisStar& star, std::uint32_t rank) {
    if (star.west == kNone && star.south == kNone) return split(rims_[left_of_], v);
    if (star.south == kNone) return {end_right(rims_[left_of_], v, star.west), end_left(below_, v, star.west)};
    if (star.west != kNone) close(below_, v, star.west, star.south);
    const std::uint32_t edge = star.west == kNone ? star.south : star.west;
    const Rim left = end_right(rims_[left_of_], v, edge);
    return {left, end_left(rims_[rank], v, star.south)};
  }

  std::span<const LatticePoint> points_;
  std::span<const AxisStar> stars_;
  std::size_t edge_count_;
  std::size_t rank_count_ = 0;
  std::vector<std::uint32_t> rank_of_;
  RankSet active_;         // vertical edges that the line crosses, by rank
  std::vector<Rim> rims_;  // right of them
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> spare_;
  std::vector<std::uint32_t> half_of_;  // by slot: an edge, or a way between two chains that is none
  std::uint32_t left_of_ = 0;           // the rank of the vertical edge to the left of where the line is
  Rim below_;                           // what lies below the edge from the last point to the east
  std::vector<RawTriangle> mesh_;
};

}  // namespace

std::vector<RawTriangle> sweep(std::span<const LatticePoint> points, std::span<const AxisStar> stars,
                               std::size_t edge_count) {
  return Sweep(points, stars, edge_count).run();
}

}  // namespace taut::detail
