#include <taut/search/detail/radius_rivals.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <queue>

namespace taut::detail {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostLabels = 6000;

std::uint64_t mixed(std::uint64_t v) {
  v += 0x9e3779b97f4a7c15U;
  v = (v ^ (v >> 30U)) * 0xbf58476d1ce4e5b9U;
  v = (v ^ (v >> 27U)) * 0x94d049bb133111ebU;
  return v ^ (v >> 31U);
}

double squared(Point a, Point b) { return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y); }

}  // namespace

RadiusRivals::RadiusRivals(const TangentParts& graph, const DiscWords& words, DiscWord best)
    : graph_(graph),
      words_(words),
      best_(std::move(best)),
      a_(graph.r),
      walk_(graph),
      ends_(join_ends(graph, words.start(), words.goal())),
      left_(walk_.nodes()),
      at_(walk_.nodes()) {}

int RadiusRivals::side_of(std::uint32_t node) const {
  return !graph_.sites()[graph_.site_of[node / 2]].round ? 0 : node % 2 == 1 ? 1 : -1;
}

/// By how much a leg that turns, with the turns at its ends, is longer at b than its tangent in a.
double RadiusRivals::grown(double square, double k) const {
  const auto value = [&](double r) {
    const double d = std::sqrt(square), x = std::min(k * r, d);
    return std::sqrt(std::max(0.0, square - x * x)) + k * r * std::asin(std::min(1.0, x / d));
  };
  const double slope = k * std::asin(std::min(1.0, k * a_ / std::sqrt(square)));
  return std::max(0.0, value(b_) - value(a_) - slope * (b_ - a_));
}

RadiusRivals::Step RadiusRivals::step(std::uint32_t from, std::uint32_t to, double length) const {
  const std::uint32_t x = graph_.site_of[from / 2], y = graph_.site_of[to / 2];
  if (x == y) return {0, length, 0, 0};
  Step step{length, 0, squared(graph_.sites()[x].at, graph_.sites()[y].at), 0};
  // Corners of openings may be lost again: the tangent alone is a bound there.
  if (side_of(from) * side_of(to) < 0) step.k = 2;
  return step;
}

RadiusRivals::Step RadiusRivals::end_step(const ArcEndLeg& leg, Point end, double whole) const {
  const TangentSite& site = graph_.sites()[leg.site];
  const double length = leg.length.middle();
  return {length, std::max(0.0, whole - length), squared(site.at, end), site.round ? 1.0 : 0.0};
}

/// From every node, to the goal: backwards from the exits, which is onwards from their turned nodes.
void RadiusRivals::measure(double b, double most) {
  std::fill(left_.begin(), left_.end(), kInfinite);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const double growth = b / a_;
  const Point s = words_.start();
  const auto reach = [&](std::uint32_t n, double length) {
    if (length >= left_[n]) return;
    const TangentPoint& p = graph_.points[n / 2];
    const double r = p.here.side == 0 ? 0 : a_;
    const double far = std::hypot(p.here.centre.x + r * p.x.middle() - s.x, p.here.centre.y + r * p.y.middle() - s.y);
    if (length + far * (1 - 1e-12) > most) return;
    left_[n] = length;
    open.emplace(length, n);
  };
  for (const ArcExit& exit : ends_.exits) {
    const Step step = end_step(ends_.to_goal[exit.leg], words_.goal(), exit.length.middle());
    reach(walk_.turned(exit.node), step.leg + step.arc * growth);
  }
  while (!open.empty()) {
    const auto [length, n] = open.top();
    open.pop();
    if (length > left_[n]) continue;
    walk_.onward(n, [&](std::uint32_t m, const Interval& part) {
      const bool arc = graph_.site_of[n / 2] == graph_.site_of[m / 2];
      reach(m, length + part.middle() * (arc ? growth : 1));
    });
  }
}

void RadiusRivals::follow_best(const Label& from, Label& label) const {
  if (from.best == kNone) return;
  const std::uint32_t site = graph_.site_of[label.node / 2];
  const bool on_circle = from.node != kNone && graph_.site_of[from.node / 2] == site;
  if (on_circle && from.passing) return;
  label.best = from.best;
  if (on_circle) return;
  if (from.best < best_.size() && best_[from.best] == WordStop{site, side_of(label.node)})
    ++label.best;
  else
    label.passing = true;
}

/// Is one before it as good, for all radii from a to b? The best way's own is none: it may become longer than its word.
bool RadiusRivals::is_dominated(const Label& label) {
  for (const std::uint32_t i : at_[label.node]) {
    Label& other = labels_[i];
    if (other.dropped) continue;
    const auto as_good = [&](const Label& p, const Label& q) {
      if (p.best != kNone || p.here > q.here + slack_) return false;
      return p.there <= (p.legs == q.legs ? q.there : q.tangent) + slack_;
    };
    if (as_good(other, label)) return true;
    if (label.best == kNone && as_good(label, other) && other.best == kNone) other.dropped = true;
  }
  return false;
}

