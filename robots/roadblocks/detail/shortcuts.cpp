#include <taut/robots/roadblocks/detail/shortcuts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <taut/robots/car/curve_bound.h>
#include <taut/robots/roadblocks/detail/replay.h>

namespace taut::roadblocks::detail {

namespace {

using Vector = std::array<double, 3>;

constexpr double kSame = 1e-11;     // two poses, when their differences are below it
constexpr double kRounding = 1e-9;  // of a step, in a bound
constexpr int kIterations = 7;      // of Newton's method
constexpr double kAstray = 2;       // a control beyond it will not come back to 1
constexpr std::size_t kLeast = 8;   // steps of a stretch
constexpr double kShrink = 0.85;    // a stretch's length from one round to the next
constexpr int kRounds = 8;
constexpr int kCoarse = 6;                                          // steps between the first looks
constexpr std::array<double, 5> kSides{0, 0.5, -0.5, 0.95, -0.95};  // where the goal comes to lie across the car
constexpr std::array<std::array<double, 2>, 9> kSplits{
    {{1 / 3.0, 1 / 3.0}, {0.2, 0.6}, {0.15, 0.35}, {0.5, 0.35}, {.1, .8}, {.1, .1}, {.8, .1}, {.1, .5}, {.4, .5}}};

double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Solves a x = b by Cramer's rule; nothing when it is (nearly) singular.
std::optional<Vector> solved(const std::array<Vector, 3>& a, const Vector& b) {
  const std::array<Vector, 3> minors{cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])};
  const double volume = product(a[0], minors[0]);
  if (std::abs(volume) < 1e-12) return std::nullopt;
  Vector x{};
  for (std::size_t k = 0; k < 3; ++k) x[k] = (b[0] * minors[0][k] + b[1] * minors[1][k] + b[2] * minors[2][k]) / volume;
  return x;
}

/// A value with its slopes in the three controls.
struct Varying {
  double value = 0;
  Vector slope{};
};

struct VaryingPose {
  Varying x, y, heading;
};

/// So many steps on.
Pose after(const Pose& from, double control, int steps) {
  const double turn = kTurn * control * steps, half = turn / 2;
  const double chord = kForward * steps * (std::abs(half) < 1e-4 ? 1 - half * half / 6 : std::sin(half) / half);
  return {from.x + chord * std::cos(from.heading + half), from.y + chord * std::sin(from.heading + half),
          from.heading + turn};
}

/// Three arcs from a pose, some steps each.
struct Stretch {
  Stretch(const Pose& pose, const std::array<int, 3>& numbers)
      : from(pose), steps(numbers), ahead{std::cos(pose.heading), std::sin(pose.heading)} {}

  Pose from;
  std::array<int, 3> steps;
  Point ahead;

  /// Where controls lead: what stepped() gives, in one go.
  VaryingPose end(const Vector& u) const {
    Pose at = from;
    Point way = ahead;
    VaryingPose end;
    std::array<Point, 3> after;  // each arc
    std::array<Point, 3> bent;   // slope of the arc's own chord in its turn
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = kForward * steps[k], half = kTurn * u[k] * steps[k] / 2;
      const bool straight = std::abs(half) < 1e-4;
      const double sine = std::sin(half), cosine = std::cos(half);
      const double share = straight ? 1 - half * half / 6 : sine / half;
      const double share_slope = straight ? -half / 3 : (cosine - share) / half;
      way = {cosine * way.x - sine * way.y, sine * way.x + cosine * way.y};  // in the arc's middle
      const double c = length * way.x, s = length * way.y;
      way = {cosine * way.x - sine * way.y, sine * way.x + cosine * way.y};
      bent[k] = {(share_slope * c - share * s) / 2, (share_slope * s + share * c) / 2};
      at = {at.x + share * c, at.y + share * s, at.heading + 2 * half};
      after[k] = {at.x, at.y};
    }
    end.x.value = at.x, end.y.value = at.y, end.heading.value = at.heading;
    for (std::size_t k = 0; k < 3; ++k) {
      const double turn = kTurn * steps[k];  // the rest turns around the arc's end
      end.x.slope[k] = turn * (bent[k].x - (at.y - after[k].y));
      end.y.slope[k] = turn * (bent[k].y + (at.x - after[k].x));
      end.heading.slope[k] = turn;
    }
    return end;
  }
};

