// The groups of a picture of a free space, from the ground up: what all such pictures share.
#pragma once

#include <string>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/io/pictures/detail/svg_path.h>
#include <taut/io/pictures/detail/svg_style.h>
#include <taut/io/pictures/svg.h>
#include <taut/roadmaps/roadmap.h>
#include <taut/roadmaps/voronoi.h>

namespace taut::detail {

/// Draws a space with its box's north-west corner at `top_left`, its longer side `pixels` long. Each group is a <g> of
/// the class that svg() names, empty text where there is nothing to show. `space` must outlive it.
class SvgLayers {
 public:
  SvgLayers(const FreeSpace& space, Point top_left, double pixels);

  /// How large that is, in pixels.
  static Point size(const World& world, double pixels);
  /// The legend's scale bar for it.
  static SvgKey ruler(const World& world, double pixels);
  static SvgStrokes strokes(const FreeSpace& space, double pixels);

  const SvgScale& scale() const { return scale_; }
  const SvgStrokes& strokes() const { return strokes_; }

  std::string solid() const;
  std::string free() const;
  std::string rooms(const Goal& goal) const;
  std::string walls() const;
  std::string openings() const { return lines("openings", space_.world().openings()); }
  std::string lines(const char* kind, const std::vector<Segment>& segments) const;
  std::string discs(const std::vector<SvgDisc>& discs) const;
  /// Where `disc` > 0, a radius in the world, it leaves a disc of that size to be seen around it.
  std::string marker(const char* kind, Point at, double disc = 0) const;

  SvgPath edges(const Roadmap& roadmap) const;
  SvgPath edges(const VoronoiRoadmap& diagram) const;
  SvgPath dots(const Roadmap& roadmap) const;  ///< its vertices

  static std::string group(const char* kind, const SvgPath& path);
  /// A casing and the line.
  static std::string path(const SvgPath& line);

 private:
  const FreeSpace& space_;
  Box box_;
  double extent_;
  SvgStrokes strokes_;
  SvgScale scale_;
};

}  // namespace taut::detail
