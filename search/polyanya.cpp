#include <taut/search/polyanya.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <taut/geometry/expects.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/cell_navmesh.h>
#include <taut/search/detail/bend_search.h>
#include <taut/search/detail/landmarks.h>
#include <taut/search/detail/polyanya_engine.h>
#include <taut/search/detail/room_entries.h>
#include <taut/search/detail/sleeves.h>
#include <taut/search/query_ends.h>

namespace taut {

namespace {

/// The polygons that hold a place. `towards`: see FreeSpace::sees.
class PolygonsAt {
 public:
  PolygonsAt(const FreeSpace& space, const Navmesh& mesh) : tri_(space.triangulation()), mesh_(mesh) {}

  void operator()(Point p, const Location& at, std::optional<Point> towards, std::vector<std::uint32_t>& out) const {
    out.clear();
    switch (at.kind) {
      case Location::Kind::outside: return;
      case Location::Kind::triangle: in_triangle(p, at, out); break;
      case Location::Kind::side: on_side(at, towards, out); break;
      case Location::Kind::vertex: at_vertex(at, towards, out); break;
    }
    if (out.size() < 2) return;
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
  }

 private:
  /// And the neighbour, when p lies on a portal: that is a side of the triangle then.
  void in_triangle(Point p, const Location& at, std::vector<std::uint32_t>& out) const {
    const std::uint32_t polygon = mesh_.polygon_of[at.triangle];
    const auto& corners = tri_.triangles[at.triangle];
    out.push_back(polygon);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t n = tri_.neighbours[at.triangle][i];
      if (n == kNone || tri_.is_constrained(at.triangle, i)) continue;
      const std::uint32_t across = mesh_.polygon_of[n];
      if (across != kNone && across != polygon &&
          written::on_segment(p, tri_.points[corners[Triangulation::ccw(i)]],
                              tri_.points[corners[Triangulation::cw(i)]]))
        out.push_back(across);
    }
  }

  void on_side(const Location& at, std::optional<Point> towards, std::vector<std::uint32_t>& out) const {
    const auto& corners = tri_.triangles[at.triangle];
    const int turn = towards ? written::orientation(tri_.points[corners[Triangulation::ccw(at.index)]],
                                                    tri_.points[corners[Triangulation::cw(at.index)]], *towards)
                             : 0;
    const std::uint32_t n = tri_.neighbours[at.triangle][at.index];
    if (turn >= 0) out.push_back(mesh_.polygon_of[at.triangle]);
    if (turn <= 0 && n != kNone && tri_.free[n]) out.push_back(mesh_.polygon_of[n]);
  }

  void at_vertex(const Location& at, std::optional<Point> towards, std::vector<std::uint32_t>& out) const {
    for (const Triangulation::Sector& sector : tri_.sectors_at(tri_.triangles[at.triangle][at.index]))
      if (!towards || tri_.looks_to(sector, *towards))
        each_triangle(tri_, sector, [&](std::uint32_t t, int) { out.push_back(mesh_.polygon_of[t]); });
  }

  const Triangulation& tri_;
  const Navmesh& mesh_;
};

}  // namespace

Polyanya::Polyanya(FreeSpace space)
    : space_(std::move(space)),
      mesh_(std::make_shared<const Navmesh>(navmesh(space_))),
      sleeves_(std::make_shared<const detail::Sleeves>(space_.triangulation(), *mesh_)) {}

Polyanya::Polyanya(FreeSpace space, Navmesh mesh)
    : space_(std::move(space)), mesh_(std::make_shared<const Navmesh>(std::move(mesh))) {}

Polyanya::Polyanya(FreeSpace space, CellNavmesh mesh)
    : space_(std::move(space)),
      mesh_(std::make_shared<const Navmesh>(std::move(mesh.mesh))),
      cells_(std::make_shared<const CellPolygons>(std::move(mesh.polygons))) {}

Polyanya Polyanya::between(const FreeSpace& space, Point from, const Goal& to) {
  if (const CellPlan* plan = space.cells()) return {space, cell_navmesh_between(*plan, from, to)};
  return {space, navmesh_between(space, from, to)};
}

Polyanya Polyanya::with_landmarks(std::size_t count) const {
  Polyanya made = *this;
  made.landmarks_ = std::make_shared<const detail::Landmarks>(space_, *mesh_, count);
  return made;
}

