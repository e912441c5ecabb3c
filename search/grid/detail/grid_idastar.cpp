#include <algorithm>

#include <taut/search/grid/detail/grid_estimator.h>
#include <taut/search/grid/detail/grid_scratch.h>

namespace taut::detail {

namespace {

class IterativeDeepening {
 public:
  explicit IterativeDeepening(GridRun& run)
      : run_(run),
        nodes_(run.scratch.nodes[0]),
        ever_(run.scratch.nodes[1]),
        h_(run.board, run.query.heuristic, run.goal) {}

  void search() {
    run_.result.rounds = 0;
    ever_.begin(run_.board.size());
    bound_ = h_(run_.start);
    while (bound_ < kUnreached) {
      ++run_.result.rounds;
      if (!round()) return record();
      bound_ = beyond_;
    }
    run_.finish(SearchStatus::none);
    record();
  }

 private:
  struct Frame {
    BoardCell cell;
    unsigned next;
  };

  /// All within the bound; false when the search is over.
  bool round() {
    beyond_ = kUnreached;
    nodes_.begin(run_.board.size());
    stack_.clear();
    if (!enter(run_.start, 0, 0)) return false;
    while (!stack_.empty()) {
      Frame& frame = stack_.back();
      const BoardCell c = frame.cell;
      const unsigned move = frame.next++;
      if (move == 8)
        stack_.pop_back();
      else if (run_.board.may(c, move) && !look(c, move))
        return false;
    }
    return true;
  }

  bool look(BoardCell c, unsigned move) {
    const BoardCell n = run_.board.moved(c, move);
    const std::int64_t g = nodes_.g(c) + GridBoard::cost(move);
    if (nodes_.seen(n) && nodes_.g(n) <= g) return true;
    const std::int64_t f = g + h_(n);
    if (f <= bound_) return enter(n, g, c);
    beyond_ = std::min(beyond_, f);
    if (run_.query.record) cut_.push_back(n);
    return true;
  }

  /// False at the goal and when there are no steps left.
  bool enter(BoardCell c, std::int64_t g, BoardCell parent) {
    const bool first = !ever_.marked(c);
    if (!run_.take(c, first)) return run_.finish(SearchStatus::stopped), false;
    ever_.mark(c);
    ++run_.result.entered;
    nodes_.set(c, g, parent);
    stack_.push_back({c, 0});
    if (c != run_.goal) return true;
    run_.found(g);
    run_.result.path = run_.trace(nodes_, c);
    return false;
  }

  void record() {
    std::erase_if(cut_, [&](BoardCell c) { return ever_.marked(c); });
    run_.record_frontier(std::move(cut_));
  }

  GridRun& run_;
  GridNodes& nodes_;
  GridNodes& ever_;
  GridEstimator h_;
  std::int64_t bound_ = 0;
  std::int64_t beyond_ = 0;
  std::vector<Frame> stack_;
  std::vector<BoardCell> cut_;
};

}  // namespace

void iterative_deepening(GridRun& run) { IterativeDeepening(run).search(); }

}  // namespace taut::detail
