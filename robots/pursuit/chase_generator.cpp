#include <taut/robots/pursuit/chase_generator.h>

#include <algorithm>
#include <utility>

#include <taut/geometry/draws.h>
#include <taut/geometry/errors.h>
#include <taut/robots/pursuit/detail/building.h>
#include <taut/robots/pursuit/detail/hops.h>

namespace taut::pursuit {

namespace {

constexpr std::uint32_t kHill = 100;

int between(taut::Draws& draws, int lo, int hi) {
  return lo + static_cast<int>(draws.below(static_cast<std::uint32_t>(hi - lo + 1)));
}

void require(bool holds, const char* message) {
  if (!holds) throw InputError("", 0, message);
}

class Site {
 public:
  explicit Site(const ChaseRecipe& recipe) : recipe_(recipe), draws_(recipe.seed) {
    const auto cells = static_cast<std::size_t>(recipe.x_size) * static_cast<std::size_t>(recipe.y_size);
    parts_ = {recipe.x_size, recipe.y_size, std::vector<std::uint32_t>(cells, 1), 0, {}, {}, "1000", false, ""};
  }

  ChaseMap build() {
    if (recipe_.ground == ChaseGround::building) {
      put_up_one_building();
    } else {
      if (recipe_.costly) raise_hills();
      put_up_buildings();
    }
    parts_.start = largest_place();
    parts_.target = {parts_.start};
    const ChaseMap empty(parts_);
    close_what_is_apart(empty);
    parts_.start = free_place();
    walk(ChaseMap(parts_));
    return ChaseMap(std::move(parts_));
  }

 private:
  std::uint32_t& at(int x, int y) {
    return parts_.costs[static_cast<std::size_t>(x - 1) * static_cast<std::size_t>(recipe_.y_size) +
                        static_cast<std::size_t>(y - 1)];
  }

  void raise_hills() {
    const int side = std::min(recipe_.x_size, recipe_.y_size), count = 12;
    for (int i = 0; i < count; ++i) {
      const int cx = between(draws_, 1, recipe_.x_size), cy = between(draws_, 1, recipe_.y_size);
      const int radius = between(draws_, std::max(1, side / 16), std::max(1, side / 5));
      for (int x = std::max(1, cx - radius); x <= std::min(recipe_.x_size, cx + radius); ++x)
        for (int y = std::max(1, cy - radius); y <= std::min(recipe_.y_size, cy + radius); ++y) {
          const std::int64_t dx = x - cx, dy = y - cy, rest = std::int64_t{radius} * radius - dx * dx - dy * dy;
          if (rest > 0)
            at(x, y) =
                std::max(at(x, y), static_cast<std::uint32_t>(1 + kHill * rest / (std::int64_t{radius} * radius)));
        }
    }
  }

  void put_up_one_building() {
    const std::vector<std::uint8_t> walls = detail::building(recipe_.x_size, recipe_.y_size, draws_);
    if (recipe_.costly) {
      parts_.costs = detail::inflated(walls, recipe_.x_size, recipe_.y_size, recipe_.inflation);
      parts_.threshold = std::to_string(1 + *std::max_element(parts_.costs.begin(), parts_.costs.end()));
    }
    for (std::size_t i = 0; i < walls.size(); ++i)
      if (walls[i]) parts_.costs[i] = ChaseMap::kObstacle;
  }

  void put_up_buildings() {
    const int side = std::min(recipe_.x_size, recipe_.y_size), most = std::clamp(side / 6, 3, 120);
    auto left = static_cast<std::int64_t>(recipe_.buildings * static_cast<double>(parts_.costs.size()));
    while (left > 0) {
      const int w = std::min(between(draws_, 3, most), recipe_.x_size),
                h = std::min(between(draws_, 3, most), recipe_.y_size);
      const int x = between(draws_, 1, recipe_.x_size - w + 1), y = between(draws_, 1, recipe_.y_size - h + 1);
      put_up(x, y, w, h, draws_.below(3) == 0);
      left -= std::int64_t{w} * h;
    }
  }

