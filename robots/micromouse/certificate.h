// The proof that a route of run 2 is the best there is, in what run 1 has seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/robots/micromouse/trial.h>

namespace taut::micromouse {

/// A wall, or an opening, and the step of run 1 that showed it.
struct Witness {
  CellSide wall{};  ///< canonical
  bool closed = false;
  int step = 0;  ///< index into Record::steps
  friend bool operator==(const Witness&, const Witness&) = default;
};

/// "No robot needs fewer than `steps` steps in run 2, and this route needs no more."
struct Certificate {
  Task task;
  int steps = 0;
  std::vector<Cell> route;        ///< ends of steps, start and goal included: steps + 1 cells
  std::vector<Witness> openings;  ///< every cell side the route crosses, in its order
  std::vector<Witness> walls;     ///< standing ones that end every shorter plan; not one of them can be spared
};

/// The certificate that the sights and moves of run 1 hold; nothing when they prove no route (lo < hi). Walls are tried
/// for omission in order of their names, so the set is minimal by inclusion, not in number. O(walls * one search).
std::optional<Certificate> certificate(const Record& record);

/// The answer of a check: valid, or the first thing that is wrong.
struct Finding {
  bool valid = true;
  std::string reason{};
  explicit operator bool() const { return valid; }
};

/// Whether the certificate proves what it says about this maze. Shares no code with the robots: walls are looked up in
/// the maze, routes and plans walked cell by cell with a queue.
///  1. The task is the one the maze sets.
///  2. Each named wall stands and each named opening is open.
///  3. The route begins at the start, ends in the goal, has `steps` steps of 1 to 3 cells straight, all openings named.
///  4. With the border and the named walls alone no plan has fewer steps.
///  5. No named wall can be spared.
Finding verify_certificate(const Certificate& certificate, const GridMaze& maze);

/// That, and: each witness is what the sensors, or a move, of that step of run 1 told.
Finding verify_certificate(const Certificate& certificate, const GridMaze& maze, const Record& record);

/// Whether the record is what the rules make of its actions in this maze: sights, poses, counts, status, score, news of
/// each step. Shares no code with Trial.
Finding verify_record(const Record& record, const GridMaze& maze);

}  // namespace taut::micromouse
