// A* over the bends of a reduced visibility graph, along taut legs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/roadmaps/navmesh.h>
#include <taut/roadmaps/point_sights.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/detail/landmarks.h>
#include <taut/search/detail/lasting_legs.h>
#include <taut/search/detail/taut_legs.h>

namespace taut::detail {

/// A reduced visibility graph, arranged for queries. Immutable.
struct BendGraph {
  /// `mesh` is of the same space; `jobs` threads make the graph.
  BendGraph(const FreeSpace& space, const Navmesh& mesh, unsigned jobs = 1);
  BendGraph(const BendGraph&) = delete;
  BendGraph& operator=(const BendGraph&) = delete;

  VisibilityGraph graph;
  PointSights sights;
  TautLegs legs;
  LastingLegs lasting;
  std::vector<std::uint32_t> mesh_bend;  ///< vertex -> the mesh's bend of the same sector
};

/// One query after the other in the same memory.
///
/// Lengths are sums of two doubles with a bound on what is missing; where they do not tell, the ways are compared as
/// sums of roots. A vertex that turns out to be nearer is taken up again, and the search goes on until no open vertex
/// can be on a way as short as the best. So the path is the shortest, whatever was rounded.
class BendSearch {
 public:
  /// All outlive it; `landmarks`, of `mesh`, may be absent.
  BendSearch(const BendGraph& graph, const Navmesh& mesh, const Landmarks* landmarks);

  /// The shortest path; false when there is none. `goals`: the polygons that hold `to`. Precondition: both ends are
  /// places for the robot.
  bool find(Point from, Point to, std::span<const std::uint32_t> goals, std::vector<Point>& path);

  std::size_t expanded() const { return expanded_; }
  std::size_t generated() const { return labels_.size() + 1; }

 private:
  static constexpr std::size_t kPlace = static_cast<std::size_t>(-1);  // reached from the start itself

  /// A way to a vertex: on from that of `before`, kNone being the start, by the leg `via`.
  struct Label {
    twofold::Pair length;
    std::size_t via;
    std::uint32_t vertex;
    std::uint32_t before;
  };
  struct State {
    std::uint32_t query = 0;
    std::uint32_t label = 0;
    double length = 0;  // the label's high part
    double rest = 0;    // to the goal, at least
    std::uint32_t goal_query = 0;
    std::uint32_t goal_leg = 0;
    std::uint32_t wanted_query = 0;
    std::uint32_t wanted = kNone;  // the first of its list
  };
  /// A leg that does not last, but may be on the way to the goal.
  struct Wanted {
    std::uint32_t leg;
    std::uint32_t next;  // from the same vertex
  };
  struct Open {
    double bound;
    std::uint32_t label;
  };

  void begin(Point to, std::span<const std::uint32_t> goals);
  void look_back(std::span<const Roadmap::Vertex> seen_from_goal);
  void want_taut(std::uint32_t vertex);
  void want(LastingLegs::Arrival arrival);
  void expand(std::uint32_t label);
  void follow(std::uint32_t label, TautLegs::Range range);
  void follow_wanted(std::uint32_t label);
  bool leads_nowhere(twofold::Pair here, double length, std::uint32_t to) const;
  void reach(std::uint32_t before, std::uint32_t vertex, twofold::Pair length, std::size_t via);
  void arrive(std::uint32_t label);
  bool is_shorter(twofold::Pair a, std::uint32_t before_a, Point end_a, twofold::Pair b, std::uint32_t before_b,
                  Point end_b);
  bool is_shorter_exactly(std::uint32_t a, Point end_a, std::uint32_t b, Point end_b);
  double rest_of(std::uint32_t vertex) const;
  Point point(std::uint32_t label) const { return label == kNone ? from_ : points_[labels_[label].vertex]; }
  void give(std::vector<Point>& path) const;

  const BendGraph& graph_;
  const std::vector<Point>& points_;
  LandmarkBounds landmarks_;
  PointSights::Finder sights_;
  std::uint32_t query_ = 0;
  Point from_, to_;
  std::vector<State> states_;  // by vertex
  std::vector<Label> labels_;
  std::vector<Open> open_;                // a heap, the least bound first
  std::vector<twofold::Pair> goal_legs_;  // of the vertices that the goal sees
  std::vector<std::uint32_t> wanted_in_;  // by leg: the query that wanted it last
  std::vector<Wanted> wanted_;
  std::uint32_t best_ = kNone;  // the label of the last bend
  twofold::Pair best_length_{};
  double limit_ = 0;  // no way longer than this is of interest
  std::vector<Segment> legs_a_, legs_b_;
  std::size_t expanded_ = 0;
};

}  // namespace taut::detail