Polyanya Polyanya::with_graph(unsigned jobs) const {
  TAUT_EXPECTS(!cells_);
  Polyanya made = *this;
  made.bends_ = std::make_shared<const detail::BendGraph>(space_, *mesh_, jobs);
  return made;
}

struct PolyanyaSearch::Impl {
  explicit Impl(Polyanya what)
      : polyanya(std::move(what)), space(polyanya.space()), engine(polyanya.mesh(), polyanya.landmarks_.get()) {
    if (!polyanya.cells_) polygons_at.emplace(space, polyanya.mesh());
    if (polyanya.sleeves_) sleeve.emplace(space.triangulation(), *polyanya.sleeves_);
    if (polyanya.bends_) bends.emplace(*polyanya.bends_, polyanya.mesh(), polyanya.landmarks_.get());
  }

  SearchStatus find_point(Point from, Point to, const SearchLimits& limits) {
    way = Way::none;
    const bool is_limited = limits.expansions <= polyanya.mesh().polygon_count() || limits.seconds < 1e9;
    if (!is_limited && sleeve && sleeve->find(from, starts, to, goals[0].polygons, points))
      way = Way::sleeve;
    else if (!is_limited && bends && !are_apart(from, to) && bends->find(from, to, goals[0].polygons, points))
      way = Way::bends;
    else
      return search_for(from, true, limits);
    length = 0;
    goal = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double dx = points[i].x - points[i - 1].x, dy = points[i].y - points[i - 1].y;
      length += std::sqrt(dx * dx + dy * dy);
    }
    return status = SearchStatus::found;
  }

  /// Then there is nothing to search, and the engine knows it at once.
  bool are_apart(Point from, Point to) const {
    const Location p = space.locate(from), q = space.locate(to);
    return p.kind == Location::Kind::triangle && q.kind == Location::Kind::triangle &&
           space.component(p.triangle) != space.component(q.triangle);
  }

  SearchStatus search_for(Point from, bool nearest, const SearchLimits& limits) {
    return search(from, nearest, false, limits, [](Point, std::uint32_t) {});
  }

  template <typename OnRoot>
  SearchStatus search(Point from, bool nearest, bool other_ends, const SearchLimits& limits, OnRoot&& on_root) {
    way = Way::none;
    status = engine.run({from, starts, std::span(goals).first(goal_count), nearest, other_ends, limits}, on_root);
    points.clear();
    length = std::numeric_limits<double>::infinity();
    if (nearest && engine.way().exists()) {
      engine.points(engine.way(), points);
      length = engine.way().length;
      goal = engine.way().goal;
    }
    return status;
  }

  /// The polygons that hold a place; with a role it has to be one.
  void place(Point p, const char* role, std::optional<Point> towards, std::vector<std::uint32_t>& polygons) const {
    if (polygons_at) {
      const Location at = space.locate(p);
      if (role && at.kind == Location::Kind::outside) require_free(space, p, role);
      (*polygons_at)(p, at, towards, polygons);
    } else {
      if (role && !space.holds(p)) require_free(space, p, role);
      polyanya.cells_->around(*space.cells(), p, towards, polygons);
    }
  }

  void place_start(Point from) {
    place(from, "start", std::nullopt, starts);
    goal_count = 0;
  }

  void add_goal(Point p, const char* role = nullptr, std::optional<Point> towards = std::nullopt) {
    if (goal_count == goals.size()) goals.emplace_back();
    detail::MeshGoal& goal_place = goals[goal_count++];
    goal_place.point = p;
    place(p, role, towards, goal_place.polygons);
  }

  SearchStatus find_room(Point from, const std::vector<Box>& room, const SearchLimits& limits) {
    place_start(from);
    for (const detail::RoomEntry& entry : detail::room_entries(space, room))
      add_goal(entry.point, nullptr, entry.inside);
    const std::vector<detail::RoomSide> sides = detail::room_sides(room);
    return search(from, true, true, limits, [&](Point p, std::uint32_t root) {
      for (const detail::RoomSide& side : sides) {
        const auto foot = side.foot(p);
        if (!foot || !engine.may_improve(root, std::max(std::abs(foot->x - p.x), std::abs(foot->y - p.y)))) continue;
        // The last leg begins in the sector that the path turns in, and ends where the room is: where walls stand in a
        // room a foot can be seen on their wrong side.
        if (space.holds(*foot) && space.sees(*foot, p, side.inside) && space.sees(p, *foot, engine.beyond(root)))
          engine.add_way(root, *foot);
      }
    });
  }

  Polyanya polyanya;
  const FreeSpace& space;
  detail::PolyanyaEngine engine;
  std::optional<PolygonsAt> polygons_at;  // of triangles

  std::vector<std::uint32_t> starts;
  std::vector<detail::MeshGoal> goals;  // the first goal_count; the others keep their memory
  std::size_t goal_count = 0;

  SearchStatus status = SearchStatus::none;
  std::vector<Point> points;
  double length = std::numeric_limits<double>::infinity();
  std::size_t goal = 0;
  std::optional<detail::SleeveString> sleeve;
  std::optional<detail::BendSearch> bends;
  enum class Way : std::uint8_t { none, sleeve, bends } way = Way::none;  // what found the path instead of the engine
};

