// An end of a query on a PRM that grows. Private.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <taut/roadmaps/prm_clear.h>
#include <taut/roadmaps/roadmap.h>

namespace taut::detail {

/// The `count` nearest vertices that a point can be joined to, as nearest_visible() has them; kept while vertices are
/// added, so that each is looked at once.
class PrmEnd {
 public:
  /// Precondition: p is not outside. `clear` must outlive it.
  PrmEnd(const PrmClear& clear, Point p, std::size_t count);

  Point point() const { return p_; }
  /// `points`: all vertices, those of the last call in front.
  std::vector<Roadmap::Vertex> joined(std::span<const Point> points);

 private:
  using Rank = std::pair<double, Roadmap::Vertex>;  // by the squared distance, rounded

  const PrmClear& clear_;
  Point p_;
  std::size_t count_;
  Location at_;
  bool keeps_clearance_;
  std::size_t seen_ = 0;
  std::vector<Rank> nearest_;  // in order
};

}  // namespace taut::detail
