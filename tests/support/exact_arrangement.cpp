#include <support/exact_arrangement.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace taut::test {

namespace {

using P = RationalPoint;
using Sectors = std::set<std::size_t>;

P minus(const P& p, const P& q) { return {p.x - q.x, p.y - q.y}; }
int cross(const P& u, const P& v) { return sgn(Rational(u.x * v.y - u.y * v.x)); }
int dot(const P& u, const P& v) { return sgn(Rational(u.x * v.x + u.y * v.y)); }
int side(const P& a, const P& b, const P& p) { return cross(minus(b, a), minus(p, a)); }
bool on(const P& p, const RationalWall& w) { return side(w.a, w.b, p) == 0 && dot(minus(w.a, p), minus(w.b, p)) <= 0; }
bool same_ray(const P& u, const P& v) { return cross(u, v) == 0 && dot(u, v) > 0; }
bool upper(const P& u) { return sgn(u.y) > 0 || (sgn(u.y) == 0 && sgn(u.x) > 0); }
/// By angle from the positive x axis.
bool before(const P& u, const P& v) { return upper(u) != upper(v) ? upper(u) : cross(u, v) > 0; }

/// The walls' directions around a point; sector i lies counter-clockwise of ray i.
class Around {
 public:
  Around(const P& centre, const std::vector<RationalWall>& walls) {
    for (const RationalWall& w : walls) {
      if (!on(centre, w)) continue;
      for (const P& end : {w.a, w.b})
        if (!(end == centre)) rays_.push_back(minus(end, centre));
    }
    std::sort(rays_.begin(), rays_.end(), before);
    rays_.erase(std::unique(rays_.begin(), rays_.end(), same_ray), rays_.end());
  }

  std::size_t count() const { return std::max<std::size_t>(rays_.size(), 1); }
  const std::vector<P>& rays() const { return rays_; }

  /// The sectors just left and just right of a direction.
  std::pair<std::size_t, std::size_t> beside(const P& d) const {
    if (rays_.empty()) return {0, 0};
    const std::size_t n = rays_.size();
    std::size_t i = 0;
    while (i < n && before(rays_[i], d)) ++i;
    const std::size_t less = (i + n - 1) % n;
    return {i < n && same_ray(rays_[i], d) ? i : less, less};
  }

 private:
  std::vector<P> rays_;
};

class Search {
 public:
  Search(const Rational& width, const Rational& height, std::vector<RationalWall> walls, const P& start, const P& goal)
      : width_(width), height_(height), walls_(std::move(walls)) {
    const P corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (int i = 0; i < 4; ++i) walls_.push_back({corners[i], corners[(i + 1) % 4]});
    std::set<P> places{start, goal};
    for (const RationalWall& w : walls_) places.insert({w.a, w.b});
    for (const P& p : places) {
      if (p == start) start_ = places_.size();
      if (p == goal) goal_ = places_.size();
      places_.push_back(p);
      around_.emplace_back(p, walls_);
      first_.push_back(nodes_);
      nodes_ += around_.back().count();
    }
  }

  std::optional<double> run() {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::vector<double> length(nodes_, kFar);
    std::vector<bool> done(nodes_, false);
    for (std::size_t s = 0; s < around_[start_].count(); ++s)
      if (inside(start_, s)) length[first_[start_] + s] = 0;
    for (;;) {
      std::size_t best = nodes_;
      for (std::size_t v = 0; v < nodes_; ++v)
        if (!done[v] && length[v] < kFar && (best == nodes_ || length[v] < length[best])) best = v;
      if (best == nodes_) return std::nullopt;
      done[best] = true;
      const std::size_t p =
          static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), best) - first_.begin()) - 1;
      if (p == goal_) return length[best];
      for (std::size_t q = 0; q < places_.size(); ++q) {
        if (q == p) continue;
        for (const std::size_t s : leg(p, {best - first_[p]}, q))
          length[first_[q] + s] = std::min(length[first_[q] + s], length[best] + distance(p, q));
      }
    }
  }

 private:
  double distance(std::size_t p, std::size_t q) const {
    const P d = minus(places_[p], places_[q]);
    return std::sqrt(to_double(Rational(d.x * d.x + d.y * d.y)));
  }

  /// Is a sector within the box? On its rim the rim's own rays bound it.
  bool inside(std::size_t p, std::size_t sector) const {
    const Around& a = around_[p];
    if (a.rays().empty()) return true;
    const P at = places_[p], u = a.rays()[sector], v = a.rays()[(sector + 1) % a.rays().size()];
    if (sgn(at.x) > 0 && at.x < width_ && sgn(at.y) > 0 && at.y < height_) return true;
    // Outwards between them, if a normal that points out of the box lies in the open sector.
    const auto holds = [&](const P& d) {
      if (same_ray(u, d) || same_ray(v, d)) return false;
      const auto [left, right] = a.beside(d);
      return left == sector;
    };
    return !((sgn(at.x) == 0 && holds({-1, 0})) || (at.x == width_ && holds({1, 0})) ||
             (sgn(at.y) == 0 && holds({0, -1})) || (at.y == height_ && holds({0, 1})));
  }

  /// In which sectors at q a straight leg from p can end.
  Sectors leg(std::size_t p, Sectors at, std::size_t q) const {
    const P from = places_[p], to = places_[q], way = minus(to, from), back = minus(from, to);
    std::set<P> stops;
    for (const RationalWall& w : walls_) {
      const int a = side(from, to, w.a), b = side(from, to, w.b), c = side(w.a, w.b, from), d = side(w.a, w.b, to);
      if (a * b < 0 && c * d < 0) return {};
      for (const P& end : {w.a, w.b})
        if (!(end == from) && !(end == to) && on(end, {from, to})) stops.insert(end);
    }
    std::vector<P> order(stops.begin(), stops.end());
    if (to < from) std::reverse(order.begin(), order.end());
    order.push_back(to);
    Around here = around_[p];
    for (const P& stop : order) {
      const auto [left, right] = here.beside(way);
      const bool on_left = at.contains(left), on_right = at.contains(right);
      Around next(stop, walls_);
      const auto [back_left, back_right] = next.beside(back);
      at.clear();
      if (on_left) at.insert(back_right);
      if (on_right) at.insert(back_left);
      if (at.empty()) return at;
      here = std::move(next);
    }
    std::erase_if(at, [&](std::size_t s) { return !inside(q, s); });
    return at;
  }

  Rational width_, height_;
  std::vector<RationalWall> walls_;
  std::vector<P> places_;
  std::vector<Around> around_;
  std::vector<std::size_t> first_;
  std::size_t nodes_ = 0, start_ = 0, goal_ = 0;
};

}  // namespace

std::optional<double> arrangement_path(const Rational& width, const Rational& height,
                                       const std::vector<RationalWall>& walls, const RationalPoint& start,
                                       const RationalPoint& goal) {
  if (start == goal) return 0;
  return Search(width, height, walls, start, goal).run();
}

}  // namespace taut::test
