#include <taut/robots/pursuit/detail/bend_tree.h>

#include <algorithm>
#include <functional>

#include <taut/geometry/written.h>

namespace taut::pursuit::detail {

namespace {

Interval leg_length(Point p, Point q) {
  if (p == q) return 0;
  const Interval dx = written::enclosure(p.x) - written::enclosure(q.x),
                 dy = written::enclosure(p.y) - written::enclosure(q.y);
  return root(dx * dx + dy * dy);
}

}  // namespace

Rational squared_distance(const ExactPoint& p, const ExactPoint& q) {
  const Rational dx = p.x - q.x, dy = p.y - q.y;
  return dx * dx + dy * dy;
}

BendTree::BendTree(const VisibilityGraph& graph, Point start)
    : graph_(graph.roadmap()),
      start_(start),
      length_(graph_.vertex_count()),
      before_(graph_.vertex_count(), kNone),
      is_reached_(graph_.vertex_count(), false) {
  for (const Vertex v : graph.visible_from(start)) offer(v, kNone, leg_length(start, graph_.point(v)));
  spread();
  for (Vertex v = 0; v < graph_.vertex_count(); ++v)
    if (is_reached_[v]) order_.push_back(v);
  std::stable_sort(order_.begin(), order_.end(), [&](Vertex a, Vertex b) { return length_[a].lo < length_[b].lo; });
}

void BendTree::spread() {
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const auto [key, v] = queue_.back();
    queue_.pop_back();
    if (key != length_[v].lo) continue;  // it has become shorter since
    for (const Vertex to : graph_.neighbours(v))
      offer(to, v, length_[v] + leg_length(graph_.point(v), graph_.point(to)));
  }
}

void BendTree::offer(Vertex to, Vertex before, const Interval& length) {
  if (is_reached_[to] && !is_shorter(to, before, length)) return;
  is_reached_[to] = true;
  length_[to] = length;
  before_[to] = before;
  queue_.emplace_back(length.lo, to);
  std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
}

bool BendTree::is_shorter(Vertex to, Vertex before, const Interval& length) const {
  if (before_[to] == before || length.lo > length_[to].hi) return false;
  if (length.hi < length_[to].lo) return true;
  std::vector<SignedRoot> sum = before == kNone ? std::vector<SignedRoot>{} : roots(before);
  sum.push_back(
      {squared_distance(ExactPoint(before == kNone ? start_ : graph_.point(before)), ExactPoint(graph_.point(to)))});
  for (SignedRoot& old : roots(to)) sum.push_back({std::move(old.square), -1});
  return sign_of_sum(sum) < 0;
}

std::vector<SignedRoot> BendTree::roots(Vertex v) const {
  std::vector<SignedRoot> sum;
  const std::vector<Point> points = path(v);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i - 1] != points[i]) sum.push_back({squared_distance(ExactPoint(points[i - 1]), ExactPoint(points[i]))});
  return sum;
}

std::vector<Point> BendTree::path(Vertex v) const {
  std::vector<Point> points;
  for (; v != kNone; v = before_[v]) points.push_back(graph_.point(v));
  if (points.empty() || points.back() != start_) points.push_back(start_);
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace taut::pursuit::detail