/// Controls for which `miss`, three Varyings, vanishes, all in [-1, 1].
template <typename Miss>
std::optional<Vector> controls_for(Miss miss, Vector u) {
  for (int i = 0; i < kIterations; ++i) {
    const std::array<Varying, 3> now = miss(u);
    if (std::max({std::abs(now[0].value), std::abs(now[1].value), std::abs(now[2].value)}) < kSame) {
      const bool allowed = std::ranges::all_of(u, [](double c) { return c >= -1 && c <= 1; });
      return allowed ? std::optional(u) : std::nullopt;
    }
    const std::optional<Vector> step =
        solved({now[0].slope, now[1].slope, now[2].slope}, {now[0].value, now[1].value, now[2].value});
    if (!step) return std::nullopt;
    u = {u[0] - (*step)[0], u[1] - (*step)[1], u[2] - (*step)[2]};
    if (std::ranges::any_of(u, [](double c) { return !(std::abs(c) < kAstray); })) return std::nullopt;
  }
  return std::nullopt;
}

class Shortcuts {
 public:
  Shortcuts(const Pose& from, const DrivePlan& plan, const Obstacles& obstacles, double slack)
      : from_(from), plan_(plan), obstacles_(obstacles), slack_(slack), changed_(plan.controls.size()) {}

  DrivePlan run() {
    for (round_ = 0; round_ < kRounds; ++round_) {
      const std::size_t before = plan_.controls.size();
      for (auto length = static_cast<double>(before); length >= kLeast; length *= kShrink)
        pass(static_cast<std::size_t>(length));
      if (plan_.controls.size() == before) break;
    }
    return plan_;
  }

 private:
  void pass(std::size_t length) {
    for (std::size_t i = 0; i + length <= plan_.controls.size(); i += std::max<std::size_t>(1, length / 3))
      while (i + length <= plan_.controls.size() && shortened(i, i + length)) {
      }
    while (plan_.controls.size() >= length && end_shortened(plan_.controls.size() - length)) {
    }
  }

  const Pose& before(std::size_t i) const { return i == 0 ? from_ : plan_.poses[i - 1]; }

  /// Straight, or bent all the way: nothing is shorter.
  bool is_one_arc(std::size_t i, std::size_t j) const {
    const double u = plan_.controls[i];
    return u != kReverse &&
           std::all_of(plan_.controls.begin() + static_cast<std::ptrdiff_t>(i),
                       plan_.controls.begin() + static_cast<std::ptrdiff_t>(j), [u](double c) { return c == u; });
  }

  /// Has anything changed since the last round but one?
  bool is_new(std::size_t i, std::size_t j) const {
    return std::any_of(changed_.begin() + static_cast<std::ptrdiff_t>(i),
                       changed_.begin() + static_cast<std::ptrdiff_t>(j),
                       [&](int round) { return round + 1 >= round_; });
  }

  static double nearest_turn(double angle) { return std::remainder(angle, 2 * std::acos(-1.0)); }

  bool shortened(std::size_t i, std::size_t j) {
    if (is_one_arc(i, j) || !is_new(i, j)) return false;
    const Pose target = plan_.poses[j - 1];
    const auto least = static_cast<int>(
        std::ceil(car::detail::dubins_bound(before(i), target, kForward / kTurn) / kForward - kRounding));
    const int steps = static_cast<int>(j - i);
    const auto miss = [&](VaryingPose end, const Vector&) {
      end.x.value -= target.x, end.y.value -= target.y;
      end.heading.value = nearest_turn(end.heading.value - target.heading);
      return std::array<Varying, 3>{end.x, end.y, end.heading};
    };
    // What cannot be shortened by one step cannot by more.
    int saved = 0;
    for (int more = 1; steps - saved - more >= std::max(least, 3); more *= 2) {
      if (!replaced(i, j - static_cast<std::size_t>(saved), steps - saved - more, miss)) break;
      saved += more;
    }
    return saved > 0;
  }

  bool end_shortened(std::size_t i) {
    if (!is_new(i, plan_.controls.size())) return false;
    const Point goal = obstacles_.course().goal;
    const int steps = static_cast<int>(plan_.controls.size() - i) - 1;
    for (const double side : kSides)
      if (steps >= 3 && replaced(i, plan_.controls.size(), steps, [&](const VaryingPose& end, const Vector& u) {
            return miss_of_goal(end, goal, side, u);
          }))
        return true;
    return false;
  }

