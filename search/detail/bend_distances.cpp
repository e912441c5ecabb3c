#include <taut/search/detail/bend_distances.h>

#include <algorithm>

#include <taut/geometry/written.h>

namespace taut::detail {

BendDistances::BendDistances(const VisibilityGraph& graph)
    : at_(graph.roadmap().vertex_count(), kFar), via_(at_.size(), kPlace), open_(kBuckets) {
  const Roadmap& roadmap = graph.roadmap();
  first_.reserve(at_.size() + 1);
  first_.push_back(0);
  edges_.reserve(2 * roadmap.edge_count());
  low_.reserve(2 * roadmap.edge_count());
  for (Roadmap::Vertex v = 0; v < at_.size(); ++v) {
    add_legs(graph, v);
    first_.push_back(edges_.size());
  }
  for (const Edge& edge : edges_) {
    longest_ = std::max(longest_, edge.length);
    mean_ += edge.length / static_cast<double>(edges_.size());
  }
  turns_.reserve(edges_.size());
  for (Roadmap::Vertex v = 0; v < at_.size(); ++v)
    for (std::size_t e = first_[v]; e < first_[v + 1]; ++e) turns_.push_back(turns_of(graph, v, edges_[e].to));
}

void BendDistances::add_legs(const VisibilityGraph& graph, Roadmap::Vertex v) {
  const Roadmap& roadmap = graph.roadmap();
  const Triangulation& tri = graph.space().triangulation();
  const Point at = roadmap.point(v), right = tri.points[tri.sectors[graph.sector(v)].right];
  // Within half a turn from the ray to `right` or beyond. Exact, as sides of lines through two given points are.
  const auto is_beyond = [&](Point p) {
    const int side = written::orientation(at, right, p);
    return side < 0 || (side == 0 && written::on_segment(at, right, p));
  };
  std::vector<Roadmap::Vertex> row(roadmap.neighbours(v).begin(), roadmap.neighbours(v).end());
  std::stable_sort(row.begin(), row.end(), [&](Roadmap::Vertex a, Roadmap::Vertex b) {
    const Point p = roadmap.point(a), q = roadmap.point(b);
    const bool p_beyond = is_beyond(p), q_beyond = is_beyond(q);
    return p_beyond != q_beyond ? q_beyond : written::orientation(at, p, q) > 0;
  });
  // Around the free end of a wall, legs along the wall may run on either side of it: they are first and last.
  if (const auto& sector = tri.sectors[graph.sector(v)]; sector.right == sector.left)
    for (std::size_t i = 0, size = row.size(); i < size; ++i)
      if (!is_beyond(roadmap.point(row[i])) && written::orientation(at, right, roadmap.point(row[i])) == 0)
        row.push_back(row[i]);
  for (const Roadmap::Vertex to : row) {
    const twofold::Pair length = leg_of(at, roadmap.point(to));
    edges_.push_back({length.high, to});
    low_.push_back(length.low);
  }
}

BendDistances::Turns BendDistances::turns_of(const VisibilityGraph& graph, Roadmap::Vertex from,
                                             Roadmap::Vertex at) const {
  const Triangulation& tri = graph.space().triangulation();
  const Triangulation::Sector& sector = tri.sectors[graph.sector(at)];
  const Point p = graph.roadmap().point(from), q = graph.roadmap().point(at);
  const auto side = [&](Point next) { return written::orientation(p, q, next); };
  const int right = side(tri.points[sector.right]), left = side(tri.points[sector.left]);
  const std::size_t first = first_[at], last = first_[at + 1];
  std::size_t right_end = first, left_begin = last;
  if (right <= 0 && left <= 0)
    while (right_end < last && side(graph.roadmap().point(edges_[right_end].to)) <= 0) ++right_end;
  if (right >= 0 && left >= 0)
    while (left_begin > right_end && side(graph.roadmap().point(edges_[left_begin - 1].to)) >= 0) --left_begin;
  return {static_cast<std::uint32_t>(right_end - first), static_cast<std::uint32_t>(left_begin - first)};
}

void BendDistances::from(std::span<const Leg> legs) {
  std::fill(at_.begin(), at_.end(), kFar);
  aim(legs);
  for (const Leg& leg : legs)
    if (is_less(leg.length, at_[leg.to])) reach(leg.to, leg.length, kPlace);
  for (Open next{}; take(next);) {
    const twofold::Pair here = at_[next.vertex];
    if (next.bound != here.high) continue;  // there was a shorter way by then
    const std::size_t first = first_[next.vertex], last = first_[next.vertex + 1], via = via_[next.vertex];
    if (via == kPlace) {
      follow(here, first, last);
    } else {
      follow(here, first, first + turns_[via].right);
      follow(here, first + turns_[via].left, last);
    }
  }
}

void BendDistances::follow(twofold::Pair here, std::size_t first, std::size_t last) {
  for (std::size_t e = first; e < last; ++e) {
    const Edge& edge = edges_[e];
    const twofold::Pair& known = at_[edge.to];
    const double length = here.high + edge.length;
    if (length * (1 - kDoubt) > known.high) continue;
    const twofold::Pair exact = plus(here, {edge.length, low_[e]});
    if (is_less(exact, known)) reach(edge.to, exact, e);
  }
}

void BendDistances::reach(std::uint32_t v, twofold::Pair length, std::size_t edge) {
  at_[v] = length;
  via_[v] = edge;
  push({length.high, v});
}

void BendDistances::aim(std::span<const Leg> legs) {
  double longest = longest_;
  for (const Leg& leg : legs) longest = std::max(longest, leg.length.high);
  width_ = std::max(mean_ / 4, longest / (kBuckets - 4));
  if (!(width_ > 0)) width_ = 1;
  now_ = size_ = 0;
}

void BendDistances::push(const Open& open) {
  open_[static_cast<std::size_t>(open.bound / width_) % kBuckets].push_back(open);
  ++size_;
}

bool BendDistances::take(Open& next) {
  if (size_ == 0) return false;
  while (open_[now_ % kBuckets].empty()) ++now_;
  std::vector<Open>& bucket = open_[now_ % kBuckets];
  next = bucket.back();
  bucket.pop_back();
  --size_;
  return true;
}

}  // namespace taut::detail
