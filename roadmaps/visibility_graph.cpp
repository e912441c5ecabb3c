#include <taut/roadmaps/visibility_graph.h>

#include <algorithm>
#include <memory>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/geometry/parallel.h>
#include <taut/geometry/ray_walk.h>
#include <taut/geometry/triangular_expansion.h>

namespace taut {

namespace {

using Tri = Triangulation;
using Vertex = Roadmap::Vertex;

/// What a point or a sector sees, as roadmap vertices.
template <class Coordinates>
class View {
 public:
  using Place = typename Coordinates::Place;

  View(const Tri& tri, VisibilityKind kind, const std::vector<Vertex>& vertex_of_sector, const std::vector<bool>& bends)
      : tri_(tri),
        reduced_(kind == VisibilityKind::reduced),
        vertex_of_sector_(vertex_of_sector),
        bends_(bends),
        expansion_(tri, *this) {}

  /// Appends the vertices that the sector is joined to, ascending, each once.
  void from_sector(std::uint32_t sector, std::vector<Vertex>& row) {
    begin(expansion_.coordinates().at(tri_.sectors[sector].vertex), tri_.points[tri_.sectors[sector].vertex], row);
    origin_sector_ = &tri_.sectors[sector];
    fan(tri_.sectors[sector]);
    finish(vertex_of_sector_[sector]);
  }

  /// Likewise what a point at `at` is joined to; of a vertex those of all its sectors.
  void from_point(Point p, Place place, const Location& at, std::optional<Point> towards, std::vector<Vertex>& row) {
    begin(place, p, row);
    switch (at.kind) {
      case Location::Kind::outside: break;
      case Location::Kind::triangle: around(at.triangle, -1); break;
      case Location::Kind::side: from_side(at, towards); break;
      case Location::Kind::vertex: from_vertex(at, towards); break;
    }
    finish(kNone);
  }

  // What the expansion calls.
  bool hides(std::uint32_t v) const { return !reduced_ || bends_[v]; }
  void blocked(std::uint32_t, int, const auto&, const auto&) {}
  void vertex(std::uint32_t t, int k) {
    const std::uint32_t sector = tri_.sector_of[3 * t + k];
    add(sector);
    if (!reduced_ && lets_pass(tri_.sectors[sector])) behind(sector);
  }

 private:
  using Ray = typename Expansion<Coordinates, View>::Ray;

  void begin(Place place, Point point, std::vector<Vertex>& row) {
    origin_ = place;
    point_ = point;
    row_ = &row;
    first_ = row.size();
    origin_sector_ = nullptr;
  }

  void finish(Vertex self) {
    const auto first = row_->begin() + static_cast<std::ptrdiff_t>(first_);
    std::sort(first, row_->end());
    auto last = std::unique(first, row_->end());
    if (self != kNone) last = std::remove(first, last, self);
    row_->erase(last, row_->end());
  }

  int side(std::uint32_t a, std::uint32_t b) const {
    return Coordinates::side(origin_, expansion_.coordinates().at(a), expansion_.coordinates().at(b));
  }

  void add(std::uint32_t sector) {
    const Vertex v = vertex_of_sector_[sector];
    if (v == kNone || (reduced_ && !tangent_at(tri_.sectors[sector]))) return;
    row_->push_back(v);
  }

  /// Does the line from the origin have the obstacle at the sector's vertex on one side?
  bool tangent_at(const Tri::Sector& s) const { return side(s.vertex, s.right) * side(s.vertex, s.left) >= 0; }

  /// Can a ray that arrives in this sector go straight on in it? Then it spans half a turn at least, and the line does
  /// not leave it.
  bool lets_pass(const Tri::Sector& s) const {
    const int right = side(s.vertex, s.right), left = side(s.vertex, s.left);
    return s.reflex ? right * left >= 0 : right == 0 && left == 0;
  }

  /// The vertices behind one that is seen, on the same ray.
  void behind(std::uint32_t sector) {
    RayWalk walk(tri_, point_, tri_.points[tri_.sectors[sector].vertex], false);
    walk.stand_at({tri_.sectors[sector].vertex, {sector, kNone}});
    while (walk.next() == RayWalk::End::vertex)
      for (const std::uint32_t s : walk.stand().sectors)
        if (s != kNone) add(s);
  }

