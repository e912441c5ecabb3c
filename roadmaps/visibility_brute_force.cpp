#include <taut/roadmaps/visibility_graph.h>

#include <algorithm>
#include <map>
#include <utility>

#include <taut/geometry/contact.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

using Vertex = Roadmap::Vertex;

/// The vertices that share a point, each with the sector of the point's star that it stands for.
struct Corner {
  Star star;
  bool reflex = false;  ///< one of the star's sectors is
  std::vector<std::pair<std::uint32_t, Vertex>> places;
};

/// A point in the direction of the clockwise side of a sector's first triangle: just left of it the sector begins, or
/// goes on.
Point clockwise_side(const Triangulation& mesh, const Triangulation::Sector& sector) {
  const auto& corners = mesh.triangles[sector.triangle];
  const auto i = static_cast<int>(std::find(corners.begin(), corners.end(), sector.vertex) - corners.begin());
  return mesh.points[corners[Triangulation::ccw(i)]];
}

class BruteForce {
 public:
  BruteForce(const FreeSpace& space, VisibilityKind kind) : kind_(kind), constraints_(space.constraints()) {
    const Triangulation& mesh = space.triangulation();
    std::map<Point, std::vector<std::uint32_t>> pieces;
    for (std::uint32_t i = 0; i < constraints_.size(); ++i)
      for (const Point p : {constraints_[i].a, constraints_[i].b}) pieces[p].push_back(i);
    for (const auto& sector : mesh.sectors) {
      if (kind_ == VisibilityKind::full ? sector.full : !sector.reflex) continue;
      const Point p = mesh.points[sector.vertex];
      if (corners_.empty() || corners_.back().star.centre() != p) add_corner(p, pieces[p]);
      corners_.back().places.emplace_back(corners_.back().star.sector_left_of(clockwise_side(mesh, sector)),
                                          static_cast<Vertex>(points_.size()));
      points_.push_back(p);
    }
  }

  Roadmap roadmap() {
    for (std::size_t i = 0; i < corners_.size(); ++i)
      for (std::size_t j = i + 1; j < corners_.size(); ++j)
        if (kind_ == VisibilityKind::full || tangent_between(corners_[i].star, corners_[j].star))
          join(corners_[i], corners_[j]);
    return Roadmap(std::move(points_), edges_);
  }

 private:
  void add_corner(Point p, const std::vector<std::uint32_t>& pieces) {
    Corner corner{Star(p, constraints_, pieces), false, {}};
    for (std::uint32_t s = 0; s < corner.star.sector_count(); ++s)
      corner.reflex |= corner.star.reflex(s) && !corner.star.solid(s);
    corners_.push_back(std::move(corner));
  }

  /// Tangent at both ends, and no corner where a path could bend lies between.
  bool tangent_between(const Star& u, const Star& v) const {
    const Point p = u.centre(), q = v.centre();
    if (!u.tangent(q) || !v.tangent(p)) return false;
    return std::none_of(corners_.begin(), corners_.end(), [&](const Corner& c) {
      const Point w = c.star.centre();
      return c.reflex && w != p && w != q && written::on_segment(w, p, q);
    });
  }

  void join(const Corner& u, const Corner& v) {
    const Segment leg{u.star.centre(), v.star.centre()};
    std::vector<std::uint32_t> touching;
    for (std::uint32_t i = 0; i < constraints_.size(); ++i) {
      const Contact kind = contact(leg, constraints_[i]);
      if (kind == Contact::cross) return;
      if (kind == Contact::touch) touching.push_back(i);
    }
    for (const auto& [start, s] : u.places) {
      const auto passage = pass(leg, {start}, constraints_, touching);
      for (const auto& [end, t] : v.places)
        if (std::binary_search(passage.sectors.begin(), passage.sectors.end(), end)) edges_.emplace_back(s, t);
    }
  }

  VisibilityKind kind_;
  const std::vector<Constraint>& constraints_;
  std::vector<Corner> corners_;
  std::vector<Point> points_;
  std::vector<std::pair<Vertex, Vertex>> edges_;
};

}  // namespace

Roadmap visibility_graph_brute_force(const FreeSpace& space, VisibilityKind kind) {
  return BruteForce(space, kind).roadmap();
}

}  // namespace taut