  /// The goal at the car's front, `side` across; the last two arcs are one.
  static std::array<Varying, 3> miss_of_goal(const VaryingPose& end, Point goal, double side, const Vector& u) {
    const double c = std::cos(end.heading.value), s = std::sin(end.heading.value);
    const double dx = goal.x - end.x.value, dy = goal.y - end.y.value, along = c * dx + s * dy,
                 across = c * dy - s * dx;
    std::array<Varying, 3> miss{{{along - kHalfLength + 2 * kMargin}, {across - side}, {u[1] - u[2], {0, 1, -1}}}};
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = end.x.slope[k], y = end.y.slope[k], h = end.heading.slope[k];
      miss[0].slope[k] = across * h - c * x - s * y;
      miss[1].slope[k] = s * x - c * y - along * h;
    }
    return miss;
  }

  template <typename Miss>
  bool replaced(std::size_t i, std::size_t j, int steps, Miss miss) {
    for (const auto& [first, second] : kSplits) {
      const int a = std::max(1, static_cast<int>(first * steps)), b = std::max(1, static_cast<int>(second * steps));
      if (steps - a - b < 1) continue;
      const Stretch stretch(before(i), {a, b, steps - a - b});
      const auto found =
          controls_for([&](const Vector& u) { return miss(stretch.end(u), u); }, guess(i, j, stretch.steps));
      if (found && put(i, j, stretch, *found)) return true;
    }
    return false;
  }

  Vector guess(std::size_t i, std::size_t j, const std::array<int, 3>& steps) const {
    Vector u{};
    const double scale = static_cast<double>(j - i) / (steps[0] + steps[1] + steps[2]);
    double at = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto begin = i + static_cast<std::size_t>(at);
      at += steps[k] * scale;
      const auto end = std::min(j, i + static_cast<std::size_t>(at));
      for (std::size_t c = begin; c < end; ++c) u[k] += std::max(plan_.controls[c], -1.0);
      u[k] = std::clamp(u[k] / std::max<double>(1, static_cast<double>(end - begin)), -1.0, 1.0);
    }
    return u;
  }

  /// Every few steps: most stretches that collide do so for longer.
  bool may_be_clear(const Stretch& stretch, const Vector& u) const {
    Pose at = stretch.from;
    for (std::size_t k = 0; k < 3; ++k) {
      for (int steps = kCoarse; steps < stretch.steps[k]; steps += kCoarse)
        if (!obstacles_.is_free(after(at, u[k], steps), slack_)) return false;
      at = after(at, u[k], stretch.steps[k]);
      if (!obstacles_.is_free(at, slack_)) return false;
    }
    return true;
  }

  /// Takes the stretch when it and what follows is clear.
  bool put(std::size_t i, std::size_t j, const Stretch& stretch, const Vector& u) {
    if (!may_be_clear(stretch, u)) return false;
    std::vector<double> controls;
    for (std::size_t k = 0; k < 3; ++k)
      controls.insert(controls.end(), static_cast<std::size_t>(stretch.steps[k]), u[k]);
    Pose pose = stretch.from;
    for (const double control : controls) {
      const Pose to = stepped(pose, control);
      if (!obstacles_.is_clear(pose, control, to, slack_)) return false;
      pose = to;
    }
    const std::size_t end = i + controls.size();
    controls.insert(controls.begin(), plan_.controls.begin(), plan_.controls.begin() + static_cast<std::ptrdiff_t>(i));
    controls.insert(controls.end(), plan_.controls.begin() + static_cast<std::ptrdiff_t>(j), plan_.controls.end());
    std::optional<DrivePlan> plan = replayed(from_, controls, obstacles_, slack_);
    if (!plan || plan->controls.size() >= plan_.controls.size()) return false;
    plan_ = std::move(*plan);
    const auto at = changed_.begin() + static_cast<std::ptrdiff_t>(i);
    changed_.insert(changed_.erase(at, at + static_cast<std::ptrdiff_t>(j - i)), end - i, round_);
    changed_.resize(plan_.controls.size(), round_);  // the goal may come sooner
    return true;
  }

  Pose from_;
  DrivePlan plan_;
  const Obstacles& obstacles_;
  double slack_;
  std::vector<int> changed_;  ///< in which round, a control each
  int round_ = 0;
};

}  // namespace

DrivePlan with_shortcuts(const Pose& from, const DrivePlan& plan, const Obstacles& obstacles, double slack) {
  return Shortcuts(from, plan, obstacles, slack).run();
}

}  // namespace taut::roadblocks::detail
