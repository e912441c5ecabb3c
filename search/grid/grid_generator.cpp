#include <taut/search/grid/grid_generator.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/geometry/errors.h>

namespace taut {

namespace {

constexpr std::array<std::string_view, 3> kNames{"maze", "rooms", "random"};

std::uint8_t& cell(OccupancyGrid& grid, std::uint32_t column, std::uint32_t row) {
  return grid.blocked[std::size_t{row} * grid.width + column];
}

// Cells of even column and row are rooms, those between them walls until the tree takes them down.
void carve_maze(OccupancyGrid& grid, Draws& draws) {
  grid.blocked.assign(grid.blocked.size(), 1);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
  cell(grid, 0, 0) = 0;
  while (!stack.empty()) {
    const auto [column, row] = stack.back();
    std::array<std::pair<int, int>, 4> ways;
    std::uint32_t count = 0;
    for (const auto& [dc, dr] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      const std::int64_t c = std::int64_t{column} + 2 * dc, r = std::int64_t{row} + 2 * dr;
      if (grid.contains(c, r) && !grid.free(c, r)) ways[count++] = {dc, dr};
    }
    if (count == 0) {
      stack.pop_back();
      continue;
    }
    const auto [dc, dr] = ways[draws.below(count)];
    const auto at = [](std::uint32_t from, int by) { return static_cast<std::uint32_t>(std::int64_t{from} + by); };
    cell(grid, at(column, dc), at(row, dr)) = 0;
    cell(grid, at(column, 2 * dc), at(row, 2 * dr)) = 0;
    stack.emplace_back(at(column, 2 * dc), at(row, 2 * dr));
  }
}

constexpr std::uint32_t kRoom = 8;  // with one wall

void build_rooms(OccupancyGrid& grid, Draws& draws) {
  for (std::uint32_t row = 0; row < grid.height; ++row)
    for (std::uint32_t column = 0; column < grid.width; ++column)
      cell(grid, column, row) = column % kRoom == kRoom - 1 || row % kRoom == kRoom - 1;
  const auto door = [&](std::uint32_t column, std::uint32_t row, bool upright) {
    const std::uint32_t at = draws.below(kRoom - 1);
    const bool there = draws.below(10) != 0;
    const std::uint32_t c = column + (upright ? kRoom - 1 : at), r = row + (upright ? at : kRoom - 1);
    if (there && c < grid.width && r < grid.height) cell(grid, c, r) = 0;
  };
  for (std::uint32_t row = 0; row < grid.height; row += kRoom)
    for (std::uint32_t column = 0; column < grid.width; column += kRoom)
      for (const bool upright : {true, false}) door(column, row, upright);
}

void scatter(OccupancyGrid& grid, Draws& draws) {
  for (std::uint8_t& each : grid.blocked) each = draws.below(4) == 0;
  if (std::find(grid.blocked.begin(), grid.blocked.end(), 0) == grid.blocked.end()) grid.blocked[0] = 0;
}

}  // namespace

std::string_view name(GridKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<GridKind> grid_kind_named(std::string_view word) {
  const auto at = std::find(kNames.begin(), kNames.end(), word);
  if (at == kNames.end()) return std::nullopt;
  return static_cast<GridKind>(at - kNames.begin());
}

OccupancyGrid generate_grid(GridKind kind, std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
  if (width < 1 || height < 1 || width > 20000 || height > 20000)
    throw InputError(
        "", 0,
        "a grid of " + std::to_string(width) + " x " + std::to_string(height) + " is not of 1 to 20000 cells a side");
  OccupancyGrid grid{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 0)};
  Draws draws(seed);
  switch (kind) {
    case GridKind::maze: carve_maze(grid, draws); break;
    case GridKind::rooms: build_rooms(grid, draws); break;
    case GridKind::random: scatter(grid, draws); break;
  }
  return grid;
}

}  // namespace taut
