#include <taut/search/detail/index_climb.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <taut/geometry/written.h>

namespace taut::detail {

void IndexClimb::begin(Point end, const IntegerPlaces::Place* place) {
  if (++query_ == 0) {
    std::fill(nodes_.begin(), nodes_.end(), Node{});
    query_ = 1;
  }
  end_ = end;
  is_integer_ = place != nullptr;
  if (place) place_ = *place;
  ties_.clear();
  reached_.clear();
  open_.clear();
}

void IndexClimb::add(std::uint32_t bend, std::uint32_t arriving, double length) {
  if (is_known(bend)) {
    nodes_[bend].arriving |= arriving;  // by two of its sides, or from two triangles
    return;
  }
  reach(bend, length, kNone, kNone, arriving);
}

void IndexClimb::reach(std::uint32_t bend, double length, std::uint32_t before, std::uint32_t edge,
                       std::uint32_t arriving) {
  nodes_[bend] = {length, query_, before, edge, arriving, false, false, false};
  open_.emplace_back(length, bend);
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
}

void IndexClimb::run() {
  while (!open_.empty()) {
    const auto [length, bend] = open_.front();
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    open_.pop_back();
    Node& node = nodes_[bend];
    if (length != node.length || node.is_settled) continue;
    node.is_settled = true;
    if (is_stalled(bend)) continue;
    node.is_reached = true;
    reached_.push_back(bend);
    follow(bend);
  }
}

/// Is there a way down from a higher bend that is shorter?
bool IndexClimb::is_stalled(std::uint32_t bend) const {
  const double length = nodes_[bend].length * (1 - 1e-12);
  const auto ups = parts_.image.ups(bend);
  return std::any_of(ups.begin(), ups.end(), [&](const IndexImage::Up& edge) {
    return is_known(edge.to) && nodes_[edge.to].length + edge.length() < length;
  });
}

void IndexClimb::follow(std::uint32_t bend) {
  const double here = nodes_[bend].length;
  std::uint32_t number = parts_.image.ups_begin(bend);
  for (const IndexImage::Up& edge : parts_.image.ups(bend)) {
    const std::uint32_t e = number++;
    const double length = here + edge.length();
    const bool is_new = !is_known(edge.to);
    if (!is_new && length > nodes_[edge.to].length * (1 + kDoubt)) continue;
    if (!may_follow(bend, edge)) continue;
    if (is_new || length < nodes_[edge.to].length * (1 - kDoubt)) {
      reach(edge.to, length, bend, e, edge.last_hop % 4);
    } else {
      nodes_[edge.to].has_ties = true;
      ties_.push_back({edge.to, bend, e, length});
    }
  }
}

bool IndexClimb::may_follow(std::uint32_t bend, const IndexImage::Edge& edge) const {
  const Node& node = nodes_[bend];
  if (is_taut(bend, node.edge, node.arriving, edge)) return true;
  return node.has_ties && std::any_of(ties_.begin(), ties_.end(), [&](const Tie& tie) {
           return tie.bend == bend && is_taut(bend, tie.edge, parts_.image.ups()[tie.edge].last_hop % 4, edge);
         });
}

bool IndexClimb::is_taut(std::uint32_t bend, std::uint32_t via, std::uint32_t arriving,
                         const IndexImage::Edge& edge) const {
  const std::uint32_t back = edge.first_hop % 4;
  const bool left = (arriving & kMayTurnLeft) && (back & kMayTurnRight),
             right = (arriving & kMayTurnRight) && (back & kMayTurnLeft);
  if (!left && !right) return false;
  const int turn = side(hop_of(via), bend, edge.first_hop / 4);
  return (left && turn >= 0) || (right && turn <= 0);
}

/// kNone stands for the end.
int IndexClimb::side(std::uint32_t from, std::uint32_t at, std::uint32_t to) const {
  if (parts_.integers && (from != kNone || is_integer_))
    return IntegerPlaces::side(from == kNone ? place_ : parts_.bends[from].at, parts_.bends[at].at,
                               parts_.bends[to].at);
  return written::orientation(from == kNone ? end_ : parts_.point(from), parts_.point(at), parts_.point(to));
}

IndexClimb::Range IndexClimb::labels_behind(std::uint32_t bend) const {
  const IndexParts::Bend& all = parts_.bends[bend];
  const Node& node = nodes_[bend];
  if (node.has_ties || node.arriving == (kMayTurnLeft | kMayTurnRight)) return {all.begin, all.end};
  const auto cores = parts_.image.cores(bend);
  const std::uint32_t from = hop_of(node.edge);
  const auto turn = [&](std::size_t k) { return side(from, bend, cores[k].first_hop / 4); };
  if (node.arriving & kMayTurnRight) {
    std::size_t k = 0;
    while (k < cores.size() && turn(k) <= 0) ++k;
    return {all.begin, k < cores.size() ? cores[k].label : all.end};
  }
  if (!(node.arriving & kMayTurnLeft)) return {all.begin, all.begin + 1};
  std::size_t k = cores.size();
  while (k > 0 && turn(k - 1) >= 0) --k;
  return {k < cores.size() ? cores[k].label : all.end - 1, all.end};
}

void IndexClimb::chain(std::uint32_t bend, std::vector<std::uint32_t>& bends) {
  settle_ties(bend);
  steps_.clear();
  for (std::uint32_t v = bend; v != kNone; v = nodes_[v].before) steps_.push_back(v);
  bends.assign(1, steps_.back());
  for (std::size_t i = steps_.size() - 1; i-- > 0;)
    unpack_edge(parts_.image, parts_.image.ups()[nodes_[steps_[i]].edge], false, bends);
}

/// Of all ways to the bend, and to those before it, the shortest ones stay.
void IndexClimb::settle_ties(std::uint32_t bend) {
  Node& node = nodes_[bend];
  if (node.before != kNone) settle_ties(node.before);
  if (!node.has_ties) return;
  node.has_ties = false;
  std::vector<Segment> known, other;
  for (const Tie& tie : ties_) {
    if (tie.bend != bend || tie.length > node.length * (1 + kDoubt)) continue;
    settle_ties(tie.before);
    known.clear();
    other.clear();
    legs(bend, node.before, node.edge, known);
    legs(bend, tie.before, tie.edge, other);
    if (compare_lengths(other, known) >= 0) continue;
    node.before = tie.before;
    node.edge = tie.edge;
  }
}

void IndexClimb::legs(std::uint32_t bend, std::uint32_t before, std::uint32_t edge, std::vector<Segment>& out) {
  while (before != kNone) {
    std::vector<std::uint32_t> bends{before};
    unpack_edge(parts_.image, parts_.image.ups()[edge], false, bends);
    for (std::size_t i = 1; i < bends.size(); ++i) out.push_back({parts_.point(bends[i - 1]), parts_.point(bends[i])});
    bend = before;
    before = nodes_[bend].before;
    edge = nodes_[bend].edge;
  }
  out.push_back({end_, parts_.point(bend)});
}

void unpack_edge(const IndexImage& image, const IndexImage::Edge& edge, bool back, std::vector<std::uint32_t>& bends) {
  struct Part {
    const IndexImage::Edge* edge;
    bool back;
  };
  thread_local std::vector<Part> open;
  open.assign(1, {&edge, back});
  const std::size_t most = bends.size() + image.header().bends;
  while (!open.empty() && bends.size() <= most) {
    const Part part = open.back();
    open.pop_back();
    if (part.edge->first_child == kNone) {
      bends.push_back(part.back ? part.edge->last_hop / 4 : part.edge->to);
      continue;
    }
    // Both begin at the middle: the one leads back to where the edge begins, the other on.
    const IndexImage::Edge *first = &image.ups()[part.edge->first_child], *last = &image.ups()[part.edge->last_child];
    if (part.back) std::swap(first, last);
    open.push_back({last, false});
    open.push_back({first, true});
  }
}

}  // namespace taut::detail
