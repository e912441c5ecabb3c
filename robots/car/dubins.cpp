#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <taut/robots/car/curve_bound.h>
#include <taut/robots/car/curve_path.h>

namespace taut::car {

namespace {

constexpr double kTurn2 = 2 * std::numbers::pi;
constexpr double kRounding = 1e-12;  // of what is 0 where a word begins to exist

/// A word: lengths in radii.
struct Word {
  double t = std::numeric_limits<double>::infinity(), p = 0, q = 0;
  double length() const { return t + p + q; }
};

/// The six words, for a goal at distance d straight ahead of a frame in which the headings are a and b.
class Words {
 public:
  Words(double d, double a, double b, double snap)
      : d_(d),
        a_(a),
        b_(b),
        snap_(snap),
        sa_(std::sin(a)),
        sb_(std::sin(b)),
        ca_(std::cos(a)),
        cb_(std::cos(b)),
        cab_(std::cos(a - b)) {}

  Word of(int index) const {
    switch (index) {
      case 0: return lsl();
      case 1: return rsr();
      case 2: return lsr();
      case 3: return rsl();
      case 4: return rlr();
      default: return lrl();
    }
  }

 private:
  double mod(double x) const {
    const double y = x - kTurn2 * std::floor(x / kTurn2);
    return y >= kTurn2 - snap_ ? 0 : y;
  }
  /// Both circles are one: the direction between their centres says nothing.
  bool is_one_arc(double p) const { return p <= kRounding * (1 + d_); }
  static bool exists(double square) { return square >= -kRounding; }
  static double root(double square) { return std::sqrt(std::max(square, 0.0)); }

  Word lsl() const {
    const double x = d_ + sa_ - sb_, y = cb_ - ca_, p = std::hypot(x, y), way = is_one_arc(p) ? a_ : std::atan2(y, x);
    return {mod(way - a_), p, mod(b_ - way)};
  }
  Word rsr() const {
    const double x = d_ - sa_ + sb_, y = ca_ - cb_, p = std::hypot(x, y), way = is_one_arc(p) ? a_ : std::atan2(y, x);
    return {mod(a_ - way), p, mod(way - b_)};
  }
  Word lsr() const {
    const double square = -2 + d_ * d_ + 2 * cab_ + 2 * d_ * (sa_ + sb_);
    if (!exists(square)) return {};
    const double p = root(square), way = std::atan2(-ca_ - cb_, d_ + sa_ + sb_) - std::atan2(-2, p);
    return {mod(way - a_), p, mod(way - b_)};
  }
  Word rsl() const {
    const double square = -2 + d_ * d_ + 2 * cab_ - 2 * d_ * (sa_ + sb_);
    if (!exists(square)) return {};
    const double p = root(square), way = std::atan2(ca_ + cb_, d_ - sa_ - sb_) - std::atan2(2, p);
    return {mod(a_ - way), p, mod(b_ - way)};
  }
  Word rlr() const {
    const double cosine = (6 - d_ * d_ + 2 * cab_ + 2 * d_ * (sa_ - sb_)) / 8;
    if (std::abs(cosine) > 1 + kRounding) return {};
    const double p = kTurn2 - std::acos(std::clamp(cosine, -1.0, 1.0));
    const double t = mod(a_ - std::atan2(ca_ - cb_, d_ - sa_ + sb_) + p / 2);
    return {t, p, mod(a_ - b_ - t + p)};
  }
  Word lrl() const {
    const double cosine = (6 - d_ * d_ + 2 * cab_ + 2 * d_ * (sb_ - sa_)) / 8;
    if (std::abs(cosine) > 1 + kRounding) return {};
    const double p = kTurn2 - std::acos(std::clamp(cosine, -1.0, 1.0));
    const double t = mod(-a_ - std::atan2(ca_ - cb_, d_ + sa_ - sb_) + p / 2);
    return {t, p, mod(b_ - a_ - t + p)};
  }

  double d_, a_, b_, snap_, sa_, sb_, ca_, cb_, cab_;
};

using Kind = CurveSegment::Kind;
constexpr std::array<std::array<Kind, 3>, 6> kKinds{{{Kind::left, Kind::straight, Kind::left},
                                                     {Kind::right, Kind::straight, Kind::right},
                                                     {Kind::left, Kind::straight, Kind::right},
                                                     {Kind::right, Kind::straight, Kind::left},
                                                     {Kind::right, Kind::left, Kind::right},
                                                     {Kind::left, Kind::right, Kind::left}}};

Words words_of(const Pose& from, const Pose& to, double radius, double snap) {
  const double dx = to.x - from.x, dy = to.y - from.y, way = std::atan2(dy, dx);
  return {std::hypot(dx, dy) / radius, from.heading - way, to.heading - way, snap};
}

}  // namespace

CurvePath dubins_path(const Pose& from, const Pose& to, double radius) {
  const Words words = words_of(from, to, radius, 1e-10);
  Word best;
  std::size_t which = 0;
  for (std::size_t i = 0; i < kKinds.size(); ++i)
    if (const Word word = words.of(static_cast<int>(i)); word.length() < best.length()) best = word, which = i;
  std::vector<CurveSegment> segments;
  const double lengths[] = {best.t, best.p, best.q};
  for (std::size_t k = 0; k < 3; ++k)
    if (lengths[k] > 0) segments.push_back({kKinds[which][k], lengths[k] * radius});
  return {from, radius, std::move(segments)};
}

double detail::dubins_bound(const Pose& from, const Pose& to, double radius) {
  const Words words = words_of(from, to, radius, kBoundSnap);
  Word best;
  for (int i = 0; i < 6; ++i)
    if (const Word word = words.of(i); word.length() < best.length()) best = word;
  return std::max(0.0, radius * (best.length() - 4 * kBoundSnap));
}

}  // namespace taut::car
