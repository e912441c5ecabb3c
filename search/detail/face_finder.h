// Which face a point is in. Private.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/search/detail/passage_faces.h>
#include <taut/search/detail/wall_tree.h>
#include <taut/search/passage_index.h>

namespace taut::detail {

/// Finds points by their nearest wall (docs/passage-index.md).
class FaceFinder {
 public:
  explicit FaceFinder(const Gates& gates);

  const PassageFaces& faces() const { return faces_; }

  PassagePlace find(Point p) const;

  /// The nearest wall, exactly; the lowest index among equals. Precondition: there are walls.
  std::uint32_t nearest_wall(const PassagePlace& p) const;

 private:
  /// Sets the nearest wall and the distance.
  void find_wall(PassagePlace& place, const std::vector<NearWall>& near) const;
  void find_by_triangle(PassagePlace& place, const std::vector<NearWall>& near) const;
  std::optional<std::uint32_t> on_constraint(const Location& at, PassagePlace& place) const;
  std::uint32_t face_at(Point p, const std::vector<NearWall>& near) const;
  std::uint32_t face_towards(Point p, std::uint32_t wall) const;
  std::uint32_t face_beyond_openings(Point p, std::uint32_t wall, std::uint32_t here) const;
  std::uint32_t lowest_nearest(Point p, const std::vector<NearWall>& near) const;

  Gates gates_;
  PassageFaces faces_;
  WallTree tree_;
  std::vector<std::uint32_t> openings_;
  BoxIndex opening_boxes_;
};

}  // namespace taut::detail
