// Where a disc of any radius can go, and how wide it is there: one index for all radii.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <taut/geometry/interval.h>
#include <taut/roadmaps/gates.h>
#include <taut/search/disc_passage.h>

namespace taut {

/// A point, found in a PassageIndex.
struct PassagePlace {
  Point point;
  bool outside = true;               ///< no path can be there
  bool on_wall = false;              ///< free for a point, for no disc
  std::uint32_t face = kNone;        ///< kNone when outside, on a wall, or where there are no walls
  std::uint32_t component = kNone;   ///< FreeSpace::component
  std::uint32_t constraint = kNone;  ///< the nearest wall, the lowest index among equals; kNone: there is none
  bool tied = false;                 ///< another wall is as near within rounding: `constraint` may be that one
  Interval distance;                 ///< encloses the distance to the nearest wall
};

/// All gates of a space, the faces between them, and the widest ways from face to face.
///
///  1. The same answers as disc_passage and widest_passage, without going through the gates: a tree of the widest gates
///     says in O(1) which gate is the bottleneck between two faces. Exact, openings included (docs/passage-index.md).
///  2. A point is found by its nearest wall, the face beside it there, and, where the straight line to it crosses an
///     opening, the face beside that. O(log n) on usual inputs, however large the face.
///  3. Immutable; to be asked from several threads.
/// Built in O(n log n) beyond the gates. Precondition: the space's footprint is Footprint::point().
class PassageIndex {
 public:
  explicit PassageIndex(const FreeSpace& space) : PassageIndex(Gates(space)) {}
  explicit PassageIndex(Gates gates);

  const Gates& gates() const;

  PassagePlace place(Point p) const;

  /// Can a disc of radius r > 0 get from s to g?
  DiscStatus passes(const PassagePlace& s, const PassagePlace& g, double r) const;
  DiscStatus passes(Point s, Point g, double r) const { return passes(place(s), place(g), r); }

  /// The bottleneck: the widest disc that gets from one to the other, were there no walls but at gates, has its width.
  /// kNone: there is no gate that every way has to pass, or no way at all (then the components differ).
  std::uint32_t bottleneck(const PassagePlace& s, const PassagePlace& g) const;

  /// The largest disc that gets from s to g; as widest_passage, but for the barrier, which is left empty
  /// (disc_passage has it).
  std::optional<WidestPassage> widest(const PassagePlace& s, const PassagePlace& g) const;
  std::optional<WidestPassage> widest(Point s, Point g) const { return widest(place(s), place(g)); }

  /// The largest double that is not above gate i's half width: the largest disc that passes it.
  double gate_radius(std::uint32_t i) const;

  /// The largest disc whose centre can be at the place, exactly: the largest double not above the distance of the
  /// nearest wall. 0 on a wall; infinite without walls. Precondition: not outside.
  double radius_at(const PassagePlace& p) const;

  /// A face: its boundary, counter-clockwise around it; walls that stand in it are passed on both sides. Rounded.
  Ring outline(std::uint32_t face) const;

  /// What one start reaches.
  struct Reach {
    std::uint32_t face = kNone;
    std::uint32_t gate = kNone;  ///< the bottleneck on the way; kNone for the start's own face
  };
  /// All faces that a small disc gets to from p, by face. Empty on walls, outside and without walls.
  std::vector<Reach> reach(const PassagePlace& p) const;

  /// The faces on both sides of gate i, piece by piece.
  std::vector<std::array<std::uint32_t, 2>> sides(std::uint32_t gate) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
