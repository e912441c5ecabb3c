#include <taut/robots/roadblocks/doors.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <taut/robots/roadblocks/detail/disc_distance.h>

namespace taut::roadblocks {

namespace {

using detail::kRaster;

constexpr RoadblockSet kWall = ~RoadblockSet{0};  // more than kMostRoadblocks
constexpr int kNone = -1;
constexpr double kHalfDiagonal = 1.81;  // of the car, and more
constexpr double kLookFrom = 3.2, kLookTo = 3.5;
constexpr double kArrivalFrom = 4.5, kArrivalTo = 4.95;  // just within kSight

RoadblockSet bit(std::size_t block) { return RoadblockSet{1} << block; }

class DoorFinder {
 public:
  DoorFinder(const Course& course, WallReading reading)
      : course_(course), columns_(course.width * kRaster), open_(course, 0, reading) {
    shut_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(course.height * kRaster), 0);
    for (std::size_t at = 0; at < shut_.size(); ++at)
      if (open_.room(middle_of(at)) < kHalfWidth) shut_[at] = kWall;
    for (std::size_t b = 0; b < course.roadblocks.size(); ++b) {
      const detail::Obstacles closed = open_.with(bit(b));
      for (std::size_t at = 0; at < shut_.size(); ++at)
        if (shut_[at] != kWall && closed.room(middle_of(at)) < kHalfWidth) shut_[at] |= bit(b);
    }
    label_regions();
  }

  std::vector<Door> run() {
    first_.resize(course_.roadblocks.size());
    std::iota(first_.begin(), first_.end(), std::size_t{0});
    for (const Region& region : regions_)
      if (region.is_pocket) join_all(region.borders);
    join_touching();
    std::vector<Door> doors;
    for (std::size_t b = 0; b < first_.size(); ++b)
      if (first_of(b) == b) doors.push_back(door_of(b));
    return doors;
  }

 private:
  struct Region {
    RoadblockSet borders = 0;
    bool is_pocket = false;
  };

  Point middle_of(std::size_t at) const {
    const auto columns = static_cast<std::size_t>(columns_);
    return {detail::middle(static_cast<int>(at % columns)), detail::middle(static_cast<int>(at / columns))};
  }

  template <typename Visit>
  void each_beside(std::size_t at, Visit visit) const {
    const auto columns = static_cast<std::size_t>(columns_);
    if (at % columns > 0) visit(at - 1);
    if (at % columns + 1 < columns) visit(at + 1);
    if (at >= columns) visit(at - columns);
    if (at + columns < shut_.size()) visit(at + columns);
  }

  /// The cells joined to `from` by cells for which `is_in` holds; `done` marks them.
  template <typename IsIn>
  std::vector<std::size_t> piece(std::size_t from, std::vector<bool>& done, IsIn is_in) const {
    std::vector<std::size_t> cells{from};
    done[from] = true;
    for (std::size_t k = 0; k < cells.size(); ++k)
      each_beside(cells[k], [&](std::size_t next) {
        if (done[next] || !is_in(next)) return;
        done[next] = true;
        cells.push_back(next);
      });
    return cells;
  }

  void label_regions() {
    region_.assign(shut_.size(), kNone);
    std::vector<bool> done(shut_.size());
    for (std::size_t at = 0; at < shut_.size(); ++at) {
      if (done[at] || shut_[at] != 0) continue;
      const std::vector<std::size_t> cells = piece(at, done, [&](std::size_t next) { return shut_[next] == 0; });
      Region region;
      for (const std::size_t cell : cells) {
        region_[cell] = static_cast<int>(regions_.size());
        each_beside(cell, [&](std::size_t next) {
          if (shut_[next] != kWall) region.borders |= shut_[next];
        });
      }
      region.is_pocket = std::popcount(region.borders) == 2 && std::ranges::all_of(cells, [&](std::size_t cell) {
                           return is_in_sight_of_all(region.borders, middle_of(cell)) && !is_at_an_end(middle_of(cell));
                         });
      regions_.push_back(region);
    }
  }

  bool is_at_an_end(Point p) const {
    const auto is_near = [&](Point end) { return std::hypot(p.x - end.x, p.y - end.y) <= kHalfDiagonal; };
    return is_near(course_.start) || is_near(course_.goal);
  }

  /// From the nearest cell of these roadblocks.
  double distance_to(RoadblockSet blocks, Point p) const {
    double least = std::numeric_limits<double>::infinity();
    for (; blocks != 0; blocks &= blocks - 1)
      for (const Cell c : course_.roadblocks[static_cast<std::size_t>(std::countr_zero(blocks))].cells)
        least = std::min(least, std::hypot(p.x - c.x, p.y - c.y));
    return least;
  }

  bool is_in_sight_of_all(RoadblockSet blocks, Point p) const {
    for (; blocks != 0; blocks &= blocks - 1)
      if (distance_to(blocks & (~blocks + 1), p) > kSight) return false;
    return true;
  }

  std::size_t first_of(std::size_t block) const {
    while (first_[block] != block) block = first_[block];
    return block;
  }

  void join_all(RoadblockSet blocks) {
    for (RoadblockSet rest = blocks & (blocks - 1); rest != 0; rest &= rest - 1) {
      const std::size_t a = first_of(static_cast<std::size_t>(std::countr_zero(blocks))),
                        b = first_of(static_cast<std::size_t>(std::countr_zero(rest)));
      first_[std::max(a, b)] = std::min(a, b);
    }
  }

