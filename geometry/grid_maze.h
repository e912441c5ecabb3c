// A maze of unit cells with walls on cell sides: what micromouse files, drawings and generators describe.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace taut {

class World;

/// Column x from the left, row y from the bottom, both from 0.
struct Cell {
  int x = 0;
  int y = 0;

  friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// The sides of a cell; the values are bit positions as in `.maz` files.
enum class Side : std::uint8_t { north = 0, east = 1, south = 2, west = 3 };

inline constexpr std::array<Side, 4> kSides{Side::north, Side::east, Side::south, Side::west};

/// width x height unit cells. Each wall is stored once, so two neighbours can't disagree.
/// A side of the border may be open (an opening).
class GridMaze {
 public:
  /// All walls stand (`walled`) or only the border does. 1 <= width, height <= 20000 (precondition).
  GridMaze(int width, int height, bool walled);

  int width() const { return width_; }
  int height() const { return height_; }
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_; }

  bool wall(Cell c, Side side) const { return slot(c, side) != 0; }
  void set_wall(Cell c, Side side, bool stands) { slot(c, side) = stands; }

  /// The neighbour across `side`; may lie outside.
  static Cell neighbour(Cell c, Side side);

  Cell start{0, 0};
  /// The goal room: the path ends where it enters one of these cells. Empty: no goal.
  std::vector<Cell> goal;

  friend bool operator==(const GridMaze&, const GridMaze&) = default;

 private:
  std::uint8_t& slot(Cell c, Side side) {
    return const_cast<std::uint8_t&>(static_cast<const GridMaze&>(*this).slot(c, side));
  }
  const std::uint8_t& slot(Cell c, Side side) const;

  int width_;
  int height_;
  std::vector<std::uint8_t> horizontal_;  // (height + 1) rows of width: the south side of (x, y) is y * width + x
  std::vector<std::uint8_t> vertical_;    // height rows of (width + 1): the west side of (x, y) is y * (width + 1) + x
};

/// The room in the middle: 2 cells wide in an even direction, 1 in an odd one.
std::vector<Cell> centre_room(int width, int height);

}  // namespace taut
