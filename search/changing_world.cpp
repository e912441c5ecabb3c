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
#include <taut/search/polyanya.h>

namespace taut {

namespace {

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

bool lies_on(const Segment& stretch, const Wall& wall) {
  return written::on_segment(stretch.a, wall.a, wall.b) && written::on_segment(stretch.b, wall.a, wall.b);
}

/// Takes the stretch out of the walls; are there some that it lies on?
bool take_out(const Segment& stretch, std::vector<Wall>& walls) {
  std::vector<Wall> left;
  const auto touched =
      std::stable_partition(walls.begin(), walls.end(), [&](const Wall& w) { return !lies_on(stretch, w); });
  const bool is_there = touched != walls.end();
  for (auto wall = touched; wall != walls.end(); ++wall) {
    // Its end that is nearer to wall.a: the one that the other does not lie before.
    const bool turned = !written::on_segment(stretch.a, wall->a, stretch.b);
    const Point near = turned ? stretch.b : stretch.a, far = turned ? stretch.a : stretch.b;
    if (near != wall->a) left.push_back({wall->a, near, wall->thickness, wall->line});
    if (far != wall->b) left.push_back({far, wall->b, wall->thickness, wall->line});
  }
  walls.erase(touched, walls.end());
  walls.insert(walls.end(), left.begin(), left.end());
  return is_there;
}

}  // namespace

struct ChangingWorld::Impl {
  explicit Impl(Prepared first) : base(std::move(first)), parts(base->space.world().parts()) {
    const World& world = base->space.world();
    parts.areas = world.areas();
    parts.boundary = world.boundary();
    parts.grid = nullptr;
    footprint = base->space.footprint();
  }

  /// What may come near a path only by touching it.
  bool is_thin(const Wall& wall) const { return wall.thickness == 0 && footprint.kind() == Footprint::Kind::point; }

  bool is_touched(const std::vector<Point>& path) const {
    const auto meets = [&](const Wall& wall) {
      if (!is_thin(wall)) return true;
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        if (written::segments_meet({path[i], path[i + 1]}, {wall.a, wall.b})) return true;
      return path.size() == 1 && written::on_segment(path[0], wall.a, wall.b);
    };
    return std::any_of(added.begin(), added.end(), meets);
  }

  World world() const {
    WorldParts all = parts;
    all.walls.insert(all.walls.end(), added.begin(), added.end());
    return World(std::move(all));
  }

  Prepared& prepared() {
    if (now) return *now;
    if (base && added.empty()) return *base;
    ++rebuilds;
    now.emplace(FreeSpace(world(), footprint));
    return *now;
  }

  void changed() { now.reset(); }

  /// An index stays for what it can still answer; other parts are no better than newer ones.
  void settle() {
    if (!now || (base && base->index)) return;
    base = std::move(now);
    now.reset();
    parts.walls.insert(parts.walls.end(), added.begin(), added.end());
    added.clear();
  }

  SearchStatus take(SearchStatus status, const std::vector<Point>& found) {
    points = found;
    length = status == SearchStatus::found ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i)
      length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    return status;
  }

  SearchStatus find(Point from, Point to) {
    const bool may_ask = base && base->has(from) && base->has(to) &&
                         std::all_of(added.begin(), added.end(), [&](const Wall& w) { return is_thin(w); });
    if (may_ask) {
      const SearchStatus status = base->find(from, to);
      if (added.empty() || status != SearchStatus::found || !is_touched(base->points()))
        return take(status, base->points());
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

  std::optional<Prepared> base;  // of parts, while nothing of it was taken away
  std::optional<Prepared> now;   // of parts and what was added
  WorldParts parts;
  std::vector<Wall> added;
  Footprint footprint;
  std::size_t rebuilds = 0;
  std::vector<Point> points;
  double length = std::numeric_limits<double>::infinity();
};

ChangingWorld::ChangingWorld(FreeSpace space) : impl_(std::make_unique<Impl>(Prepared(std::move(space)))) {}
ChangingWorld::ChangingWorld(Index index) : impl_(std::make_unique<Impl>(Prepared(index))) {}
ChangingWorld::ChangingWorld(ChangingWorld&&) noexcept = default;
ChangingWorld& ChangingWorld::operator=(ChangingWorld&&) noexcept = default;
ChangingWorld::~ChangingWorld() = default;

void ChangingWorld::add(const Wall& wall) {
  Box box{impl_->parts.areas[0].polygon.outer[0], impl_->parts.areas[0].polygon.outer[0]};
  for (const Area& area : impl_->parts.areas)
    for (const Point p : area.polygon.outer) {
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
  for (const Point p : {wall.a, wall.b})
    if (!box.contains(p))
      throw InputError(impl_->parts.source, 0, fmt::format("the wall's end ({}, {}) lies outside the world", p.x, p.y));
  if (!(wall.thickness >= 0 && wall.thickness <= World::kLargest))
    throw InputError(impl_->parts.source, 0, fmt::format("the wall's thickness {} is none", wall.thickness));
  impl_->added.push_back(wall);
  impl_->changed();
}

bool ChangingWorld::remove(const Segment& stretch) {
  if (stretch.a == stretch.b) return false;
  const bool added = take_out(stretch, impl_->added), known = take_out(stretch, impl_->parts.walls);
  if (known) impl_->base.reset();
  if (added || known) impl_->changed();
  return added || known;
}

SearchStatus ChangingWorld::find(Point from, Point to) { return impl_->find(from, to); }
const std::vector<Point>& ChangingWorld::points() const { return impl_->points; }
double ChangingWorld::length() const { return impl_->length; }
bool ChangingWorld::has_index() const { return impl_->base && impl_->base->index; }
std::size_t ChangingWorld::rebuilds() const { return impl_->rebuilds; }

const FreeSpace& ChangingWorld::space() { return impl_->prepared().space; }

}  // namespace taut
