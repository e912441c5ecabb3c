#include <taut/roadmaps/detail/leg_radii.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

constexpr std::size_t kMostParts = 4096;  // of one leg's range
constexpr double kFinest = 0x1p-30;       // of a range

Point minus(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
double dot(Point p, Point q) { return p.x * q.x + p.y * q.y; }
double cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }

double squared_distance(Point p, Point a, Point b) {
  const Point f = minus(b, a), v = minus(p, a);
  const double along = dot(f, v), all = dot(f, f);
  if (along <= 0 || all == 0) return dot(v, v);
  if (along >= all) return dot(minus(p, b), minus(p, b));
  const double off = cross(f, v);
  return off * off / all;
}

double distance(Point a, Point b, Point w, Point v) {
  const Point f = minus(b, a), e = minus(v, w);
  if (cross(f, minus(w, a)) * cross(f, minus(v, a)) < 0 && cross(e, minus(a, w)) * cross(e, minus(b, w)) < 0) return 0;
  return std::sqrt(std::min(std::min(squared_distance(a, w, v), squared_distance(b, w, v)),
                            std::min(squared_distance(w, a, b), squared_distance(v, a, b))));
}

}  // namespace

Point LegRadii::direction(double x) const {
  if (!turns_) return d_;
  const double c = std::cos(x), s = hand_ * std::sin(x);
  return {c * d_.x - s * d_.y, c * d_.y + s * d_.x};
}

double LegRadii::radius(double x) const { return turns_ ? arm_ * std::sin(x) : x; }

LegRadii::Leg LegRadii::at(double x) const {
  const Point u = direction(x), a = a_->at, b = b_->at;
  const double r = radius(x);
  return {{a.x + s_ * r * u.y, a.y - s_ * r * u.x}, {b.x + t_ * r * u.y, b.y - t_ * r * u.x}, r};
}

double LegRadii::gap(const Leg& leg, const PlainSegment& wall) {
  return distance(leg.from, leg.to, wall.a, wall.b) - leg.radius;
}

bool LegRadii::set_up(const TangentName& name, double most) {
  a_ = &ground_.sites[name.from];
  b_ = &ground_.sites[name.to];
  s_ = name.from_side;
  t_ = name.to_side;
  const Point d = minus(b_->at, a_->at);
  length_ = std::hypot(d.x, d.y);
  d_ = {d.x / length_, d.y / length_};
  turns_ = s_ != t_;
  most_ = most;
  if (turns_) {
    hand_ = s_ > t_ ? 1 : -1;
    arm_ = length_ / std::abs(s_ - t_);
    most_ = std::min(most_, arm_);
  }
  // Positions are off by some ulp of the coordinates, and by what the direction is off.
  slack_ = 0x1p-46 * scale_ * (1 + most_ / length_);
  asks_ = false;
  parts_ = 0;
  own_.clear();
  walls_.clear();
  spans_.clear();
  return most_ > least_;
}

std::vector<RadiusSpan> LegRadii::spans(const TangentName& name, double most) {
  if (!set_up(name, most) || !find_own(*a_, s_, false) || !find_own(*b_, t_, true) || !find_walls()) return {};
  turns_ ? follow_turning() : follow_steady();
  if (asks_)
    for (RadiusSpan& span : spans_) span.certain = false;
  return spans_;
}

/// The walls that end in a circle's centre keep clear of a leg iff they lead away from it (TangentLine::clears_own).
bool LegRadii::find_own(const TangentSite& site, int side, bool second) {
  if (side == 0) return true;
  for (const Point w : site.walls) {
    if (!turns_) {
      const int order = second ? written::orientation(b_->at, w, a_->at) : written::orientation(a_->at, b_->at, w);
      if (side * order < 0) return false;
      continue;
    }
    const Point f = minus(w, site.at);
    const double size = std::hypot(f.x, f.y);
    own_.push_back({{f.x / size, f.y / size}, side, 0x1p-46 * scale_ * (1 / size + 1 / length_)});
  }
  if (!turns_) return true;
  // For the whole range, before walls are looked for.
  const double low = std::asin(std::min(1.0, least_ / arm_)), high = std::asin(std::min(1.0, most_ / arm_));
  const double half = (high - low) / 2;
  const Point u = direction((low + high) / 2);
  return std::none_of(own_.begin(), own_.end(),
                      [&](const Own& own) { return own.side * cross(u, own.direction) < -(half * 1.001 + own.slack); });
}

bool LegRadii::concerns(const Segment& wall, bool& blocks) const {
  const Point a = a_->at, b = b_->at;
  for (const auto& [site, side] : {std::pair{a_, s_}, std::pair{b_, t_}})
    if (side != 0 && (wall.a == site->at || wall.b == site->at)) return false;
  if (s_ == t_ && s_ != 0)
    return s_ * written::orientation(a, b, wall.a) < 0 || s_ * written::orientation(a, b, wall.b) < 0;
  if (distance(a, b, wall.a, wall.b) > 2 * most_ + 4 * slack_) return false;
  // Its disc sweeps all between the corners.
  if (turns_)
    for (const Point w : {wall.a, wall.b})
      if (dot(minus(w, a), d_) > slack_ && dot(minus(b, w), d_) > slack_ && written::orientation(a, b, w) == 0)
        blocks = true;
  return true;
}

