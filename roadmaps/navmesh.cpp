#include <taut/roadmaps/navmesh.h>

#include <bit>
#include <numeric>
#include <utility>

#include <taut/geometry/written.h>
#include <taut/roadmaps/detail/navmesh_bends.h>
#include <taut/roadmaps/detail/navmesh_blocks.h>
#include <taut/roadmaps/detail/navmesh_triangles.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// The sides of the chosen triangles as rings, and what is left of them when sides are taken out. Side 3 k + i lies
/// opposite to corner i of the k-th of them.
class Merging {
 public:
  Merging(const Tri& tri, std::vector<std::uint32_t> chosen)
      : tri_(tri),
        chosen_(std::move(chosen)),
        place_(tri.triangles.size(), kNone),
        sides_(3 * chosen_.size()),
        leader_(chosen_.size()) {
    for (std::uint32_t k = 0; k < chosen_.size(); ++k) place_[chosen_[k]] = k;
    for (std::uint32_t k = 0; k < chosen_.size(); ++k)
      for (int i = 0; i < 3; ++i)
        sides_[3 * k + i] = {3 * k + Tri::ccw(i), 3 * k + Tri::cw(i), across(k, i),
                             tri_.triangles[chosen_[k]][Tri::ccw(i)]};
    std::iota(leader_.begin(), leader_.end(), 0);
  }

  /// Takes sides out, the longest first (to an eighth of their squared length), as long as all angles stay convex.
  void merge() {
    for (const std::uint32_t s : portals_by_length())
      if (stays_convex(s) && stays_convex(sides_[s].across)) take_out(s);
  }

  Navmesh mesh() {
    Navmesh mesh;
    mesh.polygon_of.assign(tri_.triangles.size(), kNone);
    bend_of_.assign(tri_.sectors.size(), kNone);
    corner_of_.assign(sides_.size(), kNone);
    std::vector<std::uint32_t> polygon_of_leader(chosen_.size(), kNone);
    for (std::uint32_t s = 0; s < sides_.size(); ++s) {
      if (sides_[s].next == kNone || corner_of_[s] != kNone) continue;
      polygon_of_leader[leader(s / 3)] = static_cast<std::uint32_t>(mesh.first.size());
      add_polygon(mesh, s);
    }
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    for (std::uint32_t k = 0; k < chosen_.size(); ++k) mesh.polygon_of[chosen_[k]] = polygon_of_leader[leader(k)];
    for (std::uint32_t s = 0; s < sides_.size(); ++s)
      if (corner_of_[s] != kNone && sides_[s].across != kNone)
        mesh.corners[corner_of_[s]].across = corner_of_[sides_[s].across];
    detail::bound_bends(mesh);
    detail::find_blocks(mesh);
    return mesh;
  }

 private:
  struct Side {
    std::uint32_t next, previous;  // in the ring; next is kNone when it is taken out
    std::uint32_t across;          // the same side the other way round, when it is a portal between chosen triangles
    std::uint32_t origin;          // the vertex that it begins at
  };

  std::uint32_t across(std::uint32_t k, int i) const {
    const std::uint32_t t = chosen_[k], n = tri_.neighbours[t][i];
    if (n == kNone || tri_.is_constrained(t, i) || place_[n] == kNone) return kNone;
    return 3 * place_[n] + static_cast<std::uint32_t>(tri_.mirror(t, i));
  }

  Point origin(std::uint32_t s) const { return tri_.points[sides_[s].origin]; }

