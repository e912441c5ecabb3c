#include <taut/robots/roadblocks/roadblock_map_generator.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

#include <taut/geometry/draws.h>
#include <taut/geometry/errors.h>

namespace taut::roadblocks {

namespace {

constexpr int kSlot = 15;                                       // cells of a slot, at least
constexpr std::array<int, 7> kLaneWidths{2, 2, 2, 3, 3, 4, 6};  // open cells: wall points are one more apart

struct Room {
  int left, top, right, bottom;  // cells, inclusive
};

struct Lane {
  Room room;
  bool along_x;
};

void require_range(const char* what, int value, int least, int most) {
  if (value < least || value > most)
    throw InputError({}, 0,
                     std::string(what) + " " + std::to_string(value) + " is not " + std::to_string(least) + " to " +
                         std::to_string(most));
}

class Generator {
 public:
  explicit Generator(const RoadblockMapRecipe& recipe) : recipe_(recipe), draws_(recipe.seed) {
    Course& course = map_.course;
    course.width = recipe.width;
    course.height = recipe.height;
    course.walls.assign(static_cast<std::size_t>(recipe.width) * static_cast<std::size_t>(recipe.height), 1);
    columns_ = std::max(1, (recipe.width - 1) / kSlot);
    rows_ = std::max(1, (recipe.height - 1) / kSlot);
    if (columns_ * rows_ == 1) columns_ = 2;
  }

  RoadblockMap run() {
    lay_rooms();
    lay_lanes();
    put_ends();
    for (const Room& room : rooms_)
      if (draws_.below(4) == 0) put_pillar(room);
    put_roadblocks();
    draw_samples();
    return std::move(map_);
  }

 private:
  int within(int lo, int hi) { return lo + static_cast<int>(draws_.below(static_cast<std::uint32_t>(hi - lo + 1))); }

  void clear(const Room& r) {
    for (int y = r.top; y <= r.bottom; ++y)
      for (int x = r.left; x <= r.right; ++x) map_.course.walls[map_.course.index({x, y})] = 0;
  }

  /// Every room holds the middle of its slot, so that neighbours face each other.
  std::array<int, 2> side(int slot, int slots, int length) {
    const int begin = 2 + slot * (length - 1) / slots, end = (slot + 1) * (length - 1) / slots;
    const int middle = (begin + end) / 2, half = kLeastRoom / 2;
    return {within(begin, std::max(begin, middle - half)), within(std::min(end, middle + half), end)};
  }

  void lay_rooms() {
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c) {
        const auto [left, right] = side(c, columns_, recipe_.width);
        const auto [top, bottom] = side(r, rows_, recipe_.height);
        rooms_.push_back({left, top, right, bottom});
        clear(rooms_.back());
      }
  }

  void lay_lanes() {
    std::vector<std::array<int, 2>> pairs;
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c) {
        const int at = r * columns_ + c;
        if (c + 1 < columns_) pairs.push_back({at, at + 1});
        if (r + 1 < rows_) pairs.push_back({at, at + columns_});
      }
    for (std::size_t i = pairs.size(); i > 1; --i)
      std::swap(pairs[i - 1], pairs[draws_.below(static_cast<std::uint32_t>(i))]);
    std::vector<int> part(rooms_.size());
    std::iota(part.begin(), part.end(), 0);
    for (const auto& [a, b] : pairs) {
      const int from = part[static_cast<std::size_t>(a)], to = part[static_cast<std::size_t>(b)];
      if (from == to && draws_.below(4) == 0) continue;  // most loops
      std::ranges::replace(part, from, to);
      lay_lane(rooms_[static_cast<std::size_t>(a)], rooms_[static_cast<std::size_t>(b)], b == a + 1);
    }
  }

  void lay_lane(const Room& a, const Room& b, bool along_x) {
    const int drawn = kLaneWidths[draws_.below(static_cast<std::uint32_t>(kLaneWidths.size()))];
    const int width = std::max(recipe_.narrowest, drawn);
    Lane lane{{}, along_x};
    if (along_x) {
      const int lo = std::max(a.top, b.top), hi = std::min(a.bottom, b.bottom) - width + 1,
                y = within(lo, std::max(lo, hi));
      lane.room = {a.right + 1, y, b.left - 1, y + width - 1};
    } else {
      const int lo = std::max(a.left, b.left), hi = std::min(a.right, b.right) - width + 1,
                x = within(lo, std::max(lo, hi));
      lane.room = {x, a.bottom + 1, x + width - 1, b.top - 1};
    }
    clear(lane.room);
    lanes_.push_back(lane);
  }

  static Point middle(const Room& r) {
    return {static_cast<double>((r.left + r.right) / 2), static_cast<double>((r.top + r.bottom) / 2)};
  }

  void put_ends() {
    map_.course.start = middle(rooms_.front());
    map_.course.goal = middle(rooms_.back());
    if (draws_.below(2) == 0) std::swap(map_.course.start, map_.course.goal);
  }

  /// A wall cell that leaves 4 to the room's sides, not near start or goal.
  void put_pillar(const Room& r) {
    if (r.right - r.left < 8 || r.bottom - r.top < 8) return;
    const Cell cell{within(r.left + 3, r.right - 3), within(r.top + 3, r.bottom - 3)};
    for (const Point p : {map_.course.start, map_.course.goal})
      if (std::abs(cell.x - p.x) <= 4 && std::abs(cell.y - p.y) <= 4) return;
    map_.course.walls[map_.course.index(cell)] = 1;
  }

