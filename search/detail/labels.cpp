#include <taut/search/detail/labels.h>

#include <algorithm>
#include <array>

#include <boost/container/small_vector.hpp>

namespace taut::detail {

Labels::Labels(const Roadmap& roadmap, Point start, std::vector<Point> goals)
    : roadmap_(&roadmap), ends_(std::move(goals)), labels_(2), ties_(1) {
  ends_.insert(ends_.begin(), start);
  labels_[kStart].vertex = static_cast<Vertex>(roadmap.vertex_count());
}

Interval Labels::enclose(Chain chain) const {
  const Label& to = labels_[chain.label];
  const Interval leg = distance_interval(point(to.vertex), chain.end);
  return {twofold::add_down(to.lo, leg.lo), twofold::add_up(to.hi, leg.hi)};
}

Labels::Id Labels::extend(Id parent, Vertex v, Id former) {
  Interval length = enclose({parent, point(v)});
  if (former != kNone) {
    length.lo = std::min(length.lo, labels_[former].lo);
    length.hi = std::min(length.hi, labels_[former].hi);
  }
  labels_.push_back({.lo = length.lo, .hi = length.hi, .parent = parent, .vertex = v});
  return static_cast<Id>(labels_.size() - 1);
}

bool Labels::is_shorter_exactly(Id parent, Vertex v, Id than) {
  const Chain candidate{parent, point(v)};
  const Interval length = enclose(candidate);
  Label& old = labels_[than];
  if (length.hi < old.lo) return true;
  if (length.lo >= old.hi) return false;
  const auto order = compare_legs(candidate, chain(than));
  if (order == 0) {
    ties_.push_back({parent, old.ties});
    old.ties = static_cast<std::uint32_t>(ties_.size() - 1);
  }
  return order < 0;
}

std::strong_ordering Labels::compare(Chain a, Chain b) const {
  const Interval length_a = enclose(a), length_b = enclose(b);
  if (length_a.hi < length_b.lo) return std::strong_ordering::less;
  if (length_a.lo > length_b.hi) return std::strong_ordering::greater;
  return compare_legs(a, b);
}

std::strong_ordering Labels::compare_legs(Chain a, Chain b) const {
  // Only what lies beyond the last common label can differ.
  boost::container::small_vector<Segment, 16> legs_a, legs_b;
  const auto climb = [this](Chain& chain, auto& legs, Id to) {
    if (chain.label == to) return;
    const Point p = point(labels_[chain.label].vertex);
    legs.push_back({p, chain.end});
    chain = {to, p};
  };
  while (a.label != b.label) {
    const bool near = legs_a.size() + legs_b.size() < 16;
    if (const Id common = near ? common_parent(a.label, b.label) : kNone; common != kNone) {
      climb(a, legs_a, common);
      climb(b, legs_b, common);
    } else if (a.label > b.label) {
      climb(a, legs_a, labels_[a.label].parent);
    } else {
      climb(b, legs_b, labels_[b.label].parent);
    }
  }
  const Point common = point(labels_[a.label].vertex);
  legs_a.push_back({common, a.end});
  legs_b.push_back({common, b.end});
  return compare_lengths({legs_a.data(), legs_a.size()}, {legs_b.data(), legs_b.size()});
}

std::span<const Labels::Id> Labels::parents(Id id, std::span<Id> room) const {
  std::size_t count = 0;
  room[count++] = labels_[id].parent;
  for (std::uint32_t t = labels_[id].ties; t != 0 && count < room.size(); t = ties_[t].next)
    room[count++] = ties_[t].parent;
  return room.first(count);
}

/// A label from which one leg leads to each of two different ones, or to the one from the other, by parents and by
/// ties.
Labels::Id Labels::common_parent(Id a, Id b) const {
  std::array<Id, 4> room_a, room_b;
  const auto of_a = parents(a, room_a), of_b = parents(b, room_b);
  for (const Id p : of_a)
    if (p == b || (p != kNone && std::find(of_b.begin(), of_b.end(), p) != of_b.end())) return p;
  return std::find(of_b.begin(), of_b.end(), a) != of_b.end() ? a : kNone;
}

std::vector<Point> Labels::points(Chain chain) const {
  std::vector<Point> points{chain.end};
  for (Id id = chain.label; id != kNone; id = labels_[id].parent) points.push_back(point(labels_[id].vertex));
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace taut::detail
