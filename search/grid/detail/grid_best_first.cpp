// Dijkstra, greedy, A* and weighted A*: one loop, ordered by g, h, g + h or g + w h.
#include <taut/search/grid/detail/grid_estimator.h>
#include <taut/search/grid/detail/grid_scratch.h>

namespace taut::detail {

namespace {

// floor(h * weight / 1000)
std::int64_t weighted(std::int64_t h, std::uint32_t weight) {
  __extension__ using Wide = __int128;
  const Wide product = Wide{h} * weight;
  return static_cast<std::int64_t>(product >= 0 ? product / 1000 : -((-product + 999) / 1000));
}

// What a search is ordered by.
class Order {
 public:
  Order(const GridRun& run)
      : algorithm_(run.query.algorithm),
        weight_(run.query.weight),
        h_(run.board, algorithm_ == GridAlgorithm::dijkstra ? GridHeuristic{} : run.query.heuristic, run.goal) {}

  /// kUnreached and more: the goal cannot be reached from c.
  std::int64_t operator()(BoardCell c, std::int64_t g) const {
    const std::int64_t h = h_(c);
    if (h >= kUnreached) return h;
    switch (algorithm_) {
      case GridAlgorithm::greedy_once:
      case GridAlgorithm::greedy: return h;
      case GridAlgorithm::weighted_astar: return g + weighted(h, weight_);
      default: return g + h;
    }
  }

 private:
  GridAlgorithm algorithm_;
  std::uint32_t weight_;
  GridEstimator h_;
};

class BestFirst {
 public:
  explicit BestFirst(GridRun& run)
      : run_(run),
        nodes_(run.scratch.nodes[0]),
        heap_(run.scratch.heaps[0]),
        order_(run),
        repeats_(run.query.algorithm == GridAlgorithm::greedy) {}

  void search() {
    nodes_.begin(run_.board.size());
    heap_.begin(run_.query.ties);
    enter(run_.start, 0, 0);
    run_.finish(SearchStatus::none);
    while (!heap_.empty() && step()) {
    }
    run_.result.entered = heap_.entered();
    if (run_.query.record) run_.record_frontier(unmarked(heap_, nodes_));
  }

 private:
  void enter(BoardCell c, std::int64_t g, BoardCell parent) {
    const bool better = !nodes_.seen(c) || g < nodes_.g(c);
    if (!better && !repeats_) return;
    const std::int64_t f = order_(c, g);
    if (f >= kUnreached) return;
    if (better) nodes_.set(c, g, parent);
    heap_.push(f, c);
  }

  /// False when the search is over.
  bool step() {
    const BoardCell c = heap_.top().cell;
    const bool again = nodes_.marked(c);
    if (again && !repeats_) return heap_.pop(), true;
    if (!run_.take(c, !again)) return run_.finish(SearchStatus::stopped), false;
    heap_.pop();
    nodes_.mark(c);
    if (c == run_.goal) {
      run_.found(nodes_.g(c));
      run_.result.path = run_.trace(nodes_, c);
      return false;
    }
    run_.board.for_neighbours(c, [&](unsigned move, BoardCell n) {
      if (!nodes_.marked(n)) enter(n, nodes_.g(c) + GridBoard::cost(move), c);
    });
    return true;
  }

  GridRun& run_;
  GridNodes& nodes_;
  GridHeap& heap_;
  Order order_;
  bool repeats_;
};

}  // namespace

void best_first(GridRun& run) { BestFirst(run).search(); }

}  // namespace taut::detail
