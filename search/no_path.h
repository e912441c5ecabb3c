// The proof that there is no path, found in the free space itself and not by a search that gave up.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <taut/geometry/free_space.h>

namespace taut {

/// Says, for one free space, which ends walls keep apart.
///
///  1. A point is in the connected parts of free space around it: of one on a wall those of both sides. A room is in
///     those that meet the inside of one of its boxes. Ends without a common part are apart, and so are ends that are
///     in none; all others have a path between them.
///  2. A disc's free space is that of the polygon around it, so the disc may get through where that does not. Ends are
///     apart only if they are for a polygon inside the disc as well, roundings included; that space is built when it
///     is first asked for.
///  3. Where crossings were rounded, that there is no path means none that stays rounding_bound(space) from obstacles.
///     Of a point that is_sure() does not hold for not even that is proven.
class NoPath {
 public:
  explicit NoPath(FreeSpace space);
  ~NoPath();
  NoPath(const NoPath&) = delete;
  NoPath& operator=(const NoPath&) = delete;

  /// Is it proven that the robot cannot get from `from` to the goal? Of a point O(1) after locating; of a room O(n).
  bool holds(Point from, const Goal& to) const;

  /// The witness, unless nothing proves it: the closed chain of pieces between the ends, in order around the one or the
  /// other (FreeSpace::separation); empty where no place of an end is free.
  std::optional<std::vector<Constraint>> walls(Point from, const Goal& to) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
