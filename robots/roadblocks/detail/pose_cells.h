// Which poses no car can get from to the goal: a proof by cells of poses.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <taut/robots/roadblocks/detail/disc_distance.h>

namespace taut::roadblocks::detail {

/// Poses in cells of 1/16 x 1/16 x 1/120 of a turn, which is more than a step turns, up to kBeyond outside of the grid
/// too. Quarter turns lie between cells.
///
///  1. A cell is closed when each of its poses collides: a rectangle inside all their rectangles touches something
///     closed, or the cell's middle lies in a gate that is no wider than the car. Both are tested conservatively: a
///     cell that holds a free pose is not closed.
///  2. Two cells are neighbours when some step, of any control, leads from a pose of one to a pose of the other, or
///     back; what the step meets between is not looked at, but for this: in squares, whose contacts count all along a
///     step, a step past a quarter turn needs a free pose with that very heading within its length. The free ones are
///     known exactly: car and squares are parallel then, and all edges lie on the halves of the unit. So a bend is no
///     way when it leaves a car that stands square to it exactly its own length or width.
///  3. reaches() is false only where no sequence of steps leads to the goal, whatever the controls, unless it leaves
///     the grid by more than kBeyond. True says nothing.
/// Bits of a cell are headings: all of them spread at once. Linear in the number of cells, some 0.2 s for 50 x 50.
class PoseCells {
 public:
  PoseCells(const Obstacles& obstacles, Point goal);

  bool reaches(const Pose& pose) const;

  static constexpr int kCells = 16;  ///< to the unit
  static constexpr int kHeadings = 120;
  static constexpr int kBeyond = 4;  ///< units

  /// Headings; 64 in a word.
  struct Bits {
    static constexpr int kUpper = kHeadings - 64;  ///< bits of the second word
    static constexpr std::uint64_t kAllUpper = (std::uint64_t{1} << kUpper) - 1;
    std::array<std::uint64_t, 2> word{};

    static Bits all() { return {{~std::uint64_t{0}, kAllUpper}}; }
    bool any() const { return (word[0] | word[1]) != 0; }
    bool has(int h) const { return (word[static_cast<std::size_t>(h / 64)] >> (h % 64)) & 1; }
    void set(int h) { word[static_cast<std::size_t>(h / 64)] |= std::uint64_t{1} << (h % 64); }
    Bits operator&(const Bits& o) const { return {{word[0] & o.word[0], word[1] & o.word[1]}}; }
    Bits operator|(const Bits& o) const { return {{word[0] | o.word[0], word[1] | o.word[1]}}; }
    Bits without(const Bits& o) const { return {{word[0] & ~o.word[0], word[1] & ~o.word[1]}}; }
    /// The next of each, up and down.
    Bits up() const {
      return {{(word[0] << 1) | (word[1] >> (kUpper - 1)), ((word[1] << 1) | (word[0] >> 63)) & kAllUpper}};
    }
    Bits down() const { return {{(word[0] >> 1) | (word[1] << 63), (word[1] >> 1) | ((word[0] & 1) << (kUpper - 1))}}; }
  };

 private:
  void close(const Obstacles& obstacles);
  void close_gates(const Obstacles& obstacles);
  void find_quarters(const Obstacles& obstacles);
  Bits wider(std::size_t cell, const Bits& bits) const;
  void spread(Point goal);
  int index(double v) const;
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }

  int columns_, rows_;
  std::vector<Bits> open_;     ///< not closed, and not reached so far; only while it is made
  std::vector<Bits> reached_;  ///< the goal, from there
  /// bit 0: heading 0 or a half turn can be passed within a step from there, bit 1: a quarter turn
  std::vector<std::uint8_t> quarters_;
};

}  // namespace taut::roadblocks::detail