void RadiusRivals::add(const Label& from, std::uint32_t index, std::uint32_t node, const Step& step) {
  if (left_[walk_.turned(node)] == kInfinite) return;
  Label label;
  label.node = node;
  label.before = index;
  label.here = from.here + step.leg + step.arc;
  label.tangent = from.tangent + step.leg + step.arc * (b_ / a_);
  label.legs = from.legs;
  follow_best(from, label);
  const double least = label.tangent + left_[walk_.turned(node)];
  if (least >= most_ - slack_) return;
  label.there = from.there + (label.tangent - from.tangent) + (step.k > 0 ? grown(step.square, step.k) : 0);
  if (step.k > 0) label.legs += mixed(std::bit_cast<std::uint64_t>(step.square) ^ static_cast<std::uint64_t>(step.k));
  if (is_dominated(label)) return;
  if (at_[node].empty()) used_.push_back(node);
  at_[node].push_back(static_cast<std::uint32_t>(labels_.size()));
  open_.emplace_back(least, static_cast<std::uint32_t>(labels_.size()));
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
  labels_.push_back(label);
}

DiscWord RadiusRivals::word(std::uint32_t label, const ArcExit& exit) const {
  std::vector<std::uint32_t> chain;
  std::uint32_t entry = kNone;
  for (std::uint32_t i = label; i < labels_.size(); i = labels_[i].before) {
    chain.push_back(labels_[i].node);
    entry = labels_[i].before;
  }
  const ArcExit& in = ends_.entries[kNone - 1 - entry];
  std::vector<std::pair<WordStop, int>> stops;  // and at how many points of the circle
  const auto stop = [&](std::uint32_t site, int side) {
    if (!stops.empty() && stops.back().first.site == site) return void(++stops.back().second);
    stops.push_back({{site, graph_.sites()[site].round ? side : 0}, 1});
  };
  if (in.by_arc) stop(ends_.from_start[in.leg].site, ends_.from_start[in.leg].side);
  for (auto n = chain.rbegin(); n != chain.rend(); ++n) stop(graph_.site_of[*n / 2], *n % 2 == 1 ? 1 : -1);
  if (exit.by_arc) stop(ends_.to_goal[exit.leg].site, ends_.to_goal[exit.leg].side);
  DiscWord result;
  for (const auto& [s, points] : stops)
    if (s.side == 0 || points > 1) result.push_back(s);
  return result;
}

std::optional<std::vector<DiscWord>> RadiusRivals::until(double b, double length) {
  b_ = b;
  most_ = length;
  slack_ = 1e-13 * length;
  labels_.clear();
  open_.clear();
  for (const std::uint32_t n : used_) at_[n].clear();
  used_.clear();
  measure(b, length);
  std::vector<DiscWord> found;
  for (const ArcEnds::Apart& apart : ends_.apart) {
    DiscWord word;
    if (apart.start_leg != kNone) {
      const ArcEndLeg& leg = ends_.from_start[apart.start_leg];
      word.push_back({leg.site, graph_.sites()[leg.site].round ? leg.side : 0});
      if (!apart.by_arc && word.back().side != 0) word.clear();
    }
    if (word != best_) found.push_back(std::move(word));
  }
  Label none;
  none.best = 0;
  for (std::uint32_t i = 0; i < ends_.entries.size(); ++i) {
    const ArcExit& entry = ends_.entries[i];
    add(none, kNone - 1 - i, entry.node, end_step(ends_.from_start[entry.leg], words_.start(), entry.length.middle()));
  }
  while (!open_.empty()) {
    const std::uint32_t index = open_.front().second;
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    open_.pop_back();
    const Label label = labels_[index];
    if (label.dropped) continue;
    if (labels_.size() > kMostLabels) return std::nullopt;
    for (const ArcExit& exit : ends_.exits) {
      if (exit.node != label.node) continue;
      const Step step = end_step(ends_.to_goal[exit.leg], words_.goal(), exit.length.middle());
      if (label.tangent + step.leg + step.arc * (b_ / a_) >= most_ - slack_) continue;
      DiscWord way = word(index, exit);
      if (way != best_ && std::ranges::find(found, way) == found.end()) found.push_back(std::move(way));
    }
    walk_.onward(label.node, [&](std::uint32_t m, const Interval& part) {
      add(label, index, m, step(label.node, m, part.middle()));
    });
  }
  return found;
}

}  // namespace taut::detail
