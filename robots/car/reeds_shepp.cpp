#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <taut/robots/car/curve_bound.h>
#include <taut/robots/car/curve_path.h>

namespace taut::car {

namespace {

using Kind = CurveSegment::Kind;
constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-12;  // of a sign that decides whether a word exists
constexpr double kEndsThere = 1e-8;  // radii and radians: a word that misses by more is none

double mod(double x) { return std::remainder(x, 2 * kPi); }

bool positive(double x) { return x >= -kRounding; }
bool negative(double x) { return x <= kRounding; }

struct Polar {
  Polar(double x, double y) : r(std::hypot(x, y)), angle(std::atan2(y, x)) {}
  double r, angle;
};

/// Signed lengths in radii.
struct Word {
  std::array<Kind, 5> kinds{};
  std::array<double, 5> lengths{};
  std::size_t count = 0;

  void add(Kind kind, double length) {
    kinds[count] = kind;
    lengths[count++] = length;
  }
  double length() const {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += std::abs(lengths[i]);
    return sum;
  }
};

/// A goal in the car's frame, in radii.
struct Target {
  double x, y, phi;
  double left_x() const { return x - std::sin(phi); }  // of the circle to the goal's left, from the one to the start's
  double left_y() const { return y - 1 + std::cos(phi); }
  double right_x() const { return x + std::sin(phi); }
  double right_y() const { return y - 1 - std::cos(phi); }
};

constexpr Kind L = Kind::left, S = Kind::straight, R = Kind::right;

Word word(std::initializer_list<std::pair<Kind, double>> segments) {
  Word w;
  for (const auto& [kind, length] : segments) w.add(kind, length);
  return w;
}

using Formula = std::optional<Word> (*)(const Target&);

// 8.1
std::optional<Word> lsl(const Target& g) {
  const Polar to(g.left_x(), g.left_y());
  const double v = mod(g.phi - to.angle);
  if (!positive(to.angle) || !positive(v)) return std::nullopt;
  return word({{L, to.angle}, {S, to.r}, {L, v}});
}

// 8.2
std::optional<Word> lsr(const Target& g) {
  const Polar to(g.right_x(), g.right_y());
  const double square = to.r * to.r - 4;
  if (!positive(square)) return std::nullopt;
  const double u = std::sqrt(std::max(square, 0.0)), t = mod(to.angle + std::atan2(2, u)), v = mod(t - g.phi);
  if (!positive(t) || !positive(v)) return std::nullopt;
  return word({{L, t}, {S, u}, {R, v}});
}

// 8.3, 8.4
std::optional<Word> lrl(const Target& g) {
  const Polar to(g.left_x(), g.left_y());
  if (to.r > 4 + kRounding) return std::nullopt;
  const double u = -2 * std::asin(std::min(to.r / 4, 1.0)), t = mod(to.angle + u / 2 + kPi), v = mod(g.phi - t + u);
  if (!positive(t)) return std::nullopt;
  return word({{L, t}, {R, u}, {L, v}});
}

/// t and v of the words with two arcs of sizes u, v in the middle.
std::pair<double, double> outer_arcs(double u, double v, double x, double y, double phi) {
  const double delta = mod(u - v), a = std::sin(u) - std::sin(delta), b = std::cos(u) - std::cos(delta) - 1;
  const double first = std::atan2(y * a - x * b, x * a + y * b);
  const double side = 2 * (std::cos(delta) - std::cos(v) - std::cos(u)) + 3;
  const double t = mod(side < 0 ? first + kPi : first);
  return {t, mod(t - u + v - phi)};
}

// 8.7
std::optional<Word> lr_lr(const Target& g) {
  const double x = g.right_x(), y = g.right_y(), cosine = (2 + std::hypot(x, y)) / 4;
  if (cosine > 1 + kRounding) return std::nullopt;
  const double u = std::acos(std::min(cosine, 1.0));
  const auto [t, v] = outer_arcs(u, -u, x, y, g.phi);
  if (!positive(t) || !negative(v)) return std::nullopt;
  return word({{L, t}, {R, u}, {L, -u}, {R, v}});
}

// 8.8
std::optional<Word> l_rl_r(const Target& g) {
  const double x = g.right_x(), y = g.right_y(), cosine = (20 - x * x - y * y) / 16;
  if (cosine < -kRounding || cosine > 1 + kRounding) return std::nullopt;
  const double u = -std::acos(std::clamp(cosine, 0.0, 1.0));
  const auto [t, v] = outer_arcs(u, u, x, y, g.phi);
  if (!positive(t) || !positive(v)) return std::nullopt;
  return word({{L, t}, {R, u}, {L, u}, {R, v}});
}

// 8.9
std::optional<Word> l_rsl(const Target& g) {
  const Polar to(g.left_x(), g.left_y());
  const double square = to.r * to.r - 4;
  if (!positive(square)) return std::nullopt;
  const double r = std::sqrt(std::max(square, 0.0)), u = 2 - r;
  const double t = mod(to.angle + std::atan2(r, -2)), v = mod(g.phi - kPi / 2 - t);
  if (!positive(t) || !negative(u) || !negative(v)) return std::nullopt;
  return word({{L, t}, {R, -kPi / 2}, {S, u}, {L, v}});
}

// 8.10
std::optional<Word> l_rsr(const Target& g) {
  const Polar to(-g.right_y(), g.right_x());
  const double u = 2 - to.r, v = mod(to.angle + kPi / 2 - g.phi);
  if (!positive(to.angle) || !negative(u) || !negative(v)) return std::nullopt;
  return word({{L, to.angle}, {R, -kPi / 2}, {S, u}, {R, v}});
}

// 8.11
std::optional<Word> l_rsl_r(const Target& g) {
  const double x = g.right_x(), y = g.right_y(), square = x * x + y * y - 4;
  if (!positive(square)) return std::nullopt;
  const double u = 4 - std::sqrt(std::max(square, 0.0));
  const double t = mod(std::atan2((4 - u) * x - 2 * y, -2 * x + (u - 4) * y)), v = mod(t - g.phi);
  if (!positive(t) || !negative(u) || !positive(v)) return std::nullopt;
  return word({{L, t}, {R, -kPi / 2}, {S, u}, {L, -kPi / 2}, {R, v}});
}

struct Family {
  Formula formula;
  bool also_reversed;  // the order of segments; the others are their own reverse up to mirroring
};
constexpr std::array<Family, 8> kFamilies{{{lsl, false},
                                           {lsr, false},
                                           {lrl, true},
                                           {lr_lr, false},
                                           {l_rl_r, false},
                                           {l_rsl, true},
                                           {l_rsr, true},
                                           {l_rsl_r, false}}};

bool ends_at(const Word& w, const Target& goal) {
  double x = 0, y = 0, h = 0;
  for (std::size_t i = 0; i < w.count; ++i) {
    const double length = w.lengths[i];
    if (w.kinds[i] == S) {
      x += length * std::cos(h);
      y += length * std::sin(h);
      continue;
    }
    const double turn = w.kinds[i] == L ? length : -length, chord = 2 * std::sin(length / 2);
    x += chord * std::cos(h + turn / 2);
    y += chord * std::sin(h + turn / 2);
    h += turn;
  }
  const double scale = 1 + std::hypot(goal.x, goal.y);
  return std::hypot(x - goal.x, y - goal.y) <= kEndsThere * scale && std::abs(mod(h - goal.phi)) <= kEndsThere;
}

/// The word of the formula for the goal as seen with time reversed, mirrored, or from the goal back, brought back to
/// what it means for the goal itself.
void consider(const Family& family, const Target& goal, bool backwards, bool mirrored, bool reversed, Word& best,
              double& least) {
  Target g = goal;
  if (reversed)
    g = {g.x * std::cos(g.phi) + g.y * std::sin(g.phi), g.x * std::sin(g.phi) - g.y * std::cos(g.phi), g.phi};
  if (backwards) g = {-g.x, g.y, -g.phi};
  if (mirrored) g = {g.x, -g.y, -g.phi};
  std::optional<Word> w = family.formula(g);
  if (!w) return;
  for (std::size_t i = 0; i < w->count; ++i) {
    if (backwards) w->lengths[i] = -w->lengths[i];
    if (mirrored && w->kinds[i] != S) w->kinds[i] = w->kinds[i] == L ? R : L;
  }
  if (reversed) {
    std::reverse(w->kinds.begin(), w->kinds.begin() + static_cast<std::ptrdiff_t>(w->count));
    std::reverse(w->lengths.begin(), w->lengths.begin() + static_cast<std::ptrdiff_t>(w->count));
  }
  const double length = w->length();
  if (length < least && ends_at(*w, goal)) best = *w, least = length;
}

Word shortest(const Pose& from, const Pose& to, double radius) {
  const double dx = (to.x - from.x) / radius, dy = (to.y - from.y) / radius;
  const double c = std::cos(from.heading), s = std::sin(from.heading);
  const Target goal{c * dx + s * dy, c * dy - s * dx, to.heading - from.heading};
  Word best;
  double least = std::numeric_limits<double>::infinity();
  for (const Family& family : kFamilies)
    for (const bool backwards : {false, true})
      for (const bool mirrored : {false, true}) {
        consider(family, goal, backwards, mirrored, false, best, least);
        if (family.also_reversed) consider(family, goal, backwards, mirrored, true, best, least);
      }
  return best;
}

}  // namespace

CurvePath reeds_shepp_path(const Pose& from, const Pose& to, double radius) {
  const Word best = shortest(from, to, radius);
  std::vector<CurveSegment> segments;
  for (std::size_t i = 0; i < best.count; ++i)
    if (std::abs(best.lengths[i]) > 1e-14) segments.push_back({best.kinds[i], best.lengths[i] * radius});
  return {from, radius, std::move(segments)};
}

double detail::reeds_shepp_bound(const Pose& from, const Pose& to, double radius) {
  return std::max(0.0, radius * (shortest(from, to, radius).length() - 4 * kBoundSnap));
}

}  // namespace taut::car
