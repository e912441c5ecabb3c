#include <taut/search/radius_tradeoff.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <taut/roadmaps/disc_places.h>
#include <taut/search/detail/radius_sweep.h>
#include <taut/search/verify_arcs.h>

namespace taut {

namespace {

using End = TradeoffStretch::End;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The ends of the disc's way for radii up to `most`.
struct Phase {
  Point start, goal;
  double most = 0;
};

class Tradeoff {
 public:
  Tradeoff(const AllRadii& radii, const PassageIndex& index, Point s, Point g, const RadiusTradeoffRequest& request)
      : radii_(radii), index_(index), s_(s), g_(g), request_(request) {}

  RadiusTradeoff find() {
    const PassagePlace s = index_.place(s_), g = index_.place(g_);
    for (const PassagePlace* end : {&s, &g})
      if (end->outside) return blocked(end == &s);
    const double least = request_.least > 0 ? request_.least : radii_.least_radius();
    double from = least;
    for (const Phase& phase : phases(s, g)) {
      if (phase.most < from) continue;
      if (!result_.stretches.empty()) result_.stretches.back().end = End::left;
      flush();
      run(phase, from);
      last_ = phase;
      from = std::nextafter(phase.most, kInfinite);
    }
    flush();
    if (result_.stretches.empty())
      return index_.radius_at(s) < least ? blocked(true) : index_.radius_at(g) < least ? blocked(false) : result_;
    result_.status = DiscStatus::found;
    result_.widest = index_.widest(last_.start, last_.goal);
    return std::move(result_);
  }

 private:
  RadiusTradeoff blocked(bool start) {
    result_.status = start ? DiscStatus::start_blocked : DiscStatus::goal_blocked;
    result_.wall = index_.place(start ? s_ : g_).constraint;
    return result_;
  }

  std::vector<Phase> phases(const PassagePlace& s, const PassagePlace& g) {
    std::vector<Phase> all{{s_, g_, most(s_, g_)}};
    const double own_s = index_.radius_at(s), own_g = index_.radius_at(g), room = room_between(s, g);
    const auto p = place_for(s, own_s, room), q = place_for(g, own_g, room);
    if (!p || !q || (*p == s_ && *q == g_) || index_.passes(*p, *q, room) != DiscStatus::found) return all;
    result_.start_left = *p != s_;
    result_.goal_left = *q != g_;
    if (result_.start_left && result_.goal_left && own_s != own_g)
      all.push_back(own_s < own_g ? Phase{*p, g_, most(*p, g_)} : Phase{s_, *q, most(s_, *q)});
    all.push_back({*p, *q, most(*p, *q)});
    return all;
  }

  double most(Point s, Point g) const {
    const auto widest = index_.widest(s, g);
    return widest ? std::min(widest->radius, World::kLargest) : 0;
  }

  /// The largest disc that gates let through between the ends; where there is none, that has room at one of them.
  double room_between(const PassagePlace& s, const PassagePlace& g) const {
    const PassagePlace a = beside(s), b = beside(g);
    const std::uint32_t gate = index_.bottleneck(a, b);
    return gate == kNone ? std::max(index_.radius_at(s), index_.radius_at(g)) : index_.gate_radius(gate);
  }

  /// A place on a wall lies in no face; one beside it does.
  PassagePlace beside(const PassagePlace& end) const {
    if (!end.on_wall) return end;
    const auto near = DiscPlaces(index_.gates().space(), radii_.least_radius()).nearest(end.point);
    return near ? index_.place(near->point) : end;
  }

  std::optional<Point> place_for(const PassagePlace& end, double own, double room) const {
    if (own >= room) return end.point;
    const auto near = DiscPlaces(index_.gates().space(), room).nearest(end.point);
    if (!near) return std::nullopt;
    ArcPath leg{own, end.point, near->point, {}, {}};
    leg.length = length_of(pieces(leg));
    const bool keeps = own > 0 ? verify_arcs(leg, index_.gates(), leg.start, leg.goal).valid
                               : index_.gates().space().sees(leg.start, leg.goal);
    return keeps ? std::optional(near->point) : std::nullopt;
  }

  void run(const Phase& phase, double from) {
    const double aside = distance(s_, phase.start) + distance(g_, phase.goal);
    const auto tell = [&](TradeoffStretch stretch) {
      flush();
      stretch.aside = aside;
      stretch.at_from = stretch.at_from + Interval(aside);
      stretch.at_to = stretch.at_to + Interval(aside);
      result_.stretches.push_back(std::move(stretch));
    };
    if (phase.start == phase.goal)
      return tell({from, phase.most, phase.start, phase.goal, {}, 0, Interval(0), Interval(0), End::last, kNone});
    const std::function<void(TradeoffStretch)> teller = tell;
    detail::RadiusSweep sweep(radii_, index_, phase.start, phase.goal, teller);
    sweep.sweep(from, phase.most);
    result_.graphs += sweep.graphs();
  }

  /// A stretch is told when how it ends is certain.
  void flush() {
    if (request_.told)
      for (; told_ < result_.stretches.size(); ++told_) request_.told(result_.stretches[told_]);
  }

  const AllRadii& radii_;
  const PassageIndex& index_;
  Point s_, g_;
  const RadiusTradeoffRequest& request_;
  RadiusTradeoff result_;
  Phase last_;
  std::size_t told_ = 0;
};

}  // namespace

ArcPath TradeoffStretch::path(double r) const {
  ArcPath path{r, start, goal, bends, {}};
  path.length = length_of(pieces(path));
  return path;
}

LengthFormula TradeoffStretch::formula() const {
  // In its middle: where a leg comes to be or ends, its direction is known to half the digits.
  LengthFormula formula = length_formula(path(from + (to - from) / 2));
  formula.constant += aside;
  return formula;
}

RadiusTradeoff radius_tradeoff(const AllRadii& radii, const PassageIndex& index, Point s, Point g,
                               const RadiusTradeoffRequest& request) {
  return Tradeoff(radii, index, s, g, request).find();
}

}  // namespace taut