  void join_touching() {
    const RoadblockSet alone = opening_alone();
    for (std::size_t at = 0; at < shut_.size(); ++at) {
      if (shut_[at] == kWall || shut_[at] == 0) continue;
      join_all(shut_[at] & ~alone);
      each_beside(at, [&](std::size_t next) {
        if (shut_[next] != kWall && shut_[next] != 0) join_all((shut_[at] | shut_[next]) & ~alone);
      });
    }
  }

  /// Those that join two pieces of regions around them when nothing else is open.
  RoadblockSet opening_alone() const {
    RoadblockSet alone = 0;
    for (std::size_t b = 0; b < first_.size(); ++b)
      if (joins_alone(bit(b))) alone |= bit(b);
    return alone;
  }

  bool joins_alone(RoadblockSet block) const {
    std::map<std::size_t, std::size_t> piece_of;
    const auto pieces = pieces_near(block);
    for (std::size_t k = 0; k < pieces.size(); ++k)
      for (const std::size_t cell : pieces[k]) piece_of[cell] = k;
    std::vector<bool> done(shut_.size());
    for (std::size_t at = 0; at < shut_.size(); ++at) {
      if (done[at] || shut_[at] != block) continue;
      std::set<std::size_t> beside;
      for (const std::size_t cell : piece(at, done, [&](std::size_t next) { return shut_[next] == block; }))
        each_beside(cell, [&](std::size_t next) {
          if (const auto found = piece_of.find(next); found != piece_of.end()) beside.insert(found->second);
        });
      if (beside.size() > 1) return true;
    }
    return false;
  }

  /// Pieces of regions that touch the zone of these roadblocks, as far as they are in sight of them.
  std::vector<std::vector<std::size_t>> pieces_near(RoadblockSet blocks) const {
    std::vector<std::vector<std::size_t>> pieces;
    std::vector<bool> done(shut_.size());
    const auto is_near = [&](std::size_t cell) {
      return is_place(cell) && distance_to(blocks, middle_of(cell)) <= kSight;
    };
    for (std::size_t at = 0; at < shut_.size(); ++at)
      if (!done[at] && is_near(at) && touches_zone(at, blocks)) pieces.push_back(piece(at, done, is_near));
    return pieces;
  }

  /// In a region that is no pocket.
  bool is_place(std::size_t at) const {
    return region_[at] != kNone && !regions_[static_cast<std::size_t>(region_[at])].is_pocket;
  }

  Door door_of(std::size_t first) const {
    Door door;
    for (std::size_t b = first; b < first_.size(); ++b)
      if (first_of(b) == first) {
        door.blocks |= bit(b);
        door.open_probability *= course_.roadblocks[b].open_probability;
      }
    for (const auto& cells : pieces_near(door.blocks)) door.sides.push_back(side_of(cells, door.blocks));
    return door;
  }

  bool touches_zone(std::size_t at, RoadblockSet blocks) const {
    bool touches = false;
    each_beside(at, [&](std::size_t next) { touches = touches || (shut_[next] != kWall && (shut_[next] & blocks)); });
    return touches;
  }

  /// The middle of the piece's cells that touch the zone, and of the roadblocks: so a lane leads out.
  std::pair<Point, Point> axis(const std::vector<std::size_t>& cells, RoadblockSet blocks) const {
    std::vector<Point> front, door;
    for (const std::size_t cell : cells)
      if (touches_zone(cell, blocks)) front.push_back(middle_of(cell));
    for (RoadblockSet rest = blocks; rest != 0; rest &= rest - 1)
      for (const Cell c : course_.roadblocks[static_cast<std::size_t>(std::countr_zero(rest))].cells)
        door.push_back({static_cast<double>(c.x), static_cast<double>(c.y)});
    return {mean(front), mean(door)};
  }

  static Point mean(const std::vector<Point>& points) {
    Point sum{0, 0};
    for (const Point p : points) sum = {sum.x + p.x, sum.y + p.y};
    const auto count = static_cast<double>(points.size());
    return {sum.x / count, sum.y / count};
  }

  DoorSide side_of(const std::vector<std::size_t>& cells, RoadblockSet blocks) const {
    const auto away = [&](std::size_t cell) { return distance_to(blocks, middle_of(cell)); };
    const std::size_t farthest = *std::ranges::max_element(cells, {}, away);
    DoorSide side{middle_of(farthest), {}};
    const auto [out, door] = axis(cells, blocks);
    double farthest_out = -std::numeric_limits<double>::infinity();
    for (const std::size_t cell : cells) {
      const Point p = middle_of(cell);
      const double distance = away(cell);
      if (distance >= kArrivalFrom && distance <= kArrivalTo) side.arrival.push_back(p);
      const double along = (p.x - door.x) * (out.x - door.x) + (p.y - door.y) * (out.y - door.y);
      if (distance < kLookFrom || distance > kLookTo || along <= farthest_out) continue;
      farthest_out = along;
      side.look = p;
    }
    if (side.arrival.empty()) side.arrival.push_back(middle_of(farthest));
    return side;
  }

  const Course& course_;
  int columns_;
  detail::Obstacles open_;
  std::vector<RoadblockSet> shut_;  ///< of raster cells: by which roadblocks; kWall by walls anyway
  std::vector<int> region_;
  std::vector<Region> regions_;
  std::vector<std::size_t> first_;  ///< a forest: of the same door, and not later
};

}  // namespace

std::vector<Door> doors(const Course& course, WallReading reading) { return DoorFinder(course, reading).run(); }

}  // namespace taut::roadblocks
