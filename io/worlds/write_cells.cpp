#include <cmath>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/cells_of_world.h>
#include <taut/io/worlds/movingai.h>
#include <taut/io/worlds/write_world.h>

namespace taut {

std::string write_movingai(const World& world) {
  if (world.start() || world.goal().point || !world.goal().room.empty())
    throw InputError("", 0, "movingai cannot hold start and goal in a map, only in a scenario beside it");
  return movingai_map_text(detail::cells_of(world, "movingai"));
}

std::string write_blocks(const World& world) {
  const OccupancyGrid grid = detail::cells_of(world, "blocks");
  if (!world.goal().room.empty()) throw InputError("", 0, "blocks cannot hold a goal room");
  std::vector<std::string> rows;
  for (std::uint32_t row = 0; row < grid.height; ++row) {
    rows.emplace_back();
    for (std::uint32_t column = 0; column < grid.width; ++column) rows.back() += grid.free(column, row) ? '.' : '#';
  }
  const auto mark = [&](const std::optional<Point>& p, char c) {
    if (!p) return;
    const double x = std::floor(p->x), y = std::floor(p->y);
    if (*p != Point{x + 0.5, y + 0.5} || !grid.free(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)))
      throw InputError("", 0, "blocks cannot hold an end at " + text(*p) + ", which is no middle of a free cell");
    char& cell = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
    if (cell != '.') throw InputError("", 0, "blocks cannot hold start and goal in one cell");
    cell = c;
  };
  mark(world.start(), 'S');
  mark(world.goal().point, 'G');
  std::string out;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) out.append(*row).append("\n");
  return out;
}

}  // namespace taut
