#include <taut/search/grid/detail/grid_scratch.h>

#include <algorithm>

namespace taut::detail {

std::vector<GridPlace> GridRun::trace(const GridNodes& nodes, BoardCell c) const {
  std::vector<GridPlace> path;
  for (; c != 0; c = nodes.parent(c)) path.push_back(board.place(c));
  std::reverse(path.begin(), path.end());
  return path;
}

void GridRun::record_frontier(std::vector<BoardCell> cells) {
  if (!query.record) return;
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  for (const BoardCell c : cells) result.frontier.push_back(board.place(c));
}

std::vector<BoardCell> unmarked(GridHeap& heap, const GridNodes& nodes) {
  std::vector<BoardCell> cells;
  while (!heap.empty())
    if (const BoardCell c = heap.pop(); !nodes.marked(c)) cells.push_back(c);
  return cells;
}

}  // namespace taut::detail
