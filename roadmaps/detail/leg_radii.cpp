#include <taut/roadmaps/detail/leg_radii.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

constexpr std::size_t kMostParts = 4096;  // of one leg's range
constexpr double kFinest = 0x1p-24;       // of a range

Point minus(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
double dot(Point p, Point q) { return p.x * q.x + p.y * q.y; }
double cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }

}  // namespace

PlainLeg LegRadii::at(Turn turn) const {
  const double c = turn.cosine, s = hand_ * turn.sine, r = turns_ ? arm_ * turn.sine : turn.sine;
  const Point u = turns_ ? Point{c * d_.x - s * d_.y, c * d_.y + s * d_.x} : d_, a = a_->at;
  return {{a.x + s_ * r * u.y, a.y - s_ * r * u.x}, u, turns_ ? length_ * c : length_};
}

double LegRadii::radius(double x) const { return turns_ ? arm_ * std::sin(x) : x; }

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
    low_ = std::asin(std::min(1.0, least_ / arm_));
    high_ = std::asin(std::min(1.0, most_ / arm_));
  }
  // Positions are off by some ulp of the coordinates, and by what the direction is off.
  slack_ = 0x1p-46 * scale_ * (1 + most_ / length_);
  parts_ = 0;
  own_.clear();
  walls_.clear();
  ranges_.clear();
  return most_ > least_;
}

std::vector<RadiusSpan> LegRadii::spans(const TangentName& name, double most) {
  if (!set_up(name, most) || !find_own(*a_, s_, false) || !find_own(*b_, t_, true) || !find_walls(most)) return {};
  turns_ ? follow_turning() : follow_steady();
  return spans_found();
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
  const double half = (high_ - low_) / 2, middle = (low_ + high_) / 2;
  const Point u = at({std::cos(middle), std::sin(middle)}).along;
  return std::none_of(own_.begin(), own_.end(),
                      [&](const Own& own) { return own.side * cross(u, own.direction) < -(half * 1.001 + own.slack); });
}

bool LegRadii::concerns(const Segment& wall, bool& blocks) const {
  const Point a = a_->at, b = b_->at;
  for (const auto& [site, side] : {std::pair{a_, s_}, std::pair{b_, t_}})
    if (side != 0 && (wall.a == site->at || wall.b == site->at)) return false;
  if (s_ == t_ && s_ != 0)
    return s_ * written::orientation(a, b, wall.a) < 0 || s_ * written::orientation(a, b, wall.b) < 0;
  if (PlainLeg{a, d_, length_}.clears(wall.a, wall.b, 0, 2 * most_ + 4 * slack_) > 0) return false;
  // Its disc sweeps all between the corners.
  if (turns_)
    for (const Point w : {wall.a, wall.b})
      if (dot(minus(w, a), d_) > slack_ && dot(minus(b, w), d_) > slack_ && written::orientation(a, b, w) == 0)
        blocks = true;
  return true;
}

/// Around a part of the way between the corners, as wide as tangents of circles of radius `most` reach.
Box LegRadii::box(double from, double to, double most) const {
  const Point a = a_->at, b = b_->at;
  const double reach = 2.001 * most + 0x1p-44 * scale_ * (1 + most / length_);
  const Point p{a.x + from * (b.x - a.x), a.y + from * (b.y - a.y)}, q{a.x + to * (b.x - a.x), a.y + to * (b.y - a.y)};
  return {{std::min(p.x, q.x) - reach, std::min(p.y, q.y) - reach},
          {std::max(p.x, q.x) + reach, std::max(p.y, q.y) + reach}};
}

/// What is near the tangents of a pair of corners, once for all four.
void LegRadii::gather(double most) {
  if (near_from_ == a_ && near_to_ == b_) return;
  near_from_ = a_;
  near_to_ = b_;
  near_.clear();
  openings_ = false;
  const Point a = a_->at, b = b_->at;
  const int pieces =
      static_cast<int>(std::clamp(std::min(std::abs(b.x - a.x), std::abs(b.y - a.y)) / (8 * most), 1.0, 64.0));
  const PlainLeg leg{a, d_, length_};
  for (int i = 0; i < pieces; ++i)
    ground_.walls.walls().walls_meeting(box(double(i) / pieces, double(i + 1) / pieces, most), [&](std::uint32_t c) {
      const Segment wall = ground_.walls.walls().segment(c);
      if (leg.clears(wall.a, wall.b, 0, 2.001 * most + 4 * slack_) <= 0) near_.push_back(wall);
    });
  ground_.walls.openings_meeting(box(0, 1, most), [&](std::uint32_t) { openings_ = true; });
}

bool LegRadii::find_walls(double most) {
  gather(most);
  bool blocks = false;
  for (const Segment& wall : near_) {
    if (concerns(wall, blocks)) walls_.push_back({wall.a, wall.b});
    if (blocks) return false;
  }
  asks_ = false;
  if (openings_) ground_.walls.openings_meeting(box(0, 1, most_), [&](std::uint32_t) { asks_ = true; });
  return true;
}

