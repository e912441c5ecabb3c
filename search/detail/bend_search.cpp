#include <taut/search/detail/bend_search.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/length.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// What is missing from a sum of up to 2^15 legs in two doubles, as a part of it.
constexpr double kPairDoubt = 0x1p-80;

constexpr auto kLater = [](const auto& a, const auto& b) { return a.bound > b.bound; };

}  // namespace

BendGraph::BendGraph(const FreeSpace& space, const Navmesh& mesh, unsigned jobs)
    : graph(space, VisibilityKind::reduced, jobs), sights(graph), legs(graph), lasting(legs) {
  std::vector<std::uint32_t> bend_of(space.triangulation().sectors.size(), kNone);
  for (std::uint32_t b = 0; b < mesh.bends.size(); ++b) bend_of[mesh.bends[b].sector] = b;
  mesh_bend.reserve(graph.roadmap().vertex_count());
  for (Roadmap::Vertex v = 0; v < graph.roadmap().vertex_count(); ++v) mesh_bend.push_back(bend_of[graph.sector(v)]);
}

BendSearch::BendSearch(const BendGraph& graph, const Navmesh& mesh, const Landmarks* landmarks)
    : graph_(graph),
      points_(graph.graph.roadmap().points()),
      landmarks_(landmarks, mesh),
      sights_(graph.sights),
      states_(graph.legs.vertex_count()),
      wanted_in_(graph.legs.size(), 0) {}

bool BendSearch::find(Point from, Point to, std::span<const std::uint32_t> goals, std::vector<Point>& path) {
  from_ = from;
  begin(to, goals);
  if (graph_.graph.space().sees(from, to)) {
    path.assign(1, from);
    if (to != from) path.push_back(to);
    return true;
  }
  look_back(sights_.visible_from(to));
  for (const Roadmap::Vertex v : sights_.visible_from(from)) reach(kNone, v, leg_of(from, points_[v]), kPlace);
  while (!open_.empty()) {
    const Open next = open_.front();
    std::pop_heap(open_.begin(), open_.end(), kLater);
    open_.pop_back();
    if (next.bound > limit_) break;
    if (states_[labels_[next.label].vertex].label == next.label) expand(next.label);  // else there is a shorter way
  }
  if (best_ == kNone) return false;
  give(path);
  return true;
}

void BendSearch::begin(Point to, std::span<const std::uint32_t> goals) {
  if (++query_ == 0) {
    std::fill(states_.begin(), states_.end(), State{});
    std::fill(wanted_in_.begin(), wanted_in_.end(), 0);
    query_ = 1;
  }
  to_ = to;
  labels_.clear();
  open_.clear();
  goal_legs_.clear();
  wanted_.clear();
  best_ = kNone;
  limit_ = kInfinity;
  expanded_ = 1;
  landmarks_.aim_at(to, goals);
}

/// What may lead from the lasting legs to the goal.
void BendSearch::look_back(std::span<const Roadmap::Vertex> seen_from_goal) {
  for (const Roadmap::Vertex v : seen_from_goal) {
    states_[v].goal_query = query_;
    states_[v].goal_leg = static_cast<std::uint32_t>(goal_legs_.size());
    goal_legs_.push_back(leg_of(points_[v], to_));
    want_taut(v);
  }
  for (std::size_t i = 0; i < wanted_.size(); ++i)
    for (const LastingLegs::Arrival before : graph_.lasting.before(wanted_[i].leg)) want(before);
}

/// The legs to this vertex from which a string goes on to the goal: those by which one from the goal would leave it.
void BendSearch::want_taut(std::uint32_t vertex) {
  const Triangulation& tri = graph_.graph.space().triangulation();
  const Triangulation::Sector& sector = tri.sectors[graph_.graph.sector(vertex)];
  const auto side = [&](Point next) { return written::orientation(to_, points_[vertex], next); };
  const int right = side(tri.points[sector.right]), left = side(tri.points[sector.left]);
  const auto arriving = graph_.lasting.arriving_at(vertex);
  std::size_t i = 0;
  if (right <= 0 && left <= 0)
    for (; i < arriving.size() && side(points_[arriving[i].from]) <= 0; ++i) want(arriving[i]);
  if (right >= 0 && left >= 0)
    for (std::size_t k = arriving.size(); k > i && side(points_[arriving[k - 1].from]) >= 0; --k) want(arriving[k - 1]);
}

void BendSearch::want(LastingLegs::Arrival arrival) {
  if (std::exchange(wanted_in_[arrival.leg], query_) == query_) return;
  State& from = states_[arrival.from];
  const std::uint32_t next = std::exchange(from.wanted_query, query_) == query_ ? from.wanted : kNone;
  from.wanted = static_cast<std::uint32_t>(wanted_.size());
  wanted_.push_back({arrival.leg, next});
}

void BendSearch::expand(std::uint32_t label) {
  ++expanded_;
  const std::size_t via = labels_[label].via;
  if (via == kPlace) {
    follow(label, graph_.legs.of(labels_[label].vertex));
  } else if (graph_.lasting.lasts(via)) {
    follow(label, graph_.legs.right_of(via));
    follow(label, graph_.legs.left_of(via));
  }
  follow_wanted(label);
}

