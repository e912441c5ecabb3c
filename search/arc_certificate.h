// A proof of how long the shortest path of a disc is, in integers. docs/certificates.md says why it proves it.
#pragma once

#include <memory>
#include <optional>

#include <taut/geometry/world.h>
#include <taut/search/arc_path.h>
#include <taut/search/disc_certificate.h>
#include <taut/search/path_certificate.h>

namespace taut {

/// Two certificates about one path of straight legs, which follows the arcs outside.
struct ArcCertificate {
  double radius = 0;
  Point start, goal;
  PathCertificate bound;  ///< in inner_world(): what no path is shorter than, and that this one is open
  DiscCertificate keeps;  ///< in bare_world(): how far it is from all walls. Its chain is a wall's end near the start
};

/// Proofs about one disc in one world. What is made of the world is made once.
class ArcProver {
 public:
  /// Preconditions: `ground` is a disc_ground(), r > 0. Throws InputError as LatticeIntegers does.
  ArcProver(const World& ground, double r);
  ~ArcProver();
  ArcProver(ArcProver&&) noexcept;
  ArcProver& operator=(ArcProver&&) noexcept;

  /// Arcs become tangents, the angle between two that follow each other no larger than 2 pi / kArcSteps, so the path of
  /// legs keeps the radius, too (but for a 10^-7th of it where it passes between walls that are twice the radius
  /// apart). It is longer than the arcs by less than a 3000th of them. Precondition: `path` is that of the disc in
  /// `ground`. Nothing where numbers do not suffice. Where an arc touches a limit that is no wall, the legs leave the
  /// world and prove nothing. O(search).
  std::optional<ArcCertificate> certificate(const ArcPath& path) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

inline constexpr int kArcSteps = 128;

}  // namespace taut
