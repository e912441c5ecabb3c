// Breadth first and depth first.
#include <taut/search/grid/detail/grid_scratch.h>

namespace taut::detail {

void breadth_first(GridRun& run) {
  GridNodes& nodes = run.scratch.nodes[0];
  std::vector<BoardCell>& queue = run.scratch.queue;
  nodes.begin(run.board.size());
  nodes.set(run.start, 0, 0);
  queue.assign(1, run.start);
  std::size_t next = 0;
  run.finish(SearchStatus::none);
  for (; next < queue.size(); ++next) {
    const BoardCell c = queue[next];
    if (!run.take(c)) {
      run.finish(SearchStatus::stopped);
      break;
    }
    if (c == run.goal) {
      run.found(nodes.g(c));
      run.result.path = run.trace(nodes, c);
      ++next;
      break;
    }
    run.board.for_neighbours(c, [&](unsigned move, BoardCell n) {
      if (nodes.seen(n)) return;
      nodes.set(n, nodes.g(c) + GridBoard::cost(move), c);
      queue.push_back(n);
    });
  }
  run.result.entered = queue.size();
  run.record_frontier({queue.begin() + static_cast<std::ptrdiff_t>(next), queue.end()});
}

namespace {

// The first neighbour that is not marked yet, 0 when there is none.
BoardCell unmarked_neighbour(const GridRun& run, const GridNodes& nodes, BoardCell c, unsigned& move) {
  for (; move < 8; ++move)
    if (run.board.may(c, move) && !nodes.marked(run.board.moved(c, move))) return run.board.moved(c, move);
  return 0;
}

std::vector<BoardCell> beside_the_marked(const GridRun& run, const GridNodes& nodes) {
  std::vector<BoardCell> cells;
  for (const GridPlace p : run.result.visited)
    run.board.for_neighbours(run.board.cell(p), [&](unsigned, BoardCell n) {
      if (!nodes.marked(n)) cells.push_back(n);
    });
  return cells;
}

}  // namespace

void depth_first(GridRun& run) {
  struct Frame {
    BoardCell cell;
    unsigned next;
  };
  GridNodes& nodes = run.scratch.nodes[0];
  nodes.begin(run.board.size());
  std::vector<Frame> stack;
  const auto enter = [&](BoardCell c, std::int64_t g, BoardCell parent) {
    if (!run.take(c)) return run.finish(SearchStatus::stopped), false;
    ++run.result.entered;
    nodes.set(c, g, parent);
    nodes.mark(c);
    stack.push_back({c, 0});
    if (c != run.goal) return true;
    run.found(g);
    run.result.path = run.trace(nodes, c);
    return false;
  };
  run.finish(SearchStatus::none);
  bool on = enter(run.start, 0, 0);
  while (on && !stack.empty()) {
    const BoardCell c = stack.back().cell;
    unsigned move = stack.back().next;
    const BoardCell n = unmarked_neighbour(run, nodes, c, move);
    stack.back().next = move;
    if (n == 0)
      stack.pop_back();
    else
      on = enter(n, nodes.g(c) + GridBoard::cost(move), c);
  }
  if (run.query.record) run.record_frontier(beside_the_marked(run, nodes));
}

}  // namespace taut::detail
