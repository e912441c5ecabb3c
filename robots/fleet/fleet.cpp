#include <taut/robots/fleet/fleet.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include <taut/geometry/box.h>
#include <taut/geometry/exact/exact_point.h>

namespace taut::fleet {

namespace {

constexpr double kEps = 0x1p-53;
constexpr double kEver = std::numeric_limits<double>::infinity();

/// A robot from one of its points to the next, or waiting at one.
struct Motion {
  std::size_t robot = 0, leg = 0;
  double from = 0, to = 0;
  Point a, b;
  double radius = 0;

  bool waits() const { return a == b; }
  Point at(double time) const {
    if (waits() || time <= from) return a;
    if (time >= to) return b;
    const double part = (time - from) / (to - from);
    return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
  }
  /// How far at() may be from the exact place.
  double error(double time) const {
    const double size = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    if (waits()) return 2 * kEps * size;
    const double way = std::abs(b.x - a.x) + std::abs(b.y - a.y),
                 late = std::abs(std::clamp(time, from, to)) + std::abs(from) + std::abs(to);
    return 8 * kEps * (size + way * (1 + late / (to - from)));
  }
  ExactPoint exactly_at(double time) const {
    if (waits() || time <= from) return ExactPoint(a);
    if (time >= to) return ExactPoint(b);
    const ExactPoint p(a), q(b);
    const Rational part = (meaning(time) - meaning(from)) / (meaning(to) - meaning(from));
    return {p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)};
  }
};

std::vector<Motion> motions_of(std::span<const Robot> robots, Ends ends) {
  std::vector<Motion> motions;
  for (std::size_t r = 0; r < robots.size(); ++r) {
    const auto& points = robots[r].points;
    const auto add = [&](std::size_t leg, double from, double to, Point a, Point b) {
      motions.push_back({r, leg, from, to, a, b, robots[r].radius});
    };
    const std::size_t last = points.size() - 1;
    if (ends == Ends::stay) add(0, -kEver, points[0].time, points[0].at, points[0].at);
    for (std::size_t i = 0; i < last; ++i) add(i, points[i].time, points[i + 1].time, points[i].at, points[i + 1].at);
    if (ends == Ends::stay || last == 0)
      add(last, points[last].time, ends == Ends::stay ? kEver : points[last].time, points[last].at, points[last].at);
  }
  return motions;
}

/// Two motions while both last: the second one relative to the first.
struct Meeting {
  const Motion& p;
  const Motion& q;
  double from, to;
  Point d, e;  ///< from the first robot to the second, at both times

  Meeting(const Motion& first, const Motion& second)
      : p(first), q(second), from(std::max(p.from, q.from)), to(std::min(p.to, q.to)), d(apart(from)), e(apart(to)) {}

  Point apart(double time) const {
    const Point a = p.at(time), b = q.at(time);
    return {b.x - a.x, b.y - a.y};
  }

  bool collides() const {
    if (from > to) return false;
    const double ux = e.x - d.x, uy = e.y - d.y, length = ux * ux + uy * uy;
    const double part = length > 0 ? std::clamp(-(ux * d.x + uy * d.y) / length, 0.0, 1.0) : 0;
    const double distance = std::hypot(d.x + part * ux, d.y + part * uy), reach = p.radius + q.radius;
    // A foot that is off by a little is as near but for a little more than the foot's error on the way.
    const double size = std::abs(d.x) + std::abs(d.y) + std::abs(e.x) + std::abs(e.y);
    const double error = 2 * (p.error(from) + q.error(from) + p.error(to) + q.error(to)) + 64 * kEps * (size + reach);
    if (distance > reach + error) return false;
    if (distance < reach - error) return true;
    return collides_exactly();
  }

  bool collides_exactly() const {
    const ExactPoint a = p.exactly_at(from), b = q.exactly_at(from), c = p.exactly_at(to), g = q.exactly_at(to);
    const Rational dx = b.x - a.x, dy = b.y - a.y, ux = g.x - c.x - dx, uy = g.y - c.y - dy;
    const Rational reach = meaning(p.radius) + meaning(q.radius), square = reach * reach;
    const Rational length = ux * ux + uy * uy, along = -(ux * dx + uy * dy);
    if (along <= 0) return dx * dx + dy * dy < square;
    if (along >= length) return (dx + ux) * (dx + ux) + (dy + uy) * (dy + uy) < square;
    const Rational across = dx * uy - dy * ux;
    return across * across < square * length;
  }

