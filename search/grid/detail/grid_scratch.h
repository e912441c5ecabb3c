// What grid searches write on: a node a cell, never cleared, and a heap.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <taut/search/grid/detail/grid_board.h>
#include <taut/search/grid/grid_search.h>

namespace taut::detail {

struct GridNode {
  std::int64_t g = 0;
  BoardCell parent = 0;
  std::uint32_t stamp = 0;  ///< twice the generation: seen; one more: marked
};

/// The nodes of one search. begin() forgets all of them in O(1).
class GridNodes {
 public:
  void begin(std::size_t size) {
    if (nodes_.size() != size || generation_ >= 0xffff'fffc) {
      nodes_.assign(size, {});
      generation_ = 0;
    }
    generation_ += 2;
  }
  bool seen(BoardCell c) const { return nodes_[c].stamp >= generation_; }
  bool marked(BoardCell c) const { return nodes_[c].stamp > generation_; }
  void mark(BoardCell c) { nodes_[c].stamp = generation_ + 1; }
  std::int64_t g(BoardCell c) const { return nodes_[c].g; }
  BoardCell parent(BoardCell c) const { return nodes_[c].parent; }
  void set(BoardCell c, std::int64_t g, BoardCell parent) { nodes_[c] = {g, parent, generation_}; }

 private:
  std::vector<GridNode> nodes_;
  std::uint32_t generation_ = 0;
};

/// Entries by f, equal ones first in first out or last in first out. Entries that became void stay until they come out.
class GridHeap {
 public:
  struct Entry {
    std::int64_t f;
    std::int64_t rank;
    BoardCell cell;
  };

  void begin(Ties ties) {
    entries_.clear();
    entered_ = 0;
    sign_ = ties == Ties::fifo ? 1 : -1;
  }
  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  std::size_t entered() const { return entered_; }
  const Entry& top() const { return entries_.front(); }
  void push(std::int64_t f, BoardCell c) {
    entries_.push_back({f, sign_ * static_cast<std::int64_t>(++entered_), c});
    std::push_heap(entries_.begin(), entries_.end(), later);
  }
  BoardCell pop() {
    std::pop_heap(entries_.begin(), entries_.end(), later);
    const BoardCell c = entries_.back().cell;
    entries_.pop_back();
    return c;
  }

 private:
  static bool later(const Entry& a, const Entry& b) { return a.f != b.f ? a.f > b.f : a.rank > b.rank; }

  std::vector<Entry> entries_;
  std::size_t entered_ = 0;
  std::int64_t sign_ = 1;
};

/// What is left in the heap and not yet taken; empties it.
std::vector<BoardCell> unmarked(GridHeap& heap, const GridNodes& nodes);

struct GridScratch {
  GridNodes nodes[2];
  GridHeap heaps[2];
  std::vector<BoardCell> queue;
  std::vector<std::uint8_t> arrived;  ///< of jps: the move a jump point was reached by
};

/// One search under way: its ends, its counts, and what becomes of them.
class GridRun {
 public:
  GridRun(const GridBoard& on, GridScratch& with, const GridQuery& asked, BoardCell from, BoardCell to)
      : board(on), scratch(with), query(asked), start(from), goal(to) {}

  /// Counts a taking; false when there are no steps left.
  bool take(BoardCell c, bool first = true) {
    if (result.steps >= query.max_steps) return false;
    ++result.steps;
    if (query.record && first) result.visited.push_back(board.place(c));
    return true;
  }

  void finish(SearchStatus status) { result.status = status; }
  /// Found: the path along the parents of `side`, from its root to c.
  std::vector<GridPlace> trace(const GridNodes& nodes, BoardCell c) const;
  void found(std::int64_t g) {
    finish(SearchStatus::found);
    result.cost = GridCost::of_key(g);
  }
  void record_frontier(std::vector<BoardCell> cells);

  const GridBoard& board;
  GridScratch& scratch;
  const GridQuery& query;
  BoardCell start;
  BoardCell goal;
  GridResult result;
};

void breadth_first(GridRun& run);
void depth_first(GridRun& run);
void best_first(GridRun& run);
void bidirectional(GridRun& run);
void iterative_deepening(GridRun& run);
void jump_points(GridRun& run);

}  // namespace taut::detail
