#include <taut/search/detail/changing_cells.h>

#include <algorithm>
#include <span>

namespace taut::detail {

namespace {
constexpr std::size_t kMostCells = std::size_t{1} << 24;
}

/// Where lines are there already it may be as large as it is.
bool ChangingCells::has_room_for(const Segment& stretch) const {
  const CellPlan& plan = mesh_.plan();
  const auto is_new = [](const std::array<std::int32_t, 2>& at) { return std::size_t{at[0] == at[1]}; };
  const std::size_t columns = is_new(plan.columns_at(stretch.a.x)) + is_new(plan.columns_at(stretch.b.x)),
                    rows = is_new(plan.rows_at(stretch.a.y)) + is_new(plan.rows_at(stretch.b.y));
  return columns + rows == 0 || (plan.columns() + columns) * (plan.rows() + rows) <= kMostCells;
}

bool ChangingCells::change(const Segment& stretch, const std::vector<const WallShelf*>& walls) {
  if (!has_room_for(stretch)) return false;
  mesh_.change(stretch, [&](const Segment& side) {
    return std::any_of(walls.begin(), walls.end(), [&](const WallShelf* shelf) { return shelf->holds(side); });
  });
  return true;
}

SearchStatus ChangingCells::find(Point from, Point to, std::vector<Point>& points) {
  mesh_.mesh();
  engine_.renew();
  mesh_.around(from, starts_);
  goal_.point = to;
  mesh_.around(to, goal_.polygons);
  const SearchStatus status =
      engine_.run({from, starts_, std::span(&goal_, 1), true, false, {}}, [](Point, std::uint32_t) {});
  points.clear();
  if (engine_.way().exists()) engine_.points(engine_.way(), points);
  return status;
}

}  // namespace taut::detail
