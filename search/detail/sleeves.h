// Where only one way leads from polygon to polygon: the way, and a string pulled taut along it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/geometry/triangulation.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/navmesh.h>
#include <taut/search/detail/taut_string.h>

namespace taut::detail {

/// The polygons of a mesh, as trees of those portals by which alone one can get to the other side (bridges). Immutable.
///
/// Polygons are numbered anew, a parent before its children and each long branch in one run, so that a climb reads
/// memory in order. Between two polygons of one tree the way past their lowest common ancestor is the only one without
/// passing a polygon twice; between two trees of one component there are several.
class Sleeves {
 public:
  /// `tri` is what `mesh` was made of. O(n).
  Sleeves(const Triangulation& tri, const Navmesh& mesh);

  /// A polygon, and the portal to the one above it; its ends as vertices of the triangulation and, where there is a
  /// lattice, on that.
  struct Node {
    std::uint32_t above = kNone;
    std::uint32_t tree = 0;
    std::uint32_t right = 0, left = 0;  ///< as seen when climbing
    std::array<std::int32_t, 2> right_at{}, left_at{};
  };

  std::uint32_t node_of(std::uint32_t polygon) const { return node_of_[polygon]; }
  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }

 private:
  void number(const Navmesh& mesh, const std::vector<std::uint32_t>& above);
  void add_portals(const Triangulation& tri, const Navmesh& mesh);

  std::vector<std::uint32_t> node_of_;  // by polygon
  std::vector<Node> nodes_;
};

/// Vertices of a triangulation and the two ends of a path, compared exactly: on a lattice in int64.
class SleeveSides {
 public:
  /// A vertex, or kFrom or kTo.
  struct Place {
    std::array<std::int32_t, 2> at{};
    std::uint32_t vertex = 0;

    friend bool operator==(const Place& a, const Place& b) { return a.vertex == b.vertex; }
  };
  static constexpr std::uint32_t kFrom = 0x80000000, kTo = 0x80000001;  // what no vertex is

  explicit SleeveSides(const Triangulation& tri) : tri_(&tri), on_lattice_(!tri.lattice.empty()) {}

  void set_ends(Point from, Point to) {
    from_ = from;
    to_ = to;
  }
  Point point(const Place& p) const {
    return p.vertex == kFrom ? from_ : p.vertex == kTo ? to_ : tri_->points[p.vertex];
  }

  /// Precondition: b is a vertex.
  int turn(const Place& a, const Place& b, const Place& p) const {
    if (!on_lattice_ || ((a.vertex | p.vertex) & kFrom) != 0) return written::orientation(point(a), point(b), point(p));
    const std::int64_t left = std::int64_t{b.at[0] - a.at[0]} * (p.at[1] - a.at[1]),
                       right = std::int64_t{b.at[1] - a.at[1]} * (p.at[0] - a.at[0]);
    return (left > right) - (left < right);
  }
  bool is_between(const Place& a, const Place& b, const Place& p) const {
    if (!on_lattice_ || ((a.vertex | p.vertex) & kFrom) != 0) return is_between_as_written(a, b, p);
    const auto within = [&](std::size_t i) {
      return std::min(a.at[i], p.at[i]) <= b.at[i] && b.at[i] <= std::max(a.at[i], p.at[i]);
    };
    return within(0) && within(1);
  }

 private:
  int turn_as_written(const Place& a, const Place& b, const Place& p) const;
  bool is_between_as_written(const Place& a, const Place& b, const Place& p) const;

  const Triangulation* tri_;
  bool on_lattice_;
  Point from_, to_;
};

/// One query after the other in the same memory.
class SleeveString {
 public:
  SleeveString(const Triangulation& tri, const Sleeves& sleeves) : sleeves_(sleeves), string_(SleeveSides(tri)) {}

  /// The shortest path between two points, where all polygons that hold them are in one tree: else false. Of paths
  /// equally long that between the polygons named first.
  bool find(Point from, std::span<const std::uint32_t> starts, Point to, std::span<const std::uint32_t> goals,
            std::vector<Point>& path);

 private:
  using Place = SleeveSides::Place;

  bool are_in_one_tree(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> goals);
  bool lay_out_at_once();
  bool lay_out(std::uint32_t p, std::uint32_t q);
  void pull_taut(std::vector<Point>& path);
  void widen(const Place& right, const Place& left);
  bool is_shorter(const std::vector<Point>& a, const std::vector<Point>& b);

  const Sleeves& sleeves_;
  TautStringOf<SleeveSides> string_;
  std::vector<std::uint32_t> starts_, goals_;  // nodes that hold the ends
  std::vector<std::uint32_t> up_, down_;       // nodes whose portals are passed; down_ from the goal on
  std::uint32_t right_ = 0, left_ = 0;         // vertices of the last portal
  std::vector<Point> other_;
  std::vector<Segment> legs_a_, legs_b_;
};

}  // namespace taut::detail