  /// When they overlap. Precondition: they collide.
  std::pair<double, double> times() const {
    const double ux = e.x - d.x, uy = e.y - d.y, length = ux * ux + uy * uy, reach = p.radius + q.radius;
    if (length == 0 || !std::isfinite(to - from)) return {from, to};
    const double along = -(ux * d.x + uy * d.y) / length, across = (d.x * uy - d.y * ux);
    const double half = std::sqrt(std::max(0.0, reach * reach * length - across * across)) / length;
    const auto time = [&](double part) { return part <= 0 ? from : part >= 1 ? to : from + part * (to - from); };
    return {time(along - half), time(along + half)};
  }

  Collision collision() const {
    const auto [begin, end] = times();
    const bool in_order = p.robot < q.robot;
    const Motion &first = in_order ? p : q, &second = in_order ? q : p;
    const double shown = std::isfinite(begin) ? begin : std::isfinite(end) ? end : 0;
    return {first.robot, second.robot, first.leg, second.leg, begin, end, first.at(shown), second.at(shown)};
  }
};

/// The box of the centre from one time to another, widened by the radius.
Box swept(const Motion& motion, double from, double to) {
  const Box box = box_around(motion.at(from), motion.at(to));
  return widened(box, motion.radius * (1 + 4 * kEps) + motion.error(from) + motion.error(to));
}

class Sweep {
 public:
  Sweep(std::vector<Motion> motions, std::size_t robots) : motions_(std::move(motions)) {
    const std::vector<double> cuts = slabs(robots);
    std::sort(motions_.begin(), motions_.end(), [](const Motion& p, const Motion& q) {
      return std::tie(p.from, p.robot, p.leg) < std::tie(q.from, q.robot, q.leg);
    });
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      std::erase_if(present_, [&](std::size_t m) { return motions_[m].to < cuts[i]; });
      for (; next < motions_.size() && motions_[next].from <= cuts[i + 1]; ++next) present_.push_back(next);
      look(cuts[i], cuts[i + 1]);
    }
  }

  std::vector<Collision> take() {
    std::sort(found_.begin(), found_.end(), [](const Collision& c, const Collision& d) {
      return std::tie(c.first, c.second, c.from, c.to) < std::tie(d.first, d.second, d.from, d.to);
    });
    std::vector<Collision> merged;
    for (const Collision& c : found_) {
      const bool goes_on = !merged.empty() && merged.back().first == c.first && merged.back().second == c.second &&
                           c.from <= merged.back().to;
      if (goes_on)
        merged.back().to = std::max(merged.back().to, c.to);
      else
        merged.push_back(c);
    }
    std::sort(merged.begin(), merged.end(), [](const Collision& c, const Collision& d) {
      return std::tie(c.from, c.first, c.second) < std::tie(d.from, d.first, d.second);
    });
    return merged;
  }

 private:
  struct Present {
    Box box;
    std::size_t motion;
  };

  /// Cuts of time at every so many beginnings of motions; the first and the last are infinite.
  std::vector<double> slabs(std::size_t robots) const {
    std::vector<double> begins, cuts{-kEver};
    for (const Motion& m : motions_)
      if (std::isfinite(m.from)) begins.push_back(m.from);
    std::sort(begins.begin(), begins.end());
    for (std::size_t i = 0; i < begins.size(); i += std::max<std::size_t>(robots, 1))
      if (begins[i] > cuts.back()) cuts.push_back(begins[i]);
    cuts.push_back(kEver);
    return cuts;
  }

  void look(double from, double to) {
    boxes_.clear();
    for (const std::size_t m : present_) boxes_.push_back({swept(motions_[m], from, to), m});
    std::sort(boxes_.begin(), boxes_.end(), [](const Present& p, const Present& q) {
      return std::tie(p.box.min.x, p.motion) < std::tie(q.box.min.x, q.motion);
    });
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      for (std::size_t k = i + 1; k < boxes_.size() && boxes_[k].box.min.x <= boxes_[i].box.max.x; ++k)
        if (boxes_[i].box.min.y <= boxes_[k].box.max.y && boxes_[k].box.min.y <= boxes_[i].box.max.y)
          ask(motions_[boxes_[i].motion], motions_[boxes_[k].motion]);
  }

  void ask(const Motion& p, const Motion& q) {
    if (p.robot == q.robot) return;
    const Meeting meeting(p, q);
    if (meeting.collides()) found_.push_back(meeting.collision());
  }

  std::vector<Motion> motions_;       ///< by their beginnings
  std::vector<std::size_t> present_;  ///< in the slab
  std::vector<Present> boxes_;
  std::vector<Collision> found_;
};

}  // namespace

std::vector<Collision> collisions(std::span<const Robot> robots, Ends ends) {
  return Sweep(motions_of(robots, ends), robots.size()).take();
}

}  // namespace taut::fleet
