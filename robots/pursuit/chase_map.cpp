#include <taut/robots/pursuit/chase_map.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>

namespace taut::pursuit {

namespace {

bool is_on(const ChaseMap::Parts& parts, Cell c) {
  return c.x >= 1 && c.y >= 1 && c.x <= parts.x_size && c.y <= parts.y_size;
}

void require(bool holds, const std::string& source, const std::string& message) {
  if (!holds) throw InputError(source, 0, message);
}

std::string size_text(const ChaseMap::Parts& parts) {
  return std::to_string(parts.x_size) + " x " + std::to_string(parts.y_size);
}

void require_sizes(const ChaseMap::Parts& parts) {
  const auto is_side = [](int size) { return size >= 1 && size <= ChaseMap::kLongestSide; };
  require(is_side(parts.x_size) && is_side(parts.y_size), parts.source,
          "a map of " + size_text(parts) + " cells; sides go from 1 to " + std::to_string(ChaseMap::kLongestSide));
  require(parts.costs.size() == static_cast<std::size_t>(parts.x_size) * static_cast<std::size_t>(parts.y_size),
          parts.source, std::to_string(parts.costs.size()) + " costs for a map of " + size_text(parts));
  require(!parts.target.empty(), parts.source, "the target's trajectory has no entries");
  require(parts.target.size() <= 1'000'000, parts.source, "the target's trajectory has more than 1000000 entries");
}

/// In place, from the last row to the first: large maps are read into memory that is already wide enough.
void add_border(std::vector<std::uint32_t>& costs, std::size_t rows, std::size_t columns) {
  const std::size_t stride = columns + 2;
  costs.resize((rows + 2) * stride, ChaseMap::kObstacle);
  const auto at = [&](std::size_t i) { return costs.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t x = rows; x-- > 0;) {
    std::move_backward(at(x * columns), at((x + 1) * columns), at((x + 1) * stride + 1 + columns));
    std::fill_n(at((x + 1) * stride + 1 + columns), 2, ChaseMap::kObstacle);  // the next row's first, too
  }
  std::fill_n(costs.begin(), stride + 1, ChaseMap::kObstacle);
}

}  // namespace

std::uint32_t ChaseMap::largest_cost(std::size_t entries) {
  const int bits = 62 - 2 * static_cast<int>(std::bit_width(entries));
  return bits >= 32 ? kObstacle - 1 : bits <= 0 ? 0 : (std::uint32_t{1} << bits) - 1;
}

ChaseMap::ChaseMap(Parts parts)
    : x_size_(parts.x_size),
      y_size_(parts.y_size),
      decimals_(parts.decimals),
      rounded_(parts.rounded),
      threshold_(std::move(parts.threshold)),
      source_(std::move(parts.source)) {
  parts.source = source_;
  require_sizes(parts);
  const std::uint32_t limit = largest_cost(parts.target.size());
  std::uint32_t dearest = 0;
  for (const std::uint32_t cost : parts.costs) dearest = std::max(dearest, cost + 1);  // obstacles become 0
  require(dearest <= limit + 1, source_, "a cost is too large to add up exactly");
  costs_ = std::move(parts.costs);
  add_border(costs_, static_cast<std::size_t>(x_size_), static_cast<std::size_t>(y_size_));
  require(is_on(parts, parts.start), source_,
          "the robot starts at " + text(parts.start) + ", outside the map of " + size_text(parts));
  start_ = index(parts.start);
  require(is_free(start_), source_, "the robot starts at " + text(parts.start) + ", inside an obstacle");
  target_.reserve(parts.target.size());
  for (std::size_t i = 0; i < parts.target.size(); ++i) {
    require(is_on(parts, parts.target[i]), source_,
            "entry " + std::to_string(i + 1) + " of the trajectory, " + text(parts.target[i]) +
                ", is outside the map of " + size_text(parts));
    target_.push_back(index(parts.target[i]));
  }
}

ChaseMap ChaseMap::without_trajectory() const {
  ChaseMap ground = *this;
  ground.target_ = {start_};
  return ground;
}

std::string ChaseMap::cost_text(Cost units) const {
  std::string digits = std::to_string(units);
  if (decimals_ <= 0) return units == 0 ? digits : digits + std::string(static_cast<std::size_t>(-decimals_), '0');
  const auto places = static_cast<std::size_t>(decimals_);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  digits.insert(digits.size() - places, ".");
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.ends_with('.')) digits.pop_back();
  return digits;
}

double ChaseMap::cost_value(Cost units) const {
  return static_cast<double>(static_cast<long double>(units) / std::pow(10.0L, static_cast<long double>(decimals_)));
}

std::string chase_map_text(const ChaseMap& map) {
  const auto pair = [](Cell c) { return std::to_string(c.x) + "," + std::to_string(c.y) + "\n"; };
  std::uint32_t dearest = 0;
  for (const std::uint32_t cost : map.costs())
    if (cost != ChaseMap::kObstacle) dearest = std::max(dearest, cost);
  const std::string obstacle = map.threshold().empty() ? map.cost_text(Cost{dearest} + 1) : map.threshold();
  std::string out =
      "N\n" + pair({map.x_size(), map.y_size()}) + "C\n" + obstacle + "\nR\n" + pair(map.cell(map.start())) + "T\n";
  for (const CellIndex entry : map.target()) out += pair(map.cell(entry));
  out += "M\n";
  for (int x = 1; x <= map.x_size(); ++x)
    for (int y = 1; y <= map.y_size(); ++y) {
      const std::uint32_t cost = map.cost(map.index({x, y}));
      out += cost == ChaseMap::kObstacle ? obstacle : map.cost_text(cost);
      out += y < map.y_size() ? ',' : '\n';
    }
  return out;
}

}  // namespace taut::pursuit