bool LegRadii::find_walls() {
  const Point a = a_->at, b = b_->at;
  const double reach = 2.001 * most_ + 4 * slack_;
  const int pieces =
      static_cast<int>(std::clamp(std::min(std::abs(b.x - a.x), std::abs(b.y - a.y)) / (8 * most_), 1.0, 64.0));
  bool blocks = false;
  const auto box = [&](double from, double to) {
    const Point p{a.x + from * (b.x - a.x), a.y + from * (b.y - a.y)},
        q{a.x + to * (b.x - a.x), a.y + to * (b.y - a.y)};
    return Box{{std::min(p.x, q.x) - reach, std::min(p.y, q.y) - reach},
               {std::max(p.x, q.x) + reach, std::max(p.y, q.y) + reach}};
  };
  for (int i = 0; i < pieces && !blocks; ++i)
    ground_.walls.walls().walls_meeting(box(double(i) / pieces, double(i + 1) / pieces), [&](std::uint32_t c) {
      const Segment wall = ground_.walls.walls().segment(c);
      if (!blocks && concerns(wall, blocks)) walls_.push_back({wall.a, wall.b});
    });
  if (blocks) return false;
  ground_.walls.openings_meeting(box(0, 1), [&](std::uint32_t) { asks_ = true; });
  return true;
}

void LegRadii::follow_steady() {
  double free = least_, blocked = least_;
  const auto margin = [&](double x, double& least_gap) {
    const Leg leg = at(x);
    least_gap = std::numeric_limits<double>::infinity();
    for (const PlainSegment& wall : walls_) least_gap = std::min(least_gap, gap(leg, wall));
  };
  double here = 0;
  margin(least_, here);
  if (here < -slack_) return;
  const bool begins = here > slack_;
  margin(most_, here);
  if (here > slack_) return emit(least_, most_, true);
  const bool ends = here < -slack_;
  // The largest radius known to be free, and the smallest one known not to be.
  const auto bisect = [&](double low, double high, auto&& is_low) {
    while (high - low > kFinest * most_) {
      const double middle = low + (high - low) / 2;
      margin(middle, here);
      (is_low(here) ? low : high) = middle;
    }
    return std::pair(low, high);
  };
  if (begins) std::tie(free, blocked) = bisect(least_, most_, [&](double g) { return g > slack_; });
  double last = most_;
  if (ends) {
    margin(blocked, here);
    last = here < -slack_ ? blocked : bisect(blocked, most_, [&](double g) { return g >= -slack_; }).second;
  }
  if (begins) emit(least_, free, true);
  emit(begins ? free : least_, last, false);
}

void LegRadii::follow_turning() {
  const double low = std::asin(std::min(1.0, least_ / arm_)), high = std::asin(std::min(1.0, most_ / arm_));
  divide(low, high, 0, 0);
  // Where it has no length any more there is no larger radius to end the range.
  if (most_ == arm_ && !spans_.empty() && spans_.back().to > arm_ - 3 * slack_)
    spans_.push_back({arm_ - 3 * slack_, arm_ + 3 * slack_, false});
}

void LegRadii::divide(double from, double to, std::size_t first_own, std::size_t first_wall) {
  const double x = from + (to - from) / 2, half = (to - from) / 2 * (1 + 1e-9);
  const std::size_t own_end = own_.size(), walls_end = walls_.size();
  const auto leave = [&] {
    own_.resize(own_end);
    walls_.resize(walls_end);
  };
  const Point u = direction(x);
  for (std::size_t i = first_own; i < own_end; ++i) {
    const double value = own_[i].side * cross(u, own_[i].direction), sure = half + own_[i].slack;
    if (value < -sure) return leave();
    if (value <= sure) own_.push_back(Own(own_[i]));
  }
  const Leg leg = at(x);
  for (std::size_t i = first_wall; i < walls_end; ++i) {
    const double value = gap(leg, walls_[i]), sure = 2 * arm_ * half + slack_;
    if (value < -sure) return leave();
    if (value <= sure) walls_.push_back(PlainSegment(walls_[i]));
  }
  const bool certain = own_.size() == own_end && walls_.size() == walls_end;
  if (certain || to - from < kFinest || ++parts_ > kMostParts) {
    emit(from, to, certain);
  } else {
    divide(from, x, own_end, walls_end);
    divide(x, to, own_end, walls_end);
  }
  leave();
}

/// A range of the parameter: certain ones are taken a bit smaller, the others larger.
void LegRadii::emit(double from, double to, bool certain) {
  const double more = (certain ? -1 : 1) * slack_;
  const RadiusSpan span{radius(from) - more, radius(to) + more, certain};
  if (span.from > span.to) return;
  if (spans_.empty() || spans_.back().certain != certain || spans_.back().to < span.from - 3 * slack_)
    spans_.push_back(span);
  else
    spans_.back().to = span.to;
}

}  // namespace taut::detail