  void put_up(int x0, int y0, int w, int h, bool solid) {
    for (int x = x0; x < x0 + w; ++x)
      for (int y = y0; y < y0 + h; ++y)
        if (solid || x == x0 || y == y0 || x == x0 + w - 1 || y == y0 + h - 1) at(x, y) = ChaseMap::kObstacle;
    if (solid) return;
    for (int doors = between(draws_, 1, 2); doors > 0; --doors) {
      const bool along_x = draws_.below(2) == 0, far = draws_.below(2) == 0;
      const int x = along_x ? between(draws_, x0, x0 + w - 1) : far ? x0 + w - 1 : x0;
      const int y = along_x ? (far ? y0 + h - 1 : y0) : between(draws_, y0, y0 + h - 1);
      at(x, y) = 1;
    }
  }

  Cell free_place() {
    for (;;) {
      const int x = between(draws_, 1, recipe_.x_size), y = between(draws_, 1, recipe_.y_size);
      if (at(x, y) != ChaseMap::kObstacle) return {x, y};
    }
  }

  // A cell of the largest connected part.
  Cell largest_place() {
    std::vector<std::uint8_t> seen(parts_.costs.size(), 0);
    const int columns = recipe_.y_size;
    std::size_t most = 0;
    Cell best{1, 1};
    for (std::size_t first = 0; first < parts_.costs.size(); ++first) {
      if (seen[first] || parts_.costs[first] == ChaseMap::kObstacle) continue;
      std::vector<std::size_t> part{first};
      seen[first] = 1;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const int x = static_cast<int>(part[i]) / columns, y = static_cast<int>(part[i]) % columns;
        for (int nx = std::max(0, x - 1); nx <= std::min(recipe_.x_size - 1, x + 1); ++nx)
          for (int ny = std::max(0, y - 1); ny <= std::min(columns - 1, y + 1); ++ny) {
            const auto n =
                static_cast<std::size_t>(nx) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(ny);
            if (!seen[n] && parts_.costs[n] != ChaseMap::kObstacle) seen[n] = 1, part.push_back(n);
          }
      }
      if (part.size() > most)
        most = part.size(), best = {static_cast<int>(first) / columns + 1, static_cast<int>(first) % columns + 1};
    }
    if (most == 0) at(1, 1) = 1;
    return best;
  }

  void close_what_is_apart(const ChaseMap& map) {
    const std::vector<int> near = detail::latest_departures(map, {{map.start(), 1 << 30}}, 0, 0);
    for (int x = 1; x <= recipe_.x_size; ++x)
      for (int y = 1; y <= recipe_.y_size; ++y)
        if (near[map.index({x, y})] < 0) at(x, y) = ChaseMap::kObstacle;
  }

  void walk(const ChaseMap& map) {
    const auto seconds = static_cast<std::size_t>(recipe_.seconds);
    parts_.target = {free_place()};
    while (parts_.target.size() < seconds) {
      const std::vector<CellIndex> way =
          detail::fewest_moves(map, map.index(parts_.target.back()), map.index(free_place()));
      for (std::size_t i = 1; i < way.size() && parts_.target.size() < seconds; ++i)
        parts_.target.push_back(map.cell(way[i]));
      if (way.size() <= 1) parts_.target.push_back(parts_.target.back());
    }
  }

  const ChaseRecipe& recipe_;
  taut::Draws draws_;
  ChaseMap::Parts parts_;
};

}  // namespace

ChaseMap generate_chase_map(const ChaseRecipe& recipe) {
  const auto is_side = [](int size) { return size >= 3 && size <= ChaseMap::kLongestSide; };
  require(is_side(recipe.x_size) && is_side(recipe.y_size), "a chase map's sides go from 3 to 32766");
  require(recipe.seconds >= 1 && recipe.seconds <= 16'000, "a trajectory has 1 to 16000 entries");
  require(recipe.buildings >= 0 && recipe.buildings <= 0.6, "the share of buildings goes from 0 to 0.6");
  require(recipe.inflation >= 1 && recipe.inflation <= 100, "the inflation goes from 1 to 100 cells");
  return Site(recipe).build();
}

}  // namespace taut::pursuit
