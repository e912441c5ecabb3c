#include <taut/robots/pursuit/detail/block_way.h>

#include <algorithm>
#include <cstdlib>
#include <unordered_map>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/robots/pursuit/detail/hops.h>
#include <taut/robots/pursuit/exact_planner.h>

namespace taut::pursuit::detail {

namespace {

constexpr std::size_t kMostCellsToABlock = 10'000;
constexpr std::uint64_t kWalled = std::uint64_t{1} << 48;  // more than the costs of a block

/// The map cut into blocks; cells beyond the last whole one belong to none.
class Blocks {
 public:
  Blocks(const ChaseMap& map, int side) : map_(map), side_(side) {}

  Cell block_of(CellIndex c) const {
    const Cell cell = map_.cell(c);
    return {(cell.x - 1) / side_ + 1, (cell.y - 1) / side_ + 1};
  }
  CellIndex middle_of(Cell block) const {
    return map_.index({(block.x - 1) * side_ + 1 + side_ / 2, (block.y - 1) * side_ + 1 + side_ / 2});
  }
  bool is_whole(Cell block) const { return block.x <= map_.x_size() / side_ && block.y <= map_.y_size() / side_; }
  bool is_free(Cell block) const {
    if (!is_whole(block)) return false;
    for (int x = 1; x <= side_; ++x)
      for (int y = 1; y <= side_; ++y)
        if (!map_.is_free(map_.index({(block.x - 1) * side_ + x, (block.y - 1) * side_ + y}))) return false;
    return true;
  }

  /// As cells of a map of their own; they cost what all their cells do, or the mean where that is too much.
  ChaseMap ground(Cell start, std::size_t seconds) const {
    ChaseMap::Parts parts;
    parts.x_size = map_.x_size() / side_;
    parts.y_size = map_.y_size() / side_;
    parts.start = start;
    parts.target = {start};
    parts.costs.reserve(static_cast<std::size_t>(parts.x_size) * static_cast<std::size_t>(parts.y_size));
    std::vector<std::uint64_t> sums(static_cast<std::size_t>(parts.y_size));
    const auto cells = static_cast<std::uint64_t>(side_ * side_);
    const std::uint32_t most = ChaseMap::largest_cost(seconds);
    std::uint64_t divisor = 1;
    for (const std::uint32_t cost : map_.costs())
      if (cost != ChaseMap::kObstacle && cost * cells > most) divisor = cells;
    for (int x = 0; x < parts.x_size; ++x) {
      std::fill(sums.begin(), sums.end(), 0);
      for (int i = 1; i <= side_; ++i) add_row(x * side_ + i, sums);
      for (const std::uint64_t sum : sums)
        parts.costs.push_back(sum >= kWalled ? ChaseMap::kObstacle : static_cast<std::uint32_t>(sum / divisor));
    }
    return ChaseMap(std::move(parts));
  }

 private:
  void add_row(int x, std::vector<std::uint64_t>& sums) const {
    const std::uint32_t* cost = map_.costs().data() + map_.index({x, 1});
    for (std::uint64_t& sum : sums)
      for (const std::uint32_t* const end = cost + side_; cost != end; ++cost)
        sum += *cost == ChaseMap::kObstacle ? kWalled : *cost;
  }

  const ChaseMap& map_;
  int side_;
};

/// A way of fewest moves to a cell of a free block; empty when there is none near.
std::vector<CellIndex> way_to_block(const ChaseMap& map, const Blocks& blocks, CellIndex from) {
  const auto steps = neighbour_steps(map);
  std::vector<CellIndex> seen{from};
  std::unordered_map<CellIndex, CellIndex> before{{from, from}};
  for (std::size_t i = 0; i < seen.size() && i < kMostCellsToABlock; ++i) {
    if (blocks.is_free(blocks.block_of(seen[i]))) {
      std::vector<CellIndex> way{seen[i]};
      while (way.back() != from) way.push_back(before.at(way.back()));
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const std::ptrdiff_t step : steps) {
      const auto c = static_cast<CellIndex>(static_cast<std::ptrdiff_t>(seen[i]) + step);
      if (map.is_free(c) && before.try_emplace(c, seen[i]).second) seen.push_back(c);
    }
  }
  return {};
}

/// Diagonally as long as that leads nearer in x and y. Within one block, or from middle to middle, this visits no other
/// block: the middle is the same number of cells from all edges.
void go_straight(const ChaseMap& map, std::vector<CellIndex>& way, CellIndex to) {
  const Cell end = map.cell(to);
  for (Cell at = map.cell(way.back()); at != end; way.push_back(map.index(at))) {
    at.x += (end.x > at.x) - (end.x < at.x);
    at.y += (end.y > at.y) - (end.y < at.y);
  }
}

}  // namespace

std::optional<TimedWay> way_over_blocks(const Chase& chase, int side) {
  TAUT_EXPECTS(side >= 3 && side % 2 == 1);
  const ChaseMap& map = *chase.map;
  const Blocks blocks(map, side);
  std::vector<CellIndex> way = way_to_block(map, blocks, chase.from);
  if (way.empty()) return std::nullopt;
  const Cell start = blocks.block_of(way.back());
  go_straight(map, way, blocks.middle_of(start));
  const ChaseMap ground = blocks.ground(start, map.duration() + 1);
  Chase coarse{&ground, ground.start(), 0, {}};
  std::vector<Meeting> meetings;  // that those of `coarse` stand for
  const int before = chase.now + static_cast<int>(way.size()) - 1, after = side / 2;
  for (const Meeting& m : chase.meetings) {
    const int second = (m.second - before - after) / side;
    const Cell block = blocks.block_of(m.cell);
    if (second < 1 || !blocks.is_whole(block) || !ground.is_free(ground.index(block))) continue;
    const Meeting there{ground.index(block), second};
    if (!coarse.meetings.empty() && coarse.meetings.back() == there) continue;
    coarse.meetings.push_back(there);
    meetings.push_back(m);
  }
  const ChasePlan plan = rough_plan(coarse);
  if (plan.status != SearchStatus::found) return std::nullopt;
  for (const CellIndex block : plan.cells) go_straight(map, way, blocks.middle_of(ground.cell(block)));
  const Meeting end{plan.cells.back(), static_cast<int>(plan.cells.size()) - 1};
  const auto which = std::find(coarse.meetings.begin(), coarse.meetings.end(), end) - coarse.meetings.begin();
  const Meeting& meeting = meetings[static_cast<std::size_t>(which)];
  go_straight(map, way, meeting.cell);
  return TimedWay{std::move(way), meeting.second - chase.now};
}

}  // namespace taut::pursuit::detail