  void put_roadblocks() {
    std::erase_if(lanes_, [](const Lane& l) { return l.room.right < l.room.left || l.room.bottom < l.room.top; });
    for (std::size_t i = lanes_.size(); i > 1; --i)
      std::swap(lanes_[i - 1], lanes_[draws_.below(static_cast<std::uint32_t>(i))]);
    // Where there are more roadblocks than lanes a third of the lanes has none, or hardly a sample would have a way.
    const bool in_series = static_cast<std::size_t>(recipe_.roadblocks) > lanes_.size();
    const auto some = static_cast<std::ptrdiff_t>(in_series ? (2 * lanes_.size() + 2) / 3 : lanes_.size());
    for (const Lane& lane : std::span(lanes_.begin(), lanes_.begin() + some)) {
      if (!needs_roadblock()) return;
      const double open_probability = within(2, 9) / 10.0;
      put_roadblock(open_probability, cells_across(lane, place_in(lane)));
    }
    while (needs_roadblock() && (put_another(true) || put_another(false))) {
    }
  }

  bool needs_roadblock() const { return map_.course.roadblocks.size() < static_cast<std::size_t>(recipe_.roadblocks); }

  void put_roadblock(double open_probability, std::vector<Cell> cells) {
    const auto letter = static_cast<char>('A' + map_.course.roadblocks.size());
    map_.course.roadblocks.push_back({letter, open_probability, std::move(cells)});
  }

  /// One more, in a lane that has some or that has none, in a row of the lane's without one: likelier to be open, since
  /// all have to be.
  bool put_another(bool in_series) {
    std::vector<std::pair<const Lane*, Cell>> places;
    for (const Lane& lane : lanes_)
      for (int k = 0; k < length(lane) && has_roadblocks(lane) == in_series; ++k)
        if (const Cell at = in_row(lane, k); !has_roadblock(lane, at)) places.emplace_back(&lane, at);
    if (places.empty()) return false;
    const auto& [lane, at] = places[draws_.below(static_cast<std::uint32_t>(places.size()))];
    put_roadblock(within(7, 9) / 10.0, cells_across(*lane, at));
    return true;
  }

  static int length(const Lane& lane) {
    return 1 + (lane.along_x ? lane.room.right - lane.room.left : lane.room.bottom - lane.room.top);
  }

  static Cell in_row(const Lane& lane, int k) {
    const Room& r = lane.room;
    return lane.along_x ? Cell{r.left + k, r.top} : Cell{r.left, r.top + k};
  }

  bool has_roadblocks(const Lane& lane) const {
    for (int k = 0; k < length(lane); ++k)
      if (has_roadblock(lane, in_row(lane, k))) return true;
    return false;
  }

  /// Anywhere in the lane's row through the cell.
  bool has_roadblock(const Lane& lane, Cell at) const {
    const Room& r = lane.room;
    const auto in_the_row = [&](Cell c) {
      return c.x >= r.left && c.x <= r.right && c.y >= r.top && c.y <= r.bottom &&
             (lane.along_x ? c.x == at.x : c.y == at.y);
    };
    return std::ranges::any_of(map_.course.roadblocks,
                               [&](const Roadblock& b) { return std::ranges::any_of(b.cells, in_the_row); });
  }

  Cell place_in(const Lane& lane) {
    const int x = within(lane.room.left, lane.room.right);
    return {x, within(lane.room.top, lane.room.bottom)};
  }

  /// One cell of a narrow lane, all across a wide one.
  static std::vector<Cell> cells_across(const Lane& lane, Cell at) {
    const Room& r = lane.room;
    const int width = lane.along_x ? r.bottom - r.top + 1 : r.right - r.left + 1;
    if (width == 2) return {at};
    std::vector<Cell> cells;
    const int rim = width == 3 ? 1 : 0;
    for (int k = rim; k < width - rim; ++k)
      cells.push_back(lane.along_x ? Cell{at.x, r.top + k} : Cell{r.left + k, at.y});
    return cells;
  }

  void draw_samples() {
    for (int number = 1; number <= recipe_.samples; ++number) {
      Sample sample{number, 0};
      for (std::size_t i = 0; i < map_.course.roadblocks.size(); ++i) {
        const auto per_mille = static_cast<std::uint32_t>(1000 * map_.course.roadblocks[i].open_probability + 0.5);
        if (draws_.below(1000) < per_mille) sample.open |= RoadblockSet{1} << i;
      }
      map_.samples.push_back(sample);
    }
  }

  RoadblockMapRecipe recipe_;
  Draws draws_;
  RoadblockMap map_;
  int columns_ = 0, rows_ = 0;
  std::vector<Room> rooms_;
  std::vector<Lane> lanes_;
};

}  // namespace

RoadblockMap generate_roadblock_map(const RoadblockMapRecipe& recipe) {
  require_range("a width of", recipe.width, kLeastMazeSide, kLargestSide);
  require_range("a height of", recipe.height, kLeastMazeSide, kLargestSide);
  require_range("a number of roadblocks,", recipe.roadblocks, 0, Course::kMostRoadblocks);
  require_range("a number of samples,", recipe.samples, 0, 1'000'000);
  require_range("lanes of", recipe.narrowest, kLeastLane, kLeastRoom);
  return Generator(recipe).run();
}

}  // namespace taut::roadblocks
