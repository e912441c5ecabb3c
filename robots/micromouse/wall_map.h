// What a robot knows of a maze: each wall is unknown, open or closed.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/robots/micromouse/rules.h>

namespace taut::micromouse {

/// What is known of a wall.
enum class WallState : std::uint8_t { unknown, open, closed };

/// The rows of a set of cells: bit y * width + x. As passages: cell has an open (or a known) side to the north or to
/// the east.
using CellBits = std::vector<std::uint64_t>;

/// Passages of a maze as two sets of cells: which ones are open to the north, which ones to the east.
struct Passages {
  int width = 0;
  int height = 0;
  CellBits north;
  CellBits east;

  std::size_t words() const { return north.size(); }
  bool open(Cell cell, Side side) const;      ///< false across the border
  void set(Cell cell, Side side, bool open);  ///< precondition: not across the border
};

/// No wall but the border (`open`), or all of them.
Passages passages(int width, int height, bool open);
/// Those of a maze; its border counts as closed.
Passages passages_of(const GridMaze& maze);

/// A fact about a wall.
struct WallSeen {
  CellSide wall{};  ///< canonical
  bool closed = false;
  friend bool operator==(const WallSeen&, const WallSeen&) = default;
};

/// Knowledge of walls, from sights and from moves. The border is known to be closed from the start.
/// Facts must not contradict each other (precondition): then knowledge only grows. All operations O(facts told).
class WallMap {
 public:
  explicit WallMap(const Task& task);

  int width() const { return certain_.width; }
  int height() const { return certain_.height; }

  WallState state(Cell cell, Side side) const;
  std::size_t unknown() const { return unknown_; }           ///< interior walls not yet seen
  std::size_t seen() const { return interior_ - unknown_; }  ///< interior ones

  /// Each returns whether, or which of it, was news.
  bool learn(Cell cell, Side side, bool closed);
  std::vector<WallSeen> see(const MousePose& pose, const SensorReading& sight);
  /// A step from `before` that ended in `after`: the cells between are open; a move cut short ends at a wall.
  std::vector<WallSeen> move(const MousePose& before, const Action& action, const MousePose& after);

  /// Unknown walls closed: a way through these surely exists.
  const Passages& certain() const { return certain_; }
  /// Unknown walls open: no way outside of these exists.
  const Passages& possible() const { return possible_; }

 private:
  Passages certain_;
  Passages possible_;
  std::size_t interior_ = 0;
  std::size_t unknown_ = 0;
};

/// Where a robot is, by its own sights and actions alone.
///  1. A forward move ends after min(movement, sensor reading in that direction) cells.
///  2. A backward move came as far as the reading ahead has grown: known with the next sight.
/// So the pose is exact after every sight, also after moves that a wall has stopped.
class Odometer {
 public:
  explicit Odometer(const Task& task) : start_{task.start, Side::north}, pose_(start_) {}

  /// To be called with each sight, before asking for the pose, and with each action.
  void sense(const SensorReading& sight);
  void act(const Action& action);
  /// Run 2 begins: the reset was granted.
  void restart();

  const MousePose& pose() const { return pose_; }
  const MousePose& previous() const { return previous_; }

 private:
  MousePose start_;
  MousePose pose_;
  MousePose previous_;
  SensorReading sight_{};
  std::optional<Action> pending_;
};

}  // namespace taut::micromouse
