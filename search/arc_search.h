// The shortest path of a disc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <taut/roadmaps/all_radii.h>
#include <taut/search/arc_path.h>
#include <taut/search/search_status.h>

namespace taut {

/// The answer, and what it took.
struct ArcSearchResult {
  DiscStatus status = DiscStatus::none;
  ArcPath path;  ///< when found
  /// When an end is blocked: the nearest constraint, the lowest of equals; kNone when it is outside
  std::uint32_t wall = kNone;
  std::size_t expanded = 0;  ///< tangent points looked around from
};

/// The shortest path of the centre of the graph's disc from s to g, as TangentGraph defines what is allowed. A*.
///
///  1. That there is a path, that there is none, and that an end is no place are exact; they agree with disc_passage.
///  2. Lengths of arcs are transcendental: lengths are compared by enclosures. Of two ways whose enclosures overlap the
///     one found first is kept (ties in grids are usual, and whether two such lengths are equal is not decidable by
///     more digits). So no path is shorter than the one found by more than the width of its `length` for each of its
///     pieces.
///  3. A bend whose arc has no length is left out: the tangents before and after it are one.
///  4. An end on an opening stands for the inside near it; at a joint of several openings for the triangle that
///     FreeSpace::locate names.
///  5. Same graph, same ends, same path.
/// O(V) memory; joins the ends to what they see, then O((V + E) log V) at worst.
ArcSearchResult arc_search(const TangentGraph& graph, Point s, Point g);

/// The same at a radius that has no graph yet, of which only that is made which the search comes by: for one query or a
/// few. The answer is that in all.at_radius(r), but of ways whose enclosures overlap it may keep another one.
/// Precondition: 0 < r <= World::kLargest.
ArcSearchResult arc_search(const AllRadii& all, double r, Point s, Point g);

/// The same for many queries in one graph, the same answers. Nothing of the graph is copied or cleared for a query, and
/// after some queries (or when asked to) it is prepared: tangent points are taken out of the graph one after the other,
/// until a query climbs a few edges from each end and crosses a small core (docs/all-radii.md). Preparing takes some
/// thirty times as long as an unprepared query. Not for several threads at once.
class ArcQueries {
 public:
  explicit ArcQueries(TangentGraph graph);
  ~ArcQueries();
  ArcQueries(ArcQueries&&) noexcept;
  ArcQueries& operator=(ArcQueries&&) noexcept;

  const TangentGraph& graph() const;
  ArcSearchResult find(Point s, Point g);
  void prepare();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