  /// All that is seen from a triangle that contains the origin, but not out of side `except`.
  void around(std::uint32_t t, int except) {
    for (int i = 0; i < 3; ++i) {
      vertex(t, i);
      if (i == except) continue;
      const std::uint32_t right = tri_.triangles[t][Tri::ccw(i)], left = tri_.triangles[t][Tri::cw(i)];
      expansion_.spread(origin_, t, i, expansion_.ray(right), expansion_.ray(left));
    }
  }

  void from_side(const Location& at, std::optional<Point> towards) {
    const std::uint32_t n = tri_.neighbours[at.triangle][at.index];
    const auto& corners = tri_.triangles[at.triangle];
    const int turn = towards ? written::orientation(tri_.points[corners[Tri::ccw(at.index)]],
                                                    tri_.points[corners[Tri::cw(at.index)]], *towards)
                             : 0;
    if (turn >= 0) around(at.triangle, at.index);
    if (turn <= 0 && n != kNone && tri_.free[n]) around(n, tri_.mirror(at.triangle, at.index));
  }

  void from_vertex(const Location& at, std::optional<Point> towards) {
    for (const Tri::Sector& sector : tri_.sectors_at(tri_.triangles[at.triangle][at.index])) {
      if (towards && !tri_.looks_to(sector, *towards)) continue;
      const Vertex v = vertex_of_sector_[static_cast<std::size_t>(&sector - tri_.sectors.data())];
      if (v != kNone) row_->push_back(v);
      fan(sector);
    }
  }

  void fan(const Tri::Sector& s) {
    each_triangle(tri_, s, [&](std::uint32_t t, int i) { wedge(t, i); });
  }

  /// One triangle at the origin's vertex. Of a reflex sector in a reduced graph only the tangent directions: a path
  /// that bends there does not start strictly between `first` and `second`, the backward continuations of the two
  /// bounding sides.
  void wedge(std::uint32_t t, int i) {
    const std::uint32_t a = tri_.triangles[t][Tri::ccw(i)], b = tri_.triangles[t][Tri::cw(i)];
    const bool all = !reduced_ || !origin_sector_ || origin_sector_->right == origin_sector_->left;
    const bool a_useless = !all && useless(a), b_useless = !all && useless(b);
    if (!a_useless) vertex(t, Tri::ccw(i));
    if (!b_useless) vertex(t, Tri::cw(i));
    if (a_useless && b_useless) return;
    const Ray right = expansion_.ray(a), left = expansion_.ray(b);
    if (all) return expansion_.spread(origin_, t, i, right, left);
    const int a_first = side(a, origin_sector_->left), b_second = side(origin_sector_->right, b);
    const bool between = a_first <= 0 && side(origin_sector_->left, b) < 0;
    if (!a_useless && !b_useless && !between) return expansion_.spread(origin_, t, i, right, left);
    const Ray first = expansion_.ray(origin_sector_->left, true), second = expansion_.ray(origin_sector_->right, true);
    if (!a_useless && a_first != 0) expansion_.spread(origin_, t, i, right, first);
    if (!b_useless && b_second != 0) expansion_.spread(origin_, t, i, second, left);
  }

  /// Would a path along this direction have its obstacle on both sides of the line?
  bool useless(std::uint32_t v) const {
    return side(origin_sector_->left, v) < 0 && side(origin_sector_->right, v) > 0;
  }

  const Tri& tri_;
  bool reduced_;
  const std::vector<Vertex>& vertex_of_sector_;
  const std::vector<bool>& bends_;
  Expansion<Coordinates, View> expansion_;
  Place origin_{};
  Point point_;
  const Tri::Sector* origin_sector_ = nullptr;
  std::vector<Vertex>* row_ = nullptr;
  std::size_t first_ = 0;
};

std::vector<bool> bending_vertices(const Tri& tri) {
  std::vector<bool> bends(tri.points.size(), false);
  for (const Tri::Sector& s : tri.sectors)
    if (s.reflex) bends[s.vertex] = true;
  return bends;
}

/// Rows of consecutive vertices, as compressed rows: where each ends, and what they hold.
struct Rows {
  std::vector<std::uint64_t> ends;
  std::vector<Vertex> targets;

