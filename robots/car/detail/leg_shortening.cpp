#include <taut/robots/car/detail/leg_shortening.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace taut::car::detail {

namespace {

constexpr int kPasses = 4;
constexpr double kWorthIt = 1e-6;  // of a run's length: less is not tried for
constexpr std::array<std::size_t, 10> kRuns{48, 32, 24, 16, 12, 8, 6, 4, 3, 2};

struct Run {
  std::vector<Leg> legs;
  double length = 0;
};

class Shortening {
 public:
  explicit Shortening(const CarSpace& space) : space_(space) {}

  /// One pass; true when something got shorter.
  bool pass(std::vector<Leg>& legs) {
    std::vector<Leg> out;
    bool shorter = false;
    for (std::size_t i = 0; i < legs.size();) {
      const auto [taken, run] = best_from(legs, i);
      shorter = shorter || !run.empty();
      if (run.empty())
        out.push_back(legs[i]);
      else
        out.insert(out.end(), run.begin(), run.end());
      i += taken;
    }
    legs = std::move(out);
    return shorter;
  }

 private:
  /// How many legs from i on are replaced by which.
  std::pair<std::size_t, std::vector<Leg>> best_from(const std::vector<Leg>& legs, std::size_t i) const {
    std::size_t same = 0;
    while (i + same < legs.size() && legs[i + same].backward == legs[i].backward) ++same;
    for (const std::size_t count : kRuns) {
      if (count > same) continue;
      double length = 0;
      for (std::size_t k = i; k < i + count; ++k) length += curve_of(legs[k]).length();
      if (auto run = replacement(legs[i].from, legs[i + count - 1].to, legs[i].backward, length); !run.empty())
        return {count, std::move(run)};
    }
    return {1, {}};
  }

  /// Shorter than `length` by what is worth it; empty when there is none.
  std::vector<Leg> replacement(const LatticePose& from, const LatticePose& to, bool backward, double length) const {
    const double dx = to.at.x - from.at.x, dy = to.at.y - from.at.y;
    const double most = length * (1 - kWorthIt);
    if (std::hypot(dx, dy) >= most) return {};
    std::vector<Run> runs;
    add({{from, to, backward}}, most, runs);
    const double way = std::atan2(backward ? -dy : dy, backward ? -dx : dx);
    const Point middle{from.at.x + dx / 2, from.at.y + dy / 2};
    const int nearest = nearest_heading(way);
    for (const int by : {-1, 0, 1}) {
      const LatticePose between{middle, (nearest + by + kHeadings) % kHeadings};
      if (between.heading != from.heading && between.heading != to.heading)
        add({{from, between, backward}, {between, to, backward}}, most, runs);
    }
    std::ranges::sort(runs, {}, &Run::length);
    for (const Run& run : runs)
      if (std::ranges::all_of(run.legs, [&](const Leg& leg) { return space_.is_clear(leg); })) return run.legs;
    return {};
  }

  void add(std::vector<Leg> legs, double most, std::vector<Run>& runs) const {
    double length = 0;
    for (const Leg& leg : legs) {
      if (validate(leg, space_.shape())) return;
      length += curve_of(leg).length();
    }
    if (length < most) runs.push_back({std::move(legs), length});
  }

  const CarSpace& space_;
};

}  // namespace

std::vector<Leg> shortened(const CarSpace& space, std::vector<Leg> legs) {
  Shortening shortening(space);
  for (int pass = 0; pass < kPasses && shortening.pass(legs); ++pass) {
  }
  return legs;
}

}  // namespace taut::car::detail
