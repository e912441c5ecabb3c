#include <algorithm>

#include <taut/search/grid/detail/grid_estimator.h>
#include <taut/search/grid/detail/grid_scratch.h>

namespace taut::detail {

namespace {

/// A* from one end. Moves are the same in both directions, so both sides are alike.
struct GridSide {
  GridNodes& nodes;
  GridHeap& heap;
  GridEstimator h;

  void enter(BoardCell c, std::int64_t g, BoardCell parent) {
    const std::int64_t estimate = h(c);
    if (estimate >= kUnreached) return;
    nodes.set(c, g, parent);
    heap.push(g + estimate, c);
  }

  /// Drops entries that became void. False when none is left.
  bool clean() {
    while (!heap.empty() && nodes.marked(heap.top().cell)) heap.pop();
    return !heap.empty();
  }
};

class Bidirectional {
 public:
  explicit Bidirectional(GridRun& run)
      : run_(run),
        sides_{{run.scratch.nodes[0], run.scratch.heaps[0], {run.board, run.query.heuristic, run.goal}},
               {run.scratch.nodes[1], run.scratch.heaps[1], {run.board, run.query.heuristic, run.start}}} {}

  void search() {
    for (GridSide& side : sides_) {
      side.nodes.begin(run_.board.size());
      side.heap.begin(run_.query.ties);
    }
    sides_[0].enter(run_.start, 0, 0);
    sides_[1].enter(run_.goal, 0, 0);
    if (run_.start == run_.goal) met(run_.start);
    bool stopped = false;
    while (!stopped && !settled()) stopped = !step();
    conclude(stopped);
  }

 private:
  /// Nothing better than the best meeting is left, or one side is exhausted.
  bool settled() {
    if (!sides_[0].clean() || !sides_[1].clean()) return true;
    return std::max(sides_[0].heap.top().f, sides_[1].heap.top().f) >= best_;
  }

  bool step() {
    const std::size_t i = sides_[0].heap.size() <= sides_[1].heap.size() ? 0 : 1;
    GridSide& side = sides_[i];
    const GridSide& other = sides_[1 - i];
    const BoardCell c = side.heap.top().cell;
    if (!other.nodes.marked(c) && !run_.take(c)) return false;
    side.heap.pop();
    side.nodes.mark(c);
    run_.board.for_neighbours(c, [&](unsigned move, BoardCell n) {
      const std::int64_t g = side.nodes.g(c) + GridBoard::cost(move);
      if (side.nodes.marked(n) || (side.nodes.seen(n) && side.nodes.g(n) <= g)) return;
      side.enter(n, g, c);
      if (side.nodes.seen(n) && other.nodes.seen(n)) met(n);
    });
    return true;
  }

  void met(BoardCell c) {
    const std::int64_t cost = sides_[0].nodes.g(c) + sides_[1].nodes.g(c);
    if (cost >= best_) return;
    best_ = cost;
    meeting_ = c;
  }

  void conclude(bool stopped) {
    run_.finish(stopped ? SearchStatus::stopped : SearchStatus::none);
    if (!stopped && meeting_ != 0) {
      run_.found(best_);
      run_.result.path = run_.trace(sides_[0].nodes, meeting_);
      std::vector<GridPlace> rest = run_.trace(sides_[1].nodes, meeting_);
      run_.result.path.insert(run_.result.path.end(), rest.rbegin() + 1, rest.rend());
    }
    run_.result.entered = sides_[0].heap.entered() + sides_[1].heap.entered();
    if (run_.query.record) run_.record_frontier(unmarked());
  }

  std::vector<BoardCell> unmarked() {
    std::vector<BoardCell> cells;
    for (GridSide& side : sides_)
      while (!side.heap.empty())
        if (const BoardCell c = side.heap.pop(); !sides_[0].nodes.marked(c) && !sides_[1].nodes.marked(c))
          cells.push_back(c);
    return cells;
  }

  GridRun& run_;
  GridSide sides_[2];
  std::int64_t best_ = kUnreached;
  BoardCell meeting_ = 0;
};

}  // namespace

void bidirectional(GridRun& run) { Bidirectional(run).search(); }

}  // namespace taut::detail
