#include <taut/search/detail/hub_tree.h>

#include <taut/geometry/length.h>

namespace taut::detail {

HubTree::HubTree(const HubGraph& graph, const SightLists* sights, std::span<const std::uint32_t> bend_places)
    : graph_(graph),
      sights_(sights),
      places_(bend_places),
      high_(graph.size(), kFar),
      half_(graph.size(), kFar),
      ways_(graph.size()) {}

void HubTree::begin(std::uint32_t root) {
  for (const std::uint32_t v : reached_) high_[v] = kFar;
  for (const std::uint32_t v : halved_) half_[v] = kFar;
  reached_.clear();
  halved_.clear();
  root_ = root;
  high_[root] = 0;
  reached_.push_back(root);
  ways_[root] = {{}, root, kNone, false, false};
  open_.assign(1, {0, root});
  if (!sights_) return;
  const HalfLegs& halves = sights_->halves;
  for (std::uint32_t k = halves.in_first[root]; k < halves.in_first[root + 1]; ++k) {
    const double length = halves.in[k].length * (1 + kMargin);
    if (length < high_[halves.in[k].to]) reach(halves.in[k].to, {{{length, 0}, 0}, root, kNone, true, false});
  }
}

void HubTree::follow(std::uint32_t v) {
  const std::uint32_t first = graph_.first[v], last = graph_.first[v + 1], via = ways_[v].via;
  if (v == root_) return follow(v, first, last);
  if (via == kNone) return follow_half(v, first, last);
  follow(v, first, first + graph_.edges[via].right);
  follow(v, std::max(first + graph_.edges[via].left, first + graph_.edges[via].right), last);
}

/// Behind a half leg.
void HubTree::follow_half(std::uint32_t v, std::uint32_t first, std::uint32_t last) {
  const Turns at = turns(v);
  const auto side = [&](std::uint32_t e) { return at.side(place(graph_.edges[e].to)); };
  if (at.right)
    for (std::uint32_t e = first; e < last && side(e) <= 0; ++e) follow(v, e, e + 1);
  if (at.left)
    for (std::uint32_t e = last; e-- > first && side(e) >= 0;) follow(v, e, e + 1);
}

HubTree::Turns HubTree::turns(std::uint32_t v) const {
  const auto& at = sights_->places;
  Turns made{place(ways_[v].before), place(v)};
  const int right = made.side(at[places_[3 * v + 1]]), left = made.side(at[places_[3 * v + 2]]);
  made.right = right <= 0 && left <= 0;
  made.left = right >= 0 && left >= 0;
  return made;
}

void HubTree::follow(std::uint32_t v, std::uint32_t first, std::uint32_t last) {
  const PrintedLength& here = ways_[v].length;
  for (std::uint32_t e = first; e < last; ++e) {
    const HubGraph::Edge& edge = graph_.edges[e];
    const double known = high_[edge.to], length = here.sum.high + edge.length;
    if (length * (1 - kDoubt) > known) continue;
    const Way way{{plus(here.sum, graph_.length(e)), here.print + graph_.print[e]}, v, e, ways_[v].is_half, false};
    if (length * (1 + kDoubt) > known) {
      const int order = compare(way.length, ways_[edge.to].length);
      if (order == 2 ? !is_shorter_exactly(way, edge.to) : order >= 0) continue;
    }
    reach(edge.to, way);
  }
}

void HubTree::reach(std::uint32_t v, const Way& way) {
  if (high_[v] == kFar) reached_.push_back(v);
  high_[v] = way.length.sum.high;
  ways_[v] = way;
  open_.push_back({high_[v], v});
  std::push_heap(open_.begin(), open_.end(), kLater);
}

/// What began with a half leg has no exact length and never had to.
bool HubTree::is_shorter_exactly(const Way& way, std::uint32_t v) {
  if (way.is_half || ways_[v].is_half) return !way.is_half;
  legs_a_.clear();
  legs_b_.clear();
  legs(way.before, legs_a_);
  graph_.legs(graph_, way.via, legs_a_);
  legs(v, legs_b_);
  return compare_lengths(legs_a_, legs_b_) < 0;
}

void HubTree::legs(std::uint32_t v, std::vector<Segment>& out) const {
  for (; v != root_; v = ways_[v].before) graph_.legs(graph_, ways_[v].via, out);
}

void HubTree::shorten_halves(std::uint32_t v) {
  if (!sights_) return;
  const HalfLegs& halves = sights_->halves;
  const double length = high_[v];
  if (v == root_) {
    for (std::uint32_t k = halves.first[2 * v]; k < halves.first[2 * v + 2]; ++k)
      shorten_half(halves.out[k].to, halves.out[k].length);
    return;
  }
  const Turns at = turns(v);
  const auto spread = [&](BendSide side, int turn) {
    for (std::uint32_t k = halves.first[2 * v + side]; k < halves.first[2 * v + side + 1]; ++k) {
      const HalfLegs::Leg& leg = halves.out[k];
      if (turn * at.side(place(leg.to)) < 0) break;
      shorten_half(leg.to, length + leg.length);
    }
  };
  if (at.right) spread(kRightTurn, -1);
  if (at.left) spread(kLeftTurn, 1);
}

void HubTree::shorten_half(std::uint32_t to, double length) {
  if (length >= half_[to]) return;
  if (half_[to] == kFar) halved_.push_back(to);
  half_[to] = length;
}

}  // namespace taut::detail
