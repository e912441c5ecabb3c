#include <taut/search/changing_world.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <taut/geometry/box.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/written.h>
#include <taut/geometry/written_places.h>
#include <taut/search/detail/changing_cells.h>
#include <taut/search/detail/wall_shelf.h>
#include <taut/search/polyanya.h>
#include <taut/search/query_ends.h>

namespace taut {

namespace {

using detail::ChangingCells;
using detail::WallShelf;

/// A space and what searches in it.
struct Prepared {
  explicit Prepared(FreeSpace of) : space(std::move(of)), places(space), cones(Polyanya(space)) {}
  explicit Prepared(const Index& of) : space(of.space()), places(space), index(IndexSearch(of)) {}

  SearchStatus find(Point from, Point to) { return index ? index->find(from, to) : cones->find(from, to); }
  const std::vector<Point>& points() const { return index ? index->points() : cones->points(); }
  /// Whether it knows the end where it was written.
  bool has(Point end) const { return !places.is_moved(end); }

  FreeSpace space;
  WrittenPlaces places;
  std::optional<IndexSearch> index;
  std::optional<PolyanyaSearch> cones;
};

}  // namespace

struct ChangingWorld::Impl {
  explicit Impl(const FreeSpace& first) : origin(first), parts(first.world().parts()), footprint(first.footprint()) {
    const World& world = origin.world();
    parts.areas = world.areas();
    parts.boundary = world.boundary();
    parts.grid = nullptr;
    for (const Wall& wall : parts.walls) known.add(wall);
    parts.walls.clear();
    box = {parts.areas[0].polygon.outer[0], parts.areas[0].polygon.outer[0]};
    for (const Area& area : parts.areas)
      for (const Point p : area.polygon.outer) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
      }
    if (origin.cells()) cells.emplace(*origin.cells());
    may_have_cells = cells.has_value();
  }

  /// By an added wall: all are thin, and the robot is a point.
  bool is_touched(const std::vector<Point>& path) const {
    bool touched = false;
    added.each([&](const Wall& wall) {
      for (std::size_t i = 0; i + 1 < path.size() && !touched; ++i)
        touched = written::segments_meet({path[i], path[i + 1]}, {wall.a, wall.b});
      touched |= path.size() == 1 && written::on_segment(path[0], wall.a, wall.b);
    });
    return touched;
  }

  World world() const {
    WorldParts all = parts;
    known.append_to(all.walls);
    added.append_to(all.walls);
    return World(std::move(all));
  }

  Prepared& prepared() {
    if (now) return *now;
    if (base && added.empty()) return *base;
    ++rebuilds;
    now.emplace(FreeSpace(world(), footprint));
    return *now;
  }

  /// Those that follow every change, made again once nothing stands in their way.
  ChangingCells* cells_now() {
    if (!cells && may_have_cells && known.sloped() + added.sloped() + known.thick() + added.thick() == 0) {
      if (auto plan = CellPlan::of(world()))
        cells.emplace(*std::move(plan));
      else
        may_have_cells = false;
    }
    return cells ? &*cells : nullptr;
  }

  void changed(const Segment& stretch, bool fits_cells) {
    now.reset();
    if (cells && !(fits_cells && cells->change(stretch, {&known, &added}))) cells.reset();
  }

  /// An index stays for what it can still answer; other parts are no better than newer ones.
  void settle() {
    if (!now || (base && base->index)) return;
    base = std::move(now);
    now.reset();
    added.each([&](const Wall& wall) { known.add(wall); });
    added = {};
  }

  SearchStatus take(SearchStatus status, const std::vector<Point>& found) {
    if (&found != &points) points = found;
    length = status == SearchStatus::found ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i)
      length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    return status;
  }

  SearchStatus find(Point from, Point to) {
    const bool is_thin = added.empty() || (footprint.kind() == Footprint::Kind::point && added.thick() == 0);
    if (base && is_thin && base->has(from) && base->has(to)) {
      const SearchStatus status = base->find(from, to);
      if (added.empty() || status != SearchStatus::found || !is_touched(base->points()))
        return take(status, base->points());
    }
    if (ChangingCells* const among = cells_now()) {
      if (!among->holds(from)) require_free(origin, from, "start");
      if (!among->holds(to)) require_free(origin, to, "goal");
      return take(among->find(from, to, points), points);
    }
    Prepared& current = prepared();
    if (current.has(from) && current.has(to)) {
      const SearchStatus status = current.find(from, to);
      take(status, current.points());
      settle();
      return status;
    }
    const Point ends[] = {from, to};
    Prepared own(FreeSpace(world(), footprint, ends));
    return take(own.find(from, to), own.points());
  }

  FreeSpace origin;                    // as it was at the beginning
  std::optional<Prepared> base;        // of what is known, while nothing of it was taken away
  std::optional<Prepared> now;         // of all
  std::optional<ChangingCells> cells;  // of all
  bool may_have_cells = false;
  WorldParts parts;  // without walls
  WallShelf known, added;
  Footprint footprint;
  Box box;
  std::size_t rebuilds = 0;
  std::vector<Point> points;
  double length = std::numeric_limits<double>::infinity();
};

ChangingWorld::ChangingWorld(FreeSpace space) : impl_(std::make_unique<Impl>(space)) {
  if (!impl_->cells) impl_->base.emplace(std::move(space));
}
ChangingWorld::ChangingWorld(Index index) : impl_(std::make_unique<Impl>(index.space())) { impl_->base.emplace(index); }
ChangingWorld::ChangingWorld(ChangingWorld&&) noexcept = default;
ChangingWorld& ChangingWorld::operator=(ChangingWorld&&) noexcept = default;
ChangingWorld::~ChangingWorld() = default;

void ChangingWorld::add(const Wall& wall) {
  for (const Point p : {wall.a, wall.b})
    if (!impl_->box.contains(p))
      throw InputError(impl_->parts.source, 0, fmt::format("the wall's end ({}, {}) lies outside the world", p.x, p.y));
  if (!(wall.thickness >= 0 && wall.thickness <= World::kLargest))
    throw InputError(impl_->parts.source, 0, fmt::format("the wall's thickness {} is none", wall.thickness));
  impl_->added.add(wall);
  impl_->changed({wall.a, wall.b}, wall.thickness == 0 && (wall.a.x == wall.b.x || wall.a.y == wall.b.y));
}

bool ChangingWorld::remove(const Segment& stretch) {
  if (stretch.a == stretch.b) return false;
  const bool added = impl_->added.take_out(stretch), known = impl_->known.take_out(stretch);
  if (known) impl_->base.reset();
  if (added || known) impl_->changed(stretch, true);
  return added || known;
}

SearchStatus ChangingWorld::find(Point from, Point to) { return impl_->find(from, to); }
const std::vector<Point>& ChangingWorld::points() const { return impl_->points; }
double ChangingWorld::length() const { return impl_->length; }
bool ChangingWorld::has_index() const { return impl_->base && impl_->base->index; }
std::size_t ChangingWorld::rebuilds() const { return impl_->rebuilds; }
bool ChangingWorld::is_among_cells() { return impl_->cells_now() != nullptr; }

const FreeSpace& ChangingWorld::space() { return impl_->prepared().space; }

}  // namespace taut