/// Of the walls all: +1 none is nearer than the radius, -1 one is, 0 doubles cannot tell.
int LegRadii::state(double r) const {
  const PlainLeg leg = at({1, r});
  int least = 1;
  for (const PlainSegment& wall : walls_) {
    least = std::min(least, leg.clears(wall.a, wall.b, r - slack_, r + slack_));
    if (least < 0) break;
  }
  return least;
}

void LegRadii::follow_steady() {
  const int first = state(least_), last = first < 0 ? -1 : state(most_);
  if (first < 0) return;
  if (last > 0) return emit(least_, most_, true);
  const auto bisect = [&](double low, double high, auto&& is_low) {
    while (high - low > kFinest * most_) {
      const double middle = low + (high - low) / 2;
      (is_low(state(middle)) ? low : high) = middle;
    }
    return std::pair(low, high);
  };
  // The largest radius known to be free, and the smallest one known not to be.
  double free = least_, blocked = least_;
  if (first > 0) std::tie(free, blocked) = bisect(least_, most_, [](int at) { return at > 0; });
  double end = most_;
  if (last < 0) end = state(blocked) < 0 ? blocked : bisect(blocked, most_, [](int at) { return at >= 0; }).second;
  if (first > 0) emit(least_, free, true);
  emit(first > 0 ? free : least_, end, false);
}

void LegRadii::follow_turning() {
  // Angles are halved again and again: what a range's half turns by.
  halves_.clear();
  const double half = (high_ - low_) / 2, middle = low_ + half;
  halves_.push_back({std::cos(half), std::sin(half)});
  divide(low_, high_, {std::cos(middle), std::sin(middle)}, {0, 0, 0});
}

LegRadii::Turn LegRadii::half_turn(std::size_t depth) {
  while (halves_.size() <= depth) {
    const Turn whole = halves_.back();
    const double cosine = std::sqrt((1 + whole.cosine) / 2);
    halves_.push_back({cosine, whole.sine / (2 * cosine)});
  }
  return halves_[depth];
}

void LegRadii::divide(double from, double to, Turn middle, const Stack& stack) {
  const double half = (to - from) / 2 * (1 + 1e-9), r = arm_ * middle.sine;
  const std::size_t own_end = own_.size(), walls_end = walls_.size();
  const auto leave = [&] {
    own_.resize(own_end);
    walls_.resize(walls_end);
  };
  const PlainLeg leg = at(middle);
  for (std::size_t i = stack.first_own; i < own_end; ++i) {
    const double value = own_[i].side * cross(leg.along, own_[i].direction), sure = half + own_[i].slack;
    if (value < -sure) return leave();
    if (value <= sure) own_.push_back(Own(own_[i]));
  }
  const double sure = 2 * arm_ * half + slack_;
  for (std::size_t i = stack.first_wall; i < walls_end; ++i) {
    const int state = leg.clears(walls_[i].a, walls_[i].b, r - sure, r + sure);
    if (state < 0) return leave();
    if (state == 0) walls_.push_back(PlainSegment(walls_[i]));
  }
  const bool certain = own_.size() == own_end && walls_.size() == walls_end;
  if (certain || to - from < kFinest || ++parts_ > kMostParts) {
    emit(from, to, certain);
  } else {
    const Turn h = half_turn(stack.depth + 1);
    const double c = middle.cosine, s = middle.sine, x = from + (to - from) / 2;
    divide(from, x, {c * h.cosine + s * h.sine, s * h.cosine - c * h.sine}, {own_end, walls_end, stack.depth + 1});
    divide(x, to, {c * h.cosine - s * h.sine, s * h.cosine + c * h.sine}, {own_end, walls_end, stack.depth + 1});
  }
  leave();
}

/// A range of the parameter, behind those before.
void LegRadii::emit(double from, double to, bool certain) {
  if (!ranges_.empty() && ranges_.back().certain == certain && ranges_.back().to == from)
    ranges_.back().to = to;
  else
    ranges_.push_back({from, to, certain});
}

/// Certain ones are taken a bit smaller, the others larger.
std::vector<RadiusSpan> LegRadii::spans_found() const {
  std::vector<RadiusSpan> result;
  const auto add = [&](const RadiusSpan& span) {
    if (span.from > span.to) return;
    if (result.empty() || result.back().certain != span.certain || result.back().to < span.from)
      result.push_back(span);
    else
      result.back().to = span.to;
  };
  for (const RadiusSpan& range : ranges_) {
    const double more = (range.certain ? -1 : 1) * slack_;
    add({radius(range.from) - more, radius(range.to) + more, range.certain && !asks_});
  }
  // Where it has no length any more there is no larger radius to end the range.
  if (turns_ && most_ == arm_ && !result.empty() && result.back().to > arm_ - 3 * slack_)
    add({arm_ - 3 * slack_, arm_ + 3 * slack_, false});
  return result;
}

}  // namespace taut::detail