  /// Each portal once, the longest first, by a counting sort of the leading bits of squared lengths.
  std::vector<std::uint32_t> portals_by_length() const {
    constexpr int kDropped = 20;
    std::vector<std::uint32_t> first((0x7f800000U >> kDropped) + 2), keys;
    const auto key = [&](std::uint32_t s) {
      const Point a = origin(s), b = origin(sides_[s].next);
      const double x = a.x - b.x, y = a.y - b.y;
      return (0x7f800000U - std::bit_cast<std::uint32_t>(static_cast<float>(x * x + y * y))) >> kDropped;
    };
    keys.reserve(sides_.size());
    for (std::uint32_t s = 0; s < sides_.size(); ++s) {
      if (sides_[s].across == kNone || sides_[s].across < s) continue;
      keys.push_back(key(s));
      ++first[keys.back() + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> sorted(keys.size());
    for (std::uint32_t s = 0, n = 0; s < sides_.size(); ++s)
      if (sides_[s].across != kNone && sides_[s].across > s) sorted[first[keys[n++]]++] = s;
    return sorted;
  }

  /// Is the angle at the origin of this side convex without the side?
  bool stays_convex(std::uint32_t s) const {
    const std::uint32_t before = sides_[sides_[s].previous].origin,
                        after = sides_[sides_[sides_[sides_[s].across].next].next].origin;
    return before != after && written::orientation(tri_.points[before], origin(s), tri_.points[after]) >= 0;
  }

  void take_out(std::uint32_t s) {
    const std::uint32_t t = sides_[s].across;
    join(sides_[s].previous, sides_[t].next);
    join(sides_[t].previous, sides_[s].next);
    leader_[leader(s / 3)] = leader(t / 3);
    sides_[s].next = sides_[t].next = kNone;
  }

  void join(std::uint32_t s, std::uint32_t t) {
    sides_[s].next = t;
    sides_[t].previous = s;
  }

  std::uint32_t leader(std::uint32_t k) {
    while (leader_[k] != k) k = leader_[k] = leader_[leader_[k]];
    return k;
  }

  void add_polygon(Navmesh& mesh, std::uint32_t first_side) {
    const std::uint32_t polygon = static_cast<std::uint32_t>(mesh.first.size());
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    std::uint32_t s = first_side;
    do {
      corner_of_[s] = static_cast<std::uint32_t>(mesh.corners.size());
      mesh.corners.push_back({origin(s), kNone, polygon, bend_at(mesh, s), kNone});
      s = sides_[s].next;
    } while (s != first_side);
  }

  /// The bend at the origin of a side; numbered as they are met.
  std::uint32_t bend_at(Navmesh& mesh, std::uint32_t s) {
    const std::uint32_t at =
        tri_.sector_of[3 * chosen_[s / 3] + static_cast<std::uint32_t>(Tri::ccw(static_cast<int>(s % 3)))];
    const Tri::Sector& sector = tri_.sectors[at];
    if (!sector.reflex || sector.full) return kNone;
    if (bend_of_[at] == kNone) {
      bend_of_[at] = static_cast<std::uint32_t>(mesh.bends.size());
      mesh.bends.push_back({tri_.points[sector.right], tri_.points[sector.left], kNone, kNone, at});
    }
    return bend_of_[at];
  }

  const Tri& tri_;
  std::vector<std::uint32_t> chosen_;
  std::vector<std::uint32_t> place_;  // of a triangle among the chosen
  std::vector<Side> sides_;
  std::vector<std::uint32_t> leader_, bend_of_, corner_of_;
};

Navmesh merged(const Tri& tri, std::vector<std::uint32_t> chosen) {
  Merging merging(tri, std::move(chosen));
  merging.merge();
  return merging.mesh();
}

}  // namespace

Navmesh navmesh(const FreeSpace& space) {
  return merged(space.triangulation(), detail::free_triangles(space.triangulation()));
}

Navmesh triangle_navmesh(const FreeSpace& space) {
  return Merging(space.triangulation(), detail::free_triangles(space.triangulation())).mesh();
}

Navmesh navmesh_between(const FreeSpace& space, Point from, const Goal& to) {
  std::vector<Box> ends{{from, from}};
  if (to.point) ends.push_back({*to.point, *to.point});
  ends.insert(ends.end(), to.room.begin(), to.room.end());
  return merged(space.triangulation(), detail::triangles_between(space.triangulation(), ends));
}

}  // namespace taut
