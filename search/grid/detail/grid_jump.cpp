// Jump point search. Of the neighbours of a cell only those are looked at that have no way as short past the cell from
// where one came; chains of cells with a single such neighbour are jumped over.
#include <cstdlib>

#include <taut/search/grid/detail/grid_estimator.h>
#include <taut/search/grid/detail/grid_scratch.h>

namespace taut::detail {

namespace {

constexpr unsigned kNowhere = 8;  // the start was reached by no move

class Jumps {
 public:
  explicit Jumps(const GridRun& run)
      : board_(run.board), goal_(run.goal), squeezes_(run.board.moves() == GridMoves::eight) {}

  /// The next jump point that way, 0 when there is none.
  BoardCell jump(BoardCell c, unsigned move) const { return move < 4 ? straight(c, move) : diagonal(c, move); }

  /// The moves worth making at a jump point reached by `arrived`, as bits.
  unsigned worth(BoardCell c, unsigned arrived) const {
    const unsigned may = board_.moves_from(c);
    if (arrived == kNowhere) return may;
    return may & (arrived < 4 ? after_straight(c, arrived) : after_diagonal(c, arrived));
  }

 private:
  static constexpr unsigned bit(unsigned move) { return 1U << move; }
  static constexpr unsigned across(unsigned move) { return move < 4 ? (move + 1) % 4 : kNowhere; }
  static constexpr unsigned back(unsigned straight) { return (straight + 2) % 4; }
  static constexpr unsigned both(unsigned a, unsigned b) {
    return move_towards(GridBoard::kColumn[a] + GridBoard::kColumn[b], GridBoard::kRow[a] + GridBoard::kRow[b]);
  }
  static constexpr unsigned column_part(unsigned diagonal) { return move_towards(GridBoard::kColumn[diagonal], 0); }
  static constexpr unsigned row_part(unsigned diagonal) { return move_towards(0, GridBoard::kRow[diagonal]); }

  /// Is there, beside a cell reached by a straight move, something that has no way as short around the cell?
  bool forces(std::int64_t c, std::int64_t step, std::int64_t side) const {
    return squeezes_ ? !board_.free(c + side) && board_.free(c + side + step)
                     : !board_.free(c - step + side) && board_.free(c + side);
  }

  BoardCell straight(BoardCell from, unsigned move) const {
    const std::int64_t step = board_.step(move), side = board_.step(across(move));
    for (std::int64_t c = from + step; board_.free(c); c += step)
      if (c == goal_ || forces(c, step, side) || forces(c, step, -side)) return static_cast<BoardCell>(c);
    return 0;
  }

  bool forces_diagonally(BoardCell c, std::int64_t column_step, std::int64_t row_step) const {
    const auto forced = [&](std::int64_t behind, std::int64_t on) {
      return !board_.free(c - behind) && board_.free(c - behind + on);
    };
    return squeezes_ && (forced(column_step, row_step) || forced(row_step, column_step));
  }

  BoardCell diagonal(BoardCell c, unsigned move) const {
    const unsigned column_move = column_part(move), row_move = row_part(move);
    while (board_.may(c, move)) {
      c = board_.moved(c, move);
      if (c == goal_ || forces_diagonally(c, board_.step(column_move), board_.step(row_move)) ||
          straight(c, column_move) != 0 || straight(c, row_move) != 0)
        return c;
    }
    return 0;
  }

  unsigned after_straight(BoardCell c, unsigned move) const {
    unsigned moves = bit(move);
    for (const unsigned side : {across(move), back(across(move))}) {
      if (!forces(c, board_.step(move), board_.step(side))) continue;
      moves |= bit(both(move, side));
      if (!squeezes_) moves |= bit(side);
    }
    return moves;
  }

  unsigned after_diagonal(BoardCell c, unsigned move) const {
    const unsigned column_move = column_part(move), row_move = row_part(move);
    unsigned moves = bit(move) | bit(column_move) | bit(row_move);
    if (squeezes_ && !board_.free(c - board_.step(column_move))) moves |= bit(both(back(column_move), row_move));
    if (squeezes_ && !board_.free(c - board_.step(row_move))) moves |= bit(both(column_move, back(row_move)));
    return moves;
  }

  const GridBoard& board_;
  BoardCell goal_;
  bool squeezes_;  // diagonal moves between blocked cells
};

class JumpSearch {
 public:
  explicit JumpSearch(GridRun& run)
      : run_(run),
        nodes_(run.scratch.nodes[0]),
        heap_(run.scratch.heaps[0]),
        arrived_(run.scratch.arrived),
        h_(run.board, run.query.heuristic, run.goal),
        jumps_(run) {}

  void search() {
    nodes_.begin(run_.board.size());
    arrived_.resize(run_.board.size());
    heap_.begin(run_.query.ties);
    enter(run_.start, 0, 0, kNowhere);
    run_.finish(SearchStatus::none);
    while (!heap_.empty() && step()) {
    }
    run_.result.entered = heap_.entered();
    if (run_.query.record) run_.record_frontier(unmarked(heap_, nodes_));
  }

 private:
  void enter(BoardCell c, std::int64_t g, BoardCell parent, unsigned move) {
    if (nodes_.marked(c) || (nodes_.seen(c) && nodes_.g(c) <= g)) return;
    const std::int64_t h = h_(c);
    if (h >= kUnreached) return;
    nodes_.set(c, g, parent);
    arrived_[c] = static_cast<std::uint8_t>(move);
    heap_.push(g + h, c);
  }

  bool step() {
    const BoardCell c = heap_.top().cell;
    if (nodes_.marked(c)) return heap_.pop(), true;
    if (!run_.take(c)) return run_.finish(SearchStatus::stopped), false;
    heap_.pop();
    nodes_.mark(c);
    if (c == run_.goal) {
      run_.found(nodes_.g(c));
      run_.result.path = filled(run_.trace(nodes_, c));
      return false;
    }
    for (unsigned rest = jumps_.worth(c, arrived_[c]); rest != 0; rest &= rest - 1) {
      const auto move = static_cast<unsigned>(std::countr_zero(rest));
      if (const BoardCell n = jumps_.jump(c, move); n != 0)
        enter(n, nodes_.g(c) + moves_between(c, n) * GridBoard::cost(move), c, move);
    }
    return true;
  }

  std::int64_t moves_between(BoardCell a, BoardCell b) const {
    const GridPlace p = run_.board.place(a), q = run_.board.place(b);
    const std::int64_t rows = std::abs(std::int64_t{p.row} - q.row);
    return rows != 0 ? rows : std::abs(std::int64_t{p.column} - q.column);
  }

  /// With the cells between jump points.
  std::vector<GridPlace> filled(const std::vector<GridPlace>& points) const {
    std::vector<GridPlace> path{points.front()};
    const auto towards = [](std::uint32_t from, std::uint32_t to) {
      return from + (to > from ? 1U : 0U) - (to < from ? 1U : 0U);
    };
    for (const GridPlace p : points)
      while (path.back() != p) path.push_back({towards(path.back().row, p.row), towards(path.back().column, p.column)});
    return path;
  }

  GridRun& run_;
  GridNodes& nodes_;
  GridHeap& heap_;
  std::vector<std::uint8_t>& arrived_;
  GridEstimator h_;
  Jumps jumps_;
};

}  // namespace

void jump_points(GridRun& run) { JumpSearch(run).search(); }

}  // namespace taut::detail
