// A cost map, a robot's start and a target's trajectory: what a chase is about.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <taut/geometry/grid_maze.h>

namespace taut::pursuit {

/// Costs are whole multiples of a map's unit, a power of ten: sums are exact.
using Cost = std::int64_t;

/// Cells, numbered.
using CellIndex = std::uint32_t;

/// A validated cost map; immutable.
///
///  1. Cells are (x, y), 1 <= x <= x_size(), 1 <= y <= y_size(), as in the files. They are numbered with a border of
///     obstacles around them, so that the eight neighbours of every cell of the map exist: index + {-1, 0, 1} +
///     {-stride(), 0, stride()}.
///  2. A cell is an obstacle or has a cost of 0 <= cost < 2^32 - 1 units; one unit is 10^-decimals().
///  3. For every path of at most duration() seconds: its cost in units times 2^bit_width(duration()) fits in 63 bits.
///  4. The start is on the map and free. Trajectory entries are on the map, possibly in obstacles; consecutive ones
///     need not be neighbours.
class ChaseMap {
 public:
  static constexpr std::uint32_t kObstacle = std::numeric_limits<std::uint32_t>::max();
  static constexpr int kLongestSide = 32766;

  /// What a map is made of. `costs` holds x_size * y_size values, y fastest, in units, kObstacle for obstacles.
  struct Parts {
    int x_size = 0;
    int y_size = 0;
    std::vector<std::uint32_t> costs;
    int decimals = 0;
    Cell start;
    std::vector<Cell> target;  ///< one a second
    std::string threshold{};   ///< C as the file writes it; empty: above every cost
    bool rounded = false;
    std::string source;
  };

  /// The most units a cost may have on a map with a trajectory of so many entries (guarantee 3).
  static std::uint32_t largest_cost(std::size_t entries);

  /// Throws InputError when a guarantee cannot be given.
  explicit ChaseMap(Parts parts);

  int x_size() const { return x_size_; }
  int y_size() const { return y_size_; }
  std::size_t stride() const { return static_cast<std::size_t>(y_size_) + 2; }
  std::size_t index_count() const { return costs_.size(); }  ///< border included

  CellIndex index(Cell c) const {
    return static_cast<CellIndex>(static_cast<std::size_t>(c.x) * stride() + static_cast<std::size_t>(c.y));
  }
  Cell cell(CellIndex i) const { return {static_cast<int>(i / stride()), static_cast<int>(i % stride())}; }

  bool is_free(CellIndex i) const { return costs_[i] != kObstacle; }
  std::uint32_t cost(CellIndex i) const { return costs_[i]; }  ///< in units; kObstacle
  const std::vector<std::uint32_t>& costs() const { return costs_; }

  CellIndex start() const { return start_; }
  const std::vector<CellIndex>& target() const { return target_; }
  std::size_t duration() const { return target_.size(); }  ///< number of entries, one a second

  /// The same ground and start, for somebody who must not know where the target goes: the trajectory has one entry, the
  /// start.
  ChaseMap without_trajectory() const;

  int decimals() const { return decimals_; }
  bool rounded() const { return rounded_; }  ///< a cost had more digits than fit (guarantees 2, 3) and was rounded
  const std::string& threshold() const { return threshold_; }
  const std::string& source() const { return source_; }

  /// A number of units as a decimal number, without trailing zeros; and as the nearest double.
  std::string cost_text(Cost units) const;
  double cost_value(Cost units) const;

 private:
  int x_size_;
  int y_size_;
  std::vector<std::uint32_t> costs_;
  std::vector<CellIndex> target_;
  CellIndex start_ = 0;
  int decimals_;
  bool rounded_;
  std::string threshold_;
  std::string source_;
};

/// The map as a file with sections N, C, R, T, M that read_chase_map reads back; obstacles are written as the
/// threshold.
std::string chase_map_text(const ChaseMap& map);

}  // namespace taut::pursuit
