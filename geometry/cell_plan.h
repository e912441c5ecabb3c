// A world of axis-parallel walls as cells between its lines, and which of them one can pass between.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/world.h>

namespace taut {

/// A point robot's free space where everything is axis-parallel and dense: grid maps, mazes on a raster.
///
///  1. Every coordinate of the world lies on a line; cell (column, row) lies between lines column and column + 1, row
///     and row + 1. Beyond them nothing is free.
///  2. Nothing is computed: lines are coordinates as they stand in the world, and all questions are answered by
///     comparing them. So everything is exact, for what the numbers mean (written.h).
///  3. Three bits a cell: is it free, is the side to its right open, is the side above it. Open is a side with free
///     cells at both sides and no wall along it. Rows of bits are words; bits beyond the last column are 0.
class CellPlan {
 public:
  struct Cell {
    std::int32_t column = 0;
    std::int32_t row = 0;

    friend bool operator==(const Cell&, const Cell&) = default;
  };

  /// What lies around a point: quadrants counter-clockwise from the upper right one, which may lie in the same cell,
  /// and the rays between them from the one to the right on; ray i bounds quadrant i clockwise.
  struct Around {
    std::array<Cell, 4> cells;
    unsigned free = 0;    ///< bit i: quadrant i
    unsigned closed = 0;  ///< bit i: ray i; those between two quadrants that are not free, too

    /// The free quadrants that hang together with quadrant i around the point, as bits. Precondition: i is free.
    unsigned sector(int i) const;
    /// The sectors that hold the direction from p, whose surroundings these are, to q; closed.
    unsigned towards(Point p, Point q) const;
  };

  /// Nothing when something is not axis-parallel or has a thickness, when there are several areas, or when there would
  /// be more than 16 cells a wall and side (those of a raster are as many as they are). O(n + cells).
  static std::optional<CellPlan> of(const World& world);

  std::uint32_t columns() const { return static_cast<std::uint32_t>(xs_.size() - 1); }
  std::uint32_t rows() const { return static_cast<std::uint32_t>(ys_.size() - 1); }
  double x(std::size_t line) const { return xs_[line]; }
  double y(std::size_t line) const { return ys_[line]; }

  std::span<const std::uint64_t> free(std::uint32_t row) const { return words(free_, row); }
  std::span<const std::uint64_t> open_right(std::uint32_t row) const { return words(open_right_, row); }
  std::span<const std::uint64_t> open_above(std::uint32_t row) const { return words(open_above_, row); }
  std::size_t words_a_row() const { return words_; }

  /// False beyond the cells.
  bool is_free(Cell c) const { return bit(free_, c); }
  bool is_open_right(Cell c) const { return bit(open_right_, c); }
  bool is_open_above(Cell c) const { return bit(open_above_, c); }

  /// The columns whose closed cells hold x, first and last: one, or both beside a line. -1 and columns() are beyond.
  std::array<std::int32_t, 2> columns_at(double x) const { return cells_at(xs_, x); }
  std::array<std::int32_t, 2> rows_at(double y) const { return cells_at(ys_, y); }

  Around around(Point p) const;
  /// Of the point where lines cross.
  Around around_corner(std::uint32_t x_line, std::uint32_t y_line) const;

  /// Appends all constraints that a leg meets, and some near it. Pieces meet only at end points. O(cells that its
  /// columns cross it in).
  void append_along(const Segment& leg, std::vector<Constraint>& pieces) const;
  /// Appends all constraints that meet a box. O(cells).
  void append_within(const Box& box, std::vector<Constraint>& pieces) const;

  /// Halves the cells that x lies inside of, so that it is a line: nothing else changes. Its number. Precondition: it
  /// lies within the lines there are. O(cells / 64).
  std::uint32_t make_x_line(double x);
  std::uint32_t make_y_line(double y);
  /// A wall comes or goes. Precondition: to open, both cells beside the side are free.
  void set_open_right(Cell c, bool open) { set(open_right_, c, open); }
  void set_open_above(Cell c, bool open) { set(open_above_, c, open); }

 private:
  class Maker;
  CellPlan() = default;

  std::span<const std::uint64_t> words(const std::vector<std::uint64_t>& bits, std::uint32_t row) const {
    return {bits.data() + row * words_, words_};
  }
  bool bit(const std::vector<std::uint64_t>& bits, Cell c) const {
    if (c.column < 0 || c.row < 0 || c.column >= static_cast<std::int32_t>(columns()) ||
        c.row >= static_cast<std::int32_t>(rows()))
      return false;
    const auto column = static_cast<std::size_t>(c.column);
    return (bits[static_cast<std::size_t>(c.row) * words_ + column / 64] >> (column % 64)) & 1;
  }
  void set(std::vector<std::uint64_t>& bits, Cell c, bool to) {
    std::uint64_t& word = bits[static_cast<std::size_t>(c.row) * words_ + static_cast<std::size_t>(c.column) / 64];
    const std::uint64_t bit = std::uint64_t{1} << (c.column % 64);
    word = to ? word | bit : word & ~bit;
  }
  void widen_rows();
  static std::array<std::int32_t, 2> cells_at(const std::vector<double>& lines, double v);

  std::vector<double> xs_, ys_;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> free_, open_right_, open_above_;
};

}  // namespace taut
