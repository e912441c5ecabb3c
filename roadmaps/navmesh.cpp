#include <taut/roadmaps/navmesh.h>

#include <algorithm>
#include <numeric>

#include <taut/geometry/predicates.h>
#include <taut/roadmaps/detail/navmesh_blocks.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// The sides of the free triangles as rings, and what is left of them when sides are taken out. Side 3 t + i lies opposite to corner i of triangle t.
class Merging {
 public:
  explicit Merging(const Tri& tri)
      : tri_(tri), next_(3 * tri.triangles.size()), previous_(3 * tri.triangles.size()), leader_(tri.triangles.size()) {
    for (std::uint32_t s = 0; s < next_.size(); ++s) {
      const std::uint32_t t = s / 3;
      next_[s] = 3 * t + static_cast<std::uint32_t>(Tri::ccw(static_cast<int>(s % 3)));
      previous_[s] = 3 * t + static_cast<std::uint32_t>(Tri::cw(static_cast<int>(s % 3)));
    }
    std::iota(leader_.begin(), leader_.end(), 0);
  }

  /// Takes sides out, the longest first, as long as all angles stay convex.
  void merge() {
    struct Candidate {
      double square;
      std::uint32_t side;
    };
    std::vector<Candidate> candidates;
    for (std::uint32_t s = 0; s < next_.size(); ++s) {
      if (!is_portal(s) || across(s) < s) continue;
      const Point a = tri_.points[origin(s)], b = tri_.points[origin(next_[s])];
      candidates.push_back({(a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y), s});
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.square != b.square ? a.square > b.square : a.side < b.side;
    });
    for (const Candidate& c : candidates)
      if (stays_convex(c.side) && stays_convex(across(c.side))) take_out(c.side);
  }

  Navmesh mesh() {
    Navmesh mesh;
    number_bends(mesh);
    mesh.polygon_of.assign(tri_.triangles.size(), kNone);
    corner_of_.assign(next_.size(), kNone);
    std::vector<std::uint32_t> polygon_of_leader(tri_.triangles.size(), kNone);
    for (std::uint32_t s = 0; s < next_.size(); ++s) {
      if (!tri_.free[s / 3] || next_[s] == kNone || corner_of_[s] != kNone) continue;
      polygon_of_leader[leader(s / 3)] = static_cast<std::uint32_t>(mesh.first.size());
      add_polygon(mesh, s);
    }
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t)
      if (tri_.free[t]) mesh.polygon_of[t] = polygon_of_leader[leader(t)];
    for (std::uint32_t s = 0; s < next_.size(); ++s)
      if (corner_of_[s] != kNone && is_portal(s)) mesh.corners[corner_of_[s]].across = corner_of_[across(s)];
    bound_bends(mesh);
    detail::find_blocks(mesh);
    return mesh;
  }

 private:
  std::uint32_t origin(std::uint32_t s) const { return tri_.triangles[s / 3][Tri::ccw(static_cast<int>(s % 3))]; }
  std::uint32_t across(std::uint32_t s) const {
    const int i = static_cast<int>(s % 3);
    return 3 * tri_.neighbours[s / 3][i] + static_cast<std::uint32_t>(tri_.mirror(s / 3, i));
  }
  bool is_portal(std::uint32_t s) const {
    const int i = static_cast<int>(s % 3);
    return tri_.free[s / 3] && !tri_.is_constrained(s / 3, i) && tri_.neighbours[s / 3][i] != kNone;
  }

  /// Is the angle at the origin of this side convex without the side?
  bool stays_convex(std::uint32_t s) const {
    const std::uint32_t before = origin(previous_[s]), after = origin(next_[next_[across(s)]]);
    return before != after && orientation(tri_.points[before], tri_.points[origin(s)], tri_.points[after]) >= 0;
  }

  void take_out(std::uint32_t s) {
    const std::uint32_t t = across(s);
    join(previous_[s], next_[t]);
    join(previous_[t], next_[s]);
    leader_[leader(s / 3)] = leader(t / 3);
    next_[s] = next_[t] = kNone;
  }

  void join(std::uint32_t s, std::uint32_t t) {
    next_[s] = t;
    previous_[t] = s;
  }

  std::uint32_t leader(std::uint32_t t) {
    while (leader_[t] != t) t = leader_[t] = leader_[leader_[t]];
    return t;
  }

  void number_bends(Navmesh& mesh) {
    bend_of_.assign(tri_.sectors.size(), kNone);
    for (std::uint32_t s = 0; s < tri_.sectors.size(); ++s) {
      const Tri::Sector& sector = tri_.sectors[s];
      if (!sector.reflex || sector.full) continue;
      bend_of_[s] = static_cast<std::uint32_t>(mesh.bends.size());
      mesh.bends.push_back({tri_.points[sector.right], tri_.points[sector.left], kNone, kNone, s});
    }
  }

  void add_polygon(Navmesh& mesh, std::uint32_t first_side) {
    const std::uint32_t polygon = static_cast<std::uint32_t>(mesh.first.size());
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    std::uint32_t s = first_side;
    do {
      corner_of_[s] = static_cast<std::uint32_t>(mesh.corners.size());
      const std::uint32_t sector =
          tri_.sector_of[3 * (s / 3) + static_cast<std::uint32_t>(Tri::ccw(static_cast<int>(s % 3)))];
      mesh.corners.push_back({tri_.points[origin(s)], kNone, polygon, bend_of_[sector], kNone});
      s = next_[s];
    } while (s != first_side);
  }

  static void bound_bends(Navmesh& mesh) {
    for (std::uint32_t c = 0; c < mesh.corners.size(); ++c) {
      const std::uint32_t bend = mesh.corners[c].bend;
      if (bend == kNone) continue;
      if (mesh.corners[c].across == kNone) mesh.bends[bend].right_corner = c;
      if (mesh.corners[mesh.previous(c)].across == kNone) mesh.bends[bend].left_corner = c;
    }
  }

  const Tri& tri_;
  std::vector<std::uint32_t> next_, previous_, leader_, bend_of_, corner_of_;
};

}  // namespace

Navmesh navmesh(const FreeSpace& space) {
  Merging merging(space.triangulation());
  merging.merge();
  return merging.mesh();
}

Navmesh triangle_navmesh(const FreeSpace& space) { return Merging(space.triangulation()).mesh(); }

}  // namespace taut
