// What `taut check` found, for people and for programs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <taut/cli/input.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/number_lattice.h>
#include <taut/io/results/json.h>
#include <taut/io/worlds/read_path.h>
#include <taut/search/verify.h>

namespace taut::cli {

/// A valid world, counted. Keys of the result, stable:
///  format            its name in options
///  walls             number; dropped_walls: of no length; unknown_walls: not looked at, read as open
///  solids, areas     numbers of obstacle polygons, and of polygons the world is made of
///  boundary          "walled", "limit" or "open" (world.h)
///  box               [xmin, ymin, xmax, ymax]
///  openings          [[[x1, y1], [x2, y2]], ...]
///  start, goal       [x, y] or null; {"point": ...}, {"room": ...} or null
///  free_space        {"area", "components", "polygons", "holes", "corners", "reflex_corners", "triangles",
///                    "displacement"}
///  path              null, or {"valid", "reason", "leg", "length", "points", "clearance"} of the path to check, of
///                    several the first that is not valid; points: their number; with "tolerance" where legs stand for
///                    curves, so far from them at most
///  paths             of several paths each
/// The run adds what reading noted: remarks, snap and near (tell() in input.h).
class CheckReport {
 public:
  CheckReport(const Input& input, const FreeSpace& space);

  void add_path(const ClaimedPath& path, const Verdict& verdict);

  /// Are the paths, if there are any to check, valid?
  bool valid() const { return invalid() == nullptr; }
  /// Why it is not.
  std::string fault() const { return valid() ? "" : invalid()->second.reason; }

  std::string text() const;
  Json json() const;

 private:
  using Judged = std::pair<ClaimedPath, Verdict>;

  /// The first that is not valid.
  const Judged* invalid() const;
  static std::string text(const Judged& path);
  static Json json(const Judged& path);

  const Input& input_;
  const FreeSpace& space_;
  std::vector<Judged> paths_;
  std::optional<NumberLattice> lattice_;
  double area_ = 0;
  std::size_t holes_ = 0;
  std::size_t corners_ = 0;
  std::size_t reflex_corners_ = 0;
};

}  // namespace taut::cli