  void append(const Rows& more) {
    for (const std::uint64_t end : more.ends) ends.push_back(targets.size() + end);
    targets.insert(targets.end(), more.targets.begin(), more.targets.end());
  }
};

/// All in one piece when one thread does them all.
template <class Coordinates>
Rows all_rows(const Tri& tri, VisibilityKind kind, const std::vector<std::uint32_t>& sectors,
              const std::vector<Vertex>& vertex_of_sector, const std::vector<bool>& bends, unsigned jobs) {
  const std::size_t length = block_length(sectors.size(), jobs, 32);
  std::vector<Rows> blocks((sectors.size() + length - 1) / length);
  each_in_parallel(blocks.size(), {jobs}, [&] {
    auto view = std::make_shared<View<Coordinates>>(tri, kind, vertex_of_sector, bends);
    return [&, view](std::size_t block) {
      const std::size_t first = block * length, last = std::min(sectors.size(), first + length);
      Rows rows;
      rows.ends.reserve(last - first);
      for (std::size_t i = first; i < last; ++i) {
        view->from_sector(sectors[i], rows.targets);
        rows.ends.push_back(rows.targets.size());
      }
      blocks[block] = std::move(rows);
    };
  });
  if (blocks.empty()) return {};
  Rows all = std::move(blocks.front());
  for (std::size_t block = 1; block < blocks.size(); ++block) all.append(std::exchange(blocks[block], {}));
  return all;
}

template <class Coordinates>
Roadmap build(const Tri& tri, VisibilityKind kind, const std::vector<std::uint32_t>& sectors,
              const std::vector<Vertex>& vertex_of_sector, const std::vector<bool>& bends, unsigned jobs) {
  Rows rows = all_rows<Coordinates>(tri, kind, sectors, vertex_of_sector, bends, jobs);
  std::vector<Point> points;
  points.reserve(sectors.size());
  for (const std::uint32_t sector : sectors) points.push_back(tri.points[tri.sectors[sector].vertex]);
  rows.ends.insert(rows.ends.begin(), 0);
  return Roadmap(std::move(points), std::move(rows.ends), std::move(rows.targets));
}

}  // namespace

VisibilityGraph::VisibilityGraph(FreeSpace space, VisibilityKind kind, unsigned jobs)
    : space_(std::move(space)), kind_(kind), bends_(bending_vertices(space_.triangulation())) {
  number_sectors();
  const Tri& tri = space_.triangulation();
  roadmap_ = tri.lattice.empty() ? build<DoubleCoordinates>(tri, kind, sectors_, vertex_of_sector_, bends_, jobs)
                                 : build<LatticeCoordinates>(tri, kind, sectors_, vertex_of_sector_, bends_, jobs);
}

VisibilityGraph::VisibilityGraph(FreeSpace space, VisibilityKind kind, Roadmap roadmap)
    : space_(std::move(space)), kind_(kind), bends_(bending_vertices(space_.triangulation())) {
  number_sectors();
  const Tri& tri = space_.triangulation();
  const auto lies_at = [&](std::uint32_t sector, Point p) { return tri.points[tri.sectors[sector].vertex] == p; };
  if (!std::equal(sectors_.begin(), sectors_.end(), roadmap.points().begin(), roadmap.points().end(), lies_at))
    throw InputError(space_.world().source(), 0, "the roadmap's vertices are not the corners of this world");
  roadmap_ = std::move(roadmap);
}

void VisibilityGraph::number_sectors() {
  const Tri& tri = space_.triangulation();
  vertex_of_sector_.assign(tri.sectors.size(), kNone);
  for (std::uint32_t s = 0; s < tri.sectors.size(); ++s) {
    if (tri.sectors[s].full || (kind_ == VisibilityKind::reduced && !tri.sectors[s].reflex)) continue;
    vertex_of_sector_[s] = static_cast<Vertex>(sectors_.size());
    sectors_.push_back(s);
  }
}

std::vector<Vertex> VisibilityGraph::visible_from(Point p, std::optional<Point> towards) const {
  const Tri& tri = space_.triangulation();
  View<DoubleCoordinates> view(tri, kind_, vertex_of_sector_, bends_);
  std::vector<Vertex> row;
  const Location at = space_.locate(p);
  TAUT_EXPECTS(at.kind != Location::Kind::outside);
  view.from_point(p, p, at, towards, row);
  return row;
}

}  // namespace taut
