#include <taut/search/detail/arc_hierarchy_query.h>

#include <algorithm>

namespace taut::detail {

bool ArcHierarchyQuery::is_nearer(Side& side, std::uint32_t n, double length, std::uint32_t before,
                                  std::uint32_t edge) {
  Label& label = side.labels[n];
  if (label.query == query_ && label.length <= length) return false;
  label = {length, before, edge, query_};
  return true;
}

void ArcHierarchyQuery::reach(Side& side, std::uint32_t n, double length, std::uint32_t before, std::uint32_t edge) {
  if (!is_nearer(side, n, length, before, edge)) return;
  side.open.push_back({length, length, n});
  std::push_heap(side.open.begin(), side.open.end());
}

ArcHierarchyQuery::Open ArcHierarchyQuery::next_of(Side& side) {
  const Open next = side.open.front();
  std::pop_heap(side.open.begin(), side.open.end());
  side.open.pop_back();
  return next;
}

void ArcHierarchyQuery::settle(Side& side, const Side& other, Way& way) {
  const Open next = next_of(side);
  if (next.length != side.labels[next.node].length) return;
  ++way.settled;
  const std::uint32_t turned = hierarchy_.turned(next.node);
  if (const Label& met = other.labels[turned]; met.query == query_ && next.length + met.length < way.length) {
    way.length = next.length + met.length;
    meeting_ = &side == &forth_ ? next.node : turned;
  }
  if (hierarchy_.is_core(next.node)) return side.core.push_back(next.node);
  std::uint32_t i = 0;
  for (const ArcHierarchy::Edge& edge : hierarchy_.up(next.node))
    reach(side, edge.to, next.length + edge.length, next.node, i++);
}

void ArcHierarchyQuery::climb(Way& way) {
  const auto is_done = [&](const Side& side) { return side.open.empty() || side.open.front().length >= way.length; };
  while (!is_done(forth_) || !is_done(back_)) {
    const bool goes_forth =
        is_done(back_) || (!is_done(forth_) && forth_.open.front().length <= back_.open.front().length);
    if (goes_forth)
      settle(forth_, back_, way);
    else
      settle(back_, forth_, way);
  }
}

void ArcHierarchyQuery::enter_core(std::uint32_t i, double length, std::uint32_t before, std::uint32_t edge) {
  Label& label = core_labels_[i];
  if (label.query == query_ && label.length <= length) return;
  label = {length, before, edge, query_};
  forth_.open.push_back({length + core_.least(i), length, i});
  std::push_heap(forth_.open.begin(), forth_.open.end());
}

/// A*: what is left is known where the climb from the goal came.
void ArcHierarchyQuery::cross_core(Way& way) {
  exits_.clear();
  for (const std::uint32_t n : back_.core) exits_.push_back({core_.turned(core_.number(n)), back_.labels[n].length});
  if (exits_.empty()) return;
  core_.aim(exits_);
  forth_.open.clear();
  for (const std::uint32_t n : forth_.core) enter_core(core_.number(n), forth_.labels[n].length, kNone, kNone);
  while (!forth_.open.empty() && forth_.open.front().least < way.length) {
    const Open next = next_of(forth_);
    if (next.length != core_labels_[next.node].length) continue;
    ++way.settled;
    if (const Label& met = back_.labels[core_.node(core_.turned(next.node))];
        met.query == query_ && next.length + met.length < way.length) {
      way.length = next.length + met.length;
      crossed_ = next.node;
    }
    std::uint32_t edge = 0;
    for (const ArcCore::Edge& e : core_.edges(next.node)) enter_core(e.to, next.length + e.length, next.node, edge++);
  }
}

std::uint32_t ArcHierarchyQuery::trace(const Side& side, std::uint32_t n, std::vector<std::uint32_t>& nodes) const {
  std::vector<std::uint32_t> steps;
  for (; side.labels[n].edge != kNone; n = side.labels[n].before) steps.push_back(n);
  nodes.push_back(n);
  for (std::size_t i = steps.size(); i-- > 0;) {
    const Label& label = side.labels[steps[i]];
    hierarchy_.follow(label.before, hierarchy_.up(label.before)[label.edge], nodes);
  }
  return side.labels[n].before;
}

std::uint32_t ArcHierarchyQuery::trace_core(std::uint32_t i, std::vector<std::uint32_t>& nodes) const {
  std::vector<std::uint32_t> steps;
  for (; core_labels_[i].before != kNone; i = core_labels_[i].before) steps.push_back(i);
  const std::uint32_t door = trace(forth_, core_.node(i), nodes);
  for (std::size_t k = steps.size(); k-- > 0;) {
    const Label& label = core_labels_[steps[k]];
    const std::uint32_t before = core_.node(label.before);
    hierarchy_.follow(before, hierarchy_.up(before)[label.edge], nodes);
  }
  return door;
}

ArcHierarchyQuery::Way ArcHierarchyQuery::find(std::span<const ArcDoor> entries, std::span<const ArcDoor> exits) {
  ++query_;
  crossed_ = kNone;
  Way way;
  for (Side* side : {&forth_, &back_}) {
    side->open.clear();
    side->core.clear();
  }
  for (std::uint32_t i = 0; i < entries.size(); ++i) reach(forth_, entries[i].node, entries[i].length, i, kNone);
  for (std::uint32_t i = 0; i < exits.size(); ++i)
    reach(back_, hierarchy_.turned(exits[i].node), exits[i].length, i, kNone);
  climb(way);
  cross_core(way);
  if (way.length == std::numeric_limits<double>::infinity()) return way;
  way.entry = crossed_ == kNone ? trace(forth_, meeting_, way.nodes) : trace_core(crossed_, way.nodes);
  if (crossed_ != kNone) meeting_ = core_.node(crossed_);
  std::vector<std::uint32_t> rest;
  way.exit = trace(back_, hierarchy_.turned(meeting_), rest);
  for (std::size_t i = rest.size() - 1; i-- > 0;) way.nodes.push_back(hierarchy_.turned(rest[i]));
  return way;
}

}  // namespace taut::detail
