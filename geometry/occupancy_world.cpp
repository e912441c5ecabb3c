#include <taut/geometry/occupancy_world.h>

#include <algorithm>
#include <array>
#include <utility>

#include <taut/geometry/written.h>

namespace taut {

namespace {

/// Follows the sides between blocked and other cells, the blocked one on the left.
class Outlines {
 public:
  explicit Outlines(const OccupancyGrid& grid)
      : grid_(grid),
        columns_(grid.width + 1),
        followed_(std::size_t{columns_} * (grid.height + 1), 0),
        at_(followed_.size(), kNowhere),
        piece_of_(grid.blocked.size(), kNowhere) {}

  std::vector<Area> solids() {
    for (std::uint32_t row = 0; row < grid_.height; ++row)
      for (std::uint32_t column = 0; column < grid_.width; ++column) {
        if (!blocked(column, row)) continue;
        if (piece_of_[cell(column, row)] == kNowhere) number_piece(column, row);
        // Every outline has a side that runs to the right, along the upper side of some cell.
        if (!blocked(column, std::int64_t{row} - 1) && !(followed_[corner(column, row)] & 1)) follow(column, row);
      }
    return std::move(solids_);
  }

 private:
  static constexpr std::uint32_t kNowhere = 0xffffffff;
  struct Step {
    int x, y;
  };
  static constexpr std::array<Step, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};  // each a left turn from the last
  static constexpr std::array<Step, 4> kLeftCell{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  static constexpr std::array<Step, 4> kRightCell{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};

  std::size_t cell(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row) * grid_.width + static_cast<std::size_t>(column);
  }
  std::size_t corner(std::int64_t x, std::int64_t y) const {
    return static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x);
  }
  bool blocked(std::int64_t column, std::int64_t row) const {
    return grid_.contains(column, row) && grid_.blocked[cell(column, row)] != 0;
  }
  bool is_side(std::int64_t x, std::int64_t y, std::size_t direction) const {
    const Step left = kLeftCell[direction], right = kRightCell[direction];
    return blocked(x + left.x, y + left.y) && !blocked(x + right.x, y + right.y);
  }

  /// All blocked cells that hang together with this one.
  void number_piece(std::uint32_t column, std::uint32_t row) {
    const std::uint32_t piece = static_cast<std::uint32_t>(solids_.size());
    solids_.emplace_back();
    open_.assign(1, {column, row});
    piece_of_[cell(column, row)] = piece;
    while (!open_.empty()) {
      const auto [x, y] = open_.back();
      open_.pop_back();
      for (const Step step : kSteps) {
        const std::int64_t u = x + step.x, v = y + step.y;
        if (!blocked(u, v) || piece_of_[cell(u, v)] != kNowhere) continue;
        piece_of_[cell(u, v)] = piece;
        open_.emplace_back(u, v);
      }
    }
  }

  /// From the upper left corner of a cell to the right and on until it closes. Where two blocked cells meet at a corner
  /// it stays with its own; a corner that it comes to again cuts off a ring.
  void follow(std::int64_t x, std::int64_t y) {
    const std::uint32_t piece = piece_of_[cell(x, y)];
    std::size_t direction = 0;
    ring_.clear();
    do {
      followed_[corner(x, y)] |= static_cast<std::uint8_t>(1U << direction);
      x += kSteps[direction].x;
      y += kSteps[direction].y;
      const std::size_t before = direction, left = (direction + 1) % 4, right = (direction + 3) % 4;
      direction = is_side(x, y, left) ? left : is_side(x, y, direction) ? direction : right;
      if (direction != before) turn_at(x, y, piece);
    } while (!(followed_[corner(x, y)] & (1U << direction)));
    close(0, piece);
  }

  void turn_at(std::int64_t x, std::int64_t y, std::uint32_t piece) {
    std::uint32_t& at = at_[corner(x, y)];
    if (at != kNowhere) close(at, piece);
    at = static_cast<std::uint32_t>(ring_.size());
    ring_.push_back({static_cast<double>(x), static_cast<double>(y)});
  }

  /// The corners from `first` on are a ring of their own.
  void close(std::size_t first, std::uint32_t piece) {
    if (ring_.size() < first + 4) return;
    Ring ring(ring_.begin() + static_cast<std::ptrdiff_t>(first), ring_.end());
    for (const Point p : ring) at_[corner(static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y))] = kNowhere;
    ring_.resize(first);
    Polygon& polygon = solids_[piece].polygon;
    if (written::ring_orientation(ring) > 0)
      polygon.outer = std::move(ring);
    else
      polygon.holes.push_back(std::move(ring));
  }

  const OccupancyGrid& grid_;
  std::uint32_t columns_;
  std::vector<std::uint8_t> followed_;  // by corner: the directions in which sides were followed from it
  std::vector<std::uint32_t> at_;       // by corner: where it is in ring_
  std::vector<std::uint32_t> piece_of_;
  std::vector<std::pair<std::int64_t, std::int64_t>> open_;
  Ring ring_;
  std::vector<Area> solids_;
};

}  // namespace

namespace {

WorldParts parts_of(const OccupancyGrid& grid, std::string source) {
  if (grid.width == 0 || grid.height == 0) throw InputError(source, 0, "the map has no cells");
  WorldParts parts;
  parts.source = std::move(source);
  const double width = grid.width, height = grid.height;
  parts.areas = {{{{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}, 0}};
  parts.boundary = Boundary::walled;
  parts.solids = Outlines(grid).solids();
  return parts;
}

}  // namespace

World world_of(const OccupancyGrid& grid, std::string source) {
  WorldParts parts = parts_of(grid, std::move(source));
  parts.y_down = true;
  return World(std::move(parts));
}

WorldParts parts_of(const OccupancyGrid& grid, const std::function<Point(std::uint32_t, std::uint32_t)>& corner,
                    std::string source) {
  WorldParts parts = parts_of(grid, std::move(source));
  const auto place = [&](Ring& ring) {
    for (Point& p : ring) p = corner(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y));
  };
  for (std::vector<Area>* areas : {&parts.areas, &parts.solids})
    for (Area& area : *areas) {
      place(area.polygon.outer);
      std::ranges::for_each(area.polygon.holes, place);
    }
  return parts;
}

}  // namespace taut
