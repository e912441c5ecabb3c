// The half-cell lattice of speed runs, and the smooth turns on it. Private.
#pragma once

#include <array>
#include <vector>

#include <taut/robots/micromouse/speed_run.h>

namespace taut::micromouse::detail {

inline constexpr std::array<int, 8> kDx{0, 1, 1, 1, 0, -1, -1, -1};
inline constexpr std::array<int, 8> kDy{1, 1, 0, -1, -1, -1, 0, 1};

constexpr Eighth turned_by(Eighth heading, int eighths) { return static_cast<Eighth>((heading + eighths) & 7); }
constexpr bool is_diagonal(Eighth heading) { return (heading & 1) != 0; }
constexpr bool is_middle_of_cell(Spot s) { return (s.x & 1) != 0 && (s.y & 1) != 0; }
constexpr Spot ahead_of(Spot s, Eighth heading, int count = 1) {
  return {s.x + count * kDx[heading], s.y + count * kDy[heading]};
}
constexpr Spot middle_of(Cell c) { return {2 * c.x + 1, 2 * c.y + 1}; }
constexpr Cell cell_at(Spot s) { return {(s.x - 1) / 2, (s.y - 1) / 2}; }

/// A turn as it is driven with one heading to one side.
struct TurnShape {
  Turn turn{};
  Eighth heading{};
  Eighth after{};
  bool from_wall = false;
  std::vector<Spot> way;  // from the begin, which is (0, 0), to the end: walls in between
};

/// All of them, by the heading with which they begin.
std::vector<std::vector<TurnShape>> turn_shapes();

/// Does the turn begin at such a place? A diagonal one has to cross the wall ahead, not to bounce off it.
bool fits(const TurnShape& shape, Spot at);

/// Is it inside, and no wall there?
bool is_open(const GridMaze& maze, Spot at);

/// The border's openings count as closed.
GridMaze with_closed_border(GridMaze maze);

}  // namespace taut::micromouse::detail