void BendSearch::follow(std::uint32_t label, TautLegs::Range range) {
  const twofold::Pair here = labels_[label].length;
  for (const LastingLegs::Leg& leg : graph_.lasting.of(range))
    if (!leads_nowhere(here, leg.length, leg.to))
      reach(label, leg.to, plus(here, graph_.legs.length(leg.leg)), leg.leg);
}

void BendSearch::follow_wanted(std::uint32_t label) {
  const auto [here, via, vertex, before] = labels_[label];
  if (states_[vertex].wanted_query != query_) return;
  for (std::uint32_t i = states_[vertex].wanted; i != kNone; i = wanted_[i].next) {
    const std::size_t e = wanted_[i].leg;
    if (via != kPlace && e >= graph_.legs.right_of(via).last && e < graph_.legs.left_of(via).first) continue;
    const TautLegs::Leg& leg = graph_.legs[e];
    if (!leads_nowhere(here, leg.length, leg.to)) reach(label, leg.to, plus(here, graph_.legs.length(e)), e);
  }
}

/// Is a shorter way known to where the leg leads, or to the goal?
bool BendSearch::leads_nowhere(twofold::Pair here, double leg_length, std::uint32_t to) const {
  const State& state = states_[to];
  const double length = (here.high + leg_length) * (1 - kDoubt);
  return state.query == query_ && (length > state.length || length + state.rest > limit_);
}

/// `length` is that of the way; it becomes the vertex' label when it is the shortest so far.
void BendSearch::reach(std::uint32_t before, std::uint32_t vertex, twofold::Pair length, std::size_t via) {
  State& state = states_[vertex];
  if (state.query == query_) {
    const Label& known = labels_[state.label];
    if (!is_shorter(length, before, points_[vertex], known.length, known.before, points_[vertex])) return;
  } else {
    state.rest = rest_of(vertex);
    state.query = query_;
  }
  state.label = static_cast<std::uint32_t>(labels_.size());
  state.length = length.high;
  labels_.push_back({length, via, vertex, before});
  if (state.goal_query == query_) arrive(state.label);
  const double bound = (length.high + state.rest) * (1 - kDoubt);
  if (bound > limit_) return;
  open_.push_back({bound, state.label});
  std::push_heap(open_.begin(), open_.end(), kLater);
}

/// A vertex that the goal sees.
void BendSearch::arrive(std::uint32_t label) {
  const Label& last = labels_[label];
  const twofold::Pair length = plus(last.length, goal_legs_[states_[last.vertex].goal_leg]);
  if (best_ != kNone && !is_shorter(length, label, to_, best_length_, best_, to_)) return;
  best_ = label;
  best_length_ = length;
  limit_ = length.high * (1 + kDoubt);
}

/// Each way goes on from a label, or the start, straight to its end.
bool BendSearch::is_shorter(twofold::Pair a, std::uint32_t before_a, Point end_a, twofold::Pair b,
                            std::uint32_t before_b, Point end_b) {
  const double difference = (a.high - b.high) + (a.low - b.low);
  if (std::abs(difference) > kPairDoubt * b.high) return difference < 0;
  return is_shorter_exactly(before_a, end_a, before_b, end_b);
}

bool BendSearch::is_shorter_exactly(std::uint32_t a, Point end_a, std::uint32_t b, Point end_b) {
  legs_a_.clear();
  legs_b_.clear();
  const auto climb = [this](std::uint32_t& label, Point& end, std::vector<Segment>& legs) {
    legs.push_back({point(label), end});
    end = point(label);
    label = labels_[label].before;
  };
  // A label is younger than the one before it; the start is the oldest.
  const auto age = [](std::uint32_t label) { return label + 1; };
  while (a != b) age(a) > age(b) ? climb(a, end_a, legs_a_) : climb(b, end_b, legs_b_);
  legs_a_.push_back({point(a), end_a});
  legs_b_.push_back({point(a), end_b});
  return compare_lengths(legs_a_, legs_b_) < 0;
}

/// A lower bound but for rounding.
double BendSearch::rest_of(std::uint32_t vertex) const {
  const double dx = points_[vertex].x - to_.x, dy = points_[vertex].y - to_.y;
  const double straight = std::sqrt(dx * dx + dy * dy);
  const std::uint32_t bend = graph_.mesh_bend[vertex];
  return (1 - kDoubt) * (bend == kNone ? straight : std::max(straight, landmarks_.rest(bend)));
}

/// Without points in a straight line.
void BendSearch::give(std::vector<Point>& path) const {
  path.assign(1, to_);
  const auto add = [&](Point p) {
    if (p == path.back()) return;
    if (path.size() > 1 && written::on_segment(path.back(), path[path.size() - 2], p)) path.pop_back();
    path.push_back(p);
  };
  for (std::uint32_t label = best_; label != kNone; label = labels_[label].before) add(point(label));
  add(from_);
  std::reverse(path.begin(), path.end());
}

}  // namespace taut::detail
