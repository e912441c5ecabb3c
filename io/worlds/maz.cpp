#include <taut/io/worlds/detail/cell_walls.h>
#include <taut/io/worlds/detail/formats.h>

namespace taut::detail {

GridMaze read_maz(std::string_view bytes, const std::string& source) {
  if (!is_maz_size(bytes.size()))
    throw InputError(source, 0, "a .maz file has 256 or 1024 bytes, not " + std::to_string(bytes.size()));
  const int size = bytes.size() == 256 ? 16 : 32;
  CellWalls cells(size, size);
  std::size_t at = 0;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y) cells.set({x, y}, static_cast<std::uint8_t>(bytes[at++]) & 15, 0);
  GridMaze maze = agreed(cells, false, source);
  if (count_openings(maze) != 2) maze.goal = centre_room(size, size);
  return maze;
}

}  // namespace taut::detail