PolyanyaSearch::PolyanyaSearch(Polyanya polyanya) : impl_(std::make_unique<Impl>(std::move(polyanya))) {}
PolyanyaSearch::PolyanyaSearch(PolyanyaSearch&&) noexcept = default;
PolyanyaSearch& PolyanyaSearch::operator=(PolyanyaSearch&&) noexcept = default;
PolyanyaSearch::~PolyanyaSearch() = default;

SearchStatus PolyanyaSearch::find(Point from, Point to, const SearchLimits& limits) {
  impl_->place_start(from);
  impl_->add_goal(to, "goal");
  return impl_->find_point(from, to, limits);
}

SearchStatus PolyanyaSearch::find(Point from, const Goal& to, const SearchLimits& limits) {
  if (to.point) return find(from, *to.point, limits);
  if (const auto here = detail::answer_at_start(impl_->space, from, to)) {
    impl_->place_start(from);
    impl_->add_goal(from);
    return impl_->search_for(from, true, {});
  }
  return impl_->find_room(from, to.room, limits);
}

SearchStatus PolyanyaSearch::find_nearest(Point from, std::span<const Point> goals, const SearchLimits& limits) {
  impl_->place_start(from);
  for (const Point p : goals) impl_->add_goal(p);
  return impl_->search_for(from, true, limits);
}

const std::vector<Point>& PolyanyaSearch::points() const { return impl_->points; }
double PolyanyaSearch::length() const { return impl_->length; }
std::size_t PolyanyaSearch::goal() const { return impl_->goal; }
std::size_t PolyanyaSearch::expanded() const {
  using Way = Impl::Way;
  return impl_->way == Way::sleeve ? 1 : impl_->way == Way::bends ? impl_->bends->expanded() : impl_->engine.expanded();
}
std::size_t PolyanyaSearch::generated() const {
  using Way = Impl::Way;
  return impl_->way == Way::sleeve  ? 1
         : impl_->way == Way::bends ? impl_->bends->generated()
                                    : impl_->engine.generated();
}

GraphSearchResult PolyanyaSearch::result() const {
  GraphSearchResult result;
  result.status = impl_->status;
  result.path.points = impl_->points;
  if (!impl_->points.empty()) result.path.length = Length(impl_->points);
  result.goal = impl_->goal;
  result.expanded = expanded();
  result.generated = generated();
  return result;
}

std::vector<std::optional<Path>> PolyanyaSearch::find_each(Point from, std::span<const Point> goals) {
  impl_->place_start(from);
  for (const Point p : goals) impl_->add_goal(p);
  impl_->search_for(from, false, {});
  std::vector<std::optional<Path>> paths(goals.size());
  for (std::size_t i = 0; i < goals.size(); ++i) {
    if (!impl_->engine.way(i).exists()) continue;
    Path path;
    impl_->engine.points(impl_->engine.way(i), path.points);
    path.length = Length(path.points);
    paths[i] = std::move(path);
  }
  return paths;
}

GraphSearchResult shortest_path(const Polyanya& polyanya, Point from, const Goal& to, const SearchLimits& limits) {
  PolyanyaSearch search(polyanya);
  search.find(from, to, limits);
  return search.result();
}

}  // namespace taut
