// The text protocol of the simulator mms (github.com/mackorone/mms), so that its robots run here unchanged.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include <taut/robots/micromouse/trial.h>

namespace taut::micromouse {

/// What a robot wrote on a cell, for pictures.
struct CellMark {
  std::string text{};  ///< at most 10 characters
  char colour = 0;     ///< mms's letter, 0: none
};

/// The mouse at the other end of the protocol; it drives a trial, whose rules hold.
///
///  1. A turn costs no step of its own where the next command to move can take it along; turning around costs one.
///     `moveForward N` costs a step for each three cells. All the same the walls that it asks for are those of a mms
///     mouse: of its own cell, on all four sides, in sight anyway or come through.
///  2. A move that a wall cuts short answers `crash`, as one of less than a cell does; any other one `ack`.
///  3. Run 2 begins with `ackReset`, or when the mouse is back at the start by itself, once the goal has been reached:
///     the reset costs its step. With `button` `wasReset` answers true from the goal to that; else never.
///  4. `getStat` counts as mms does: distances and turns as commanded.
///  5. Lines that are no command are ignored. Half steps and turns of 45 degrees are InputErrors, and so are walls
///     further off than its own cell's, and `ackReset` at any other time than 3.
class MmsMouse {
 public:
  /// Both must outlive it. Precondition: the trial is of that maze and has not begun.
  MmsMouse(const GridMaze& maze, Trial& trial, bool button);

  /// What to write back, without line end; empty: nothing. Precondition: the trial is not over.
  std::string answer(std::string_view line);

  const std::map<Cell, CellMark>& marks() const { return marks_; }

 private:
  struct Count {
    int distance = 0, turns = 0;
    double effective = 0;
    double score() const { return turns + effective; }
  };

  std::string move(int cells);
  bool advance(int cells);
  void turn(int quarters);
  void begin_run2();
  void note_run();
  std::string reset();
  std::string wall(int quarters, std::string_view steps) const;
  std::string stat(std::string_view what) const;
  void mark(std::string_view command, std::string_view rest);

  const GridMaze& maze_;
  Trial& trial_;
  bool button_;
  Side facing_ = Side::north;  // as the robot has it; the trial's mouse turns with the next move
  std::map<Cell, CellMark> marks_;
  Count total_, current_, best_;
  bool is_running_ = false, solved_ = false;
  double penalty_ = 0;
};

}  // namespace taut::micromouse
