#include <taut/robots/micromouse/detail/look_tour.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <taut/robots/micromouse/detail/boards.h>
#include <taut/robots/micromouse/detail/look_ways.h>

namespace taut::micromouse::detail {

namespace {

class TourSearch {
 public:
  TourSearch(const WallMap& map, const WallBoard& open, const TourTuning& tuning)
      : map_(map), open_(open), tuning_(tuning) {}

  std::optional<Tour> best(std::size_t root, const WallBoard& weights) const {
    std::vector<Partial> beam{{root, 0, 0, 0, {}, weights}};
    std::optional<Tour> best;
    while (!beam.empty() && beam.front().looks < tuning_.looks) {
      std::vector<Partial> longer;
      for (const Partial& tour : beam) extend(tour, longer);
      std::ranges::stable_sort(longer, std::greater<>{}, &Partial::value);
      if (longer.size() > kept()) longer.resize(kept());
      for (const Partial& t : longer)
        if (!best || t.value > best->value) best = Tour{t.way, t.value, t.looks};
      beam = std::move(longer);
    }
    return best;
  }

 private:
  struct Partial {
    std::size_t node = 0;
    int looks = 0;
    int steps = 0;
    double value = 0;
    std::vector<Action> way;  // to the first look
    WallBoard left;           // weights not yet seen
  };

  std::size_t kept() const { return static_cast<std::size_t>(tuning_.beam); }
  double discount(int steps) const { return std::pow(tuning_.discount, steps); }

  void extend(const Partial& tour, std::vector<Partial>& into) const {
    const Outlook outlook(map_, tour.left, open_);
    const LookWays ways = look_ways(map_, tour.node, outlook, tuning_.side_looks);
    std::vector<std::pair<double, std::size_t>> looks;
    for (const std::size_t node : ways.order)
      if (node != tour.node && outlook.at(node / 4, static_cast<Side>(node % 4)) > 0)
        looks.emplace_back(
            tour.value + static_cast<double>(ways.collected[node]) * discount(tour.steps + ways.steps[node]), node);
    const auto end = looks.begin() + static_cast<std::ptrdiff_t>(std::min(looks.size(), kept()));
    std::partial_sort(looks.begin(), end, looks.end(), std::greater<>{});
    for (auto look = looks.begin(); look != end; ++look) into.push_back(after(tour, ways, look->second));
  }

  Partial after(const Partial& tour, const LookWays& ways, std::size_t look) const {
    Partial next = tour;
    next.node = look;
    if (++next.looks == 1) next.way = ways.way_to(look);
    std::vector<std::size_t> nodes;
    for (std::size_t node = look; node != tour.node; node = ways.from[node]) nodes.push_back(node);
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      double seen = 0;
      for (const int by : {-1, 0, 1})
        seen += see(cell_of(map_.width(), *node / 4), turned(static_cast<Side>(*node % 4), by), next.left);
      next.value += seen * discount(++next.steps);
    }
    return next;
  }

  /// The weight that shows in one direction, taken out of what is left.
  double see(Cell c, Side side, WallBoard& weights) const {
    constexpr float kHardly = 1e-3F;
    double seen = 0;
    for (float chance = 1; chance > kHardly && map_.state(c, side) != WallState::closed; c = ahead(c, side)) {
      if (map_.state(c, side) == WallState::open) continue;
      const CellSide wall = canonical({c, side});
      const std::size_t i = index_of(map_.width(), wall.cell);
      float& left = (wall.side == Side::north ? weights.north : weights.east)[i];
      seen += static_cast<double>(left * chance);
      left *= 1 - chance;
      chance *= (wall.side == Side::north ? open_.north : open_.east)[i];
    }
    return seen;
  }

  const WallMap& map_;
  const WallBoard& open_;
  const TourTuning& tuning_;
};

}  // namespace

std::optional<Tour> best_tour(const WallMap& map, const MousePose& from, const WallBoard& weights,
                              const WallBoard& open, const TourTuning& tuning) {
  return TourSearch(map, open, tuning).best(node_of(map, from), weights);
}

}  // namespace taut::micromouse::detail
