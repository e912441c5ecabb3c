// Paths of discs of many radii, some of which are asked about again and again.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <taut/roadmaps/all_radii.h>
#include <taut/search/arc_search.h>

namespace taut {

/// Answers as arc_search(all, r, s, g) does, with graphs of radii as they pay.
///
///  1. The first query of a radius is answered without a graph (of ways whose enclosures overlap it may keep another
///     one than later queries do): it may stay the only one.
///  2. The second one makes the radius' graph. Graphs of the 16 radii asked about last are kept, and that a radius was
///     asked about of the last 64 that were new.
/// Not for several threads at once.
class RadiusQueries {
 public:
  explicit RadiusQueries(AllRadii all) : all_(std::move(all)) {}

  const AllRadii& all() const { return all_; }
  /// Precondition: 0 < r <= World::kLargest.
  ArcSearchResult find(double r, Point s, Point g);
  /// Where the next query of this radius, which counts as asked by that, is best asked: in its graph, or without one.
  /// Valid until the next call.
  ArcQueries* graph(double r);
  std::size_t graphs_made() const { return made_; }

 private:
  bool is_first(double r);

  AllRadii all_;
  std::vector<double> asked_;     // without a graph; the radius asked about first in front
  std::vector<ArcQueries> kept_;  // the one used last behind
  std::size_t made_ = 0;
};

}  // namespace taut
