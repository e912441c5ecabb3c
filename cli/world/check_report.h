// What `taut check` found, for people and for programs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

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
///  path              null, or {"valid", "reason", "leg", "length", "points", "clearance"} of the path to check;
///                    points: their number
/// The run adds what reading noted: remarks, snap and near (tell() in input.h).
class CheckReport {
 public:
  CheckReport(const Input& input, const FreeSpace& space);

  void add_path(const ClaimedPath& path, const Verdict& verdict);

  /// Is the path, if there is one to check, valid?
  bool valid() const { return !path_ || path_->second.valid; }
  /// Why it is not.
  std::string fault() const { return valid() ? "" : path_->second.reason; }

  std::string text() const;
  Json json() const;

 private:
  std::string path_text() const;

  const Input& input_;
  const FreeSpace& space_;
  std::optional<std::pair<ClaimedPath, Verdict>> path_;
  std::optional<NumberLattice> lattice_;
  double area_ = 0;
  std::size_t holes_ = 0;
  std::size_t corners_ = 0;
  std::size_t reflex_corners_ = 0;
};

}  // namespace taut::cli
