#include <taut/geometry/occupancy_world.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>

#include <taut/geometry/detail/raster.h>
#include <taut/geometry/mend_rings.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

/// Blocked cells of a row, one after the other.
struct Run {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t parent;  ///< a run of the same piece that comes before, or itself
};

/// The blocked cells that hang together, by sides: runs of them, joined from row to row.
class Pieces {
 public:
  explicit Pieces(const OccupancyGrid& grid) {
    rows_.reserve(std::size_t{grid.height} + 1);
    for (std::uint32_t row = 0; row < grid.height; ++row) {
      rows_.push_back(count());
      add_row(grid, row);
      if (row > 0) join_rows(rows_[row - 1], rows_[row]);
    }
    rows_.push_back(count());
    number();
  }

  std::uint32_t piece_count() const { return pieces_; }
  std::span<const Run> row(std::uint32_t row) const {
    return std::span(runs_).subspan(rows_[row], rows_[row + 1] - rows_[row]);
  }
  /// In the order of their first cells, row by row.
  std::uint32_t piece(const Run& run) const { return piece_of_[static_cast<std::size_t>(&run - runs_.data())]; }

 private:
  std::uint32_t count() const { return static_cast<std::uint32_t>(runs_.size()); }

  void add_row(const OccupancyGrid& grid, std::uint32_t row) {
    const std::uint8_t* const cells = grid.blocked.data() + std::size_t{row} * grid.width;
    for (std::uint32_t x = 0; x < grid.width; ++x) {
      if (cells[x] == 0) continue;
      const std::uint32_t from = x;
      while (x < grid.width && cells[x] != 0) ++x;
      runs_.push_back({from, x, count()});
    }
  }

  void join_rows(std::uint32_t above, std::uint32_t below) {
    const std::uint32_t end = count();
    for (std::uint32_t i = above, j = below; i < below && j < end;) {
      if (runs_[i].from < runs_[j].to && runs_[j].from < runs_[i].to) join(i, j);
      runs_[i].to < runs_[j].to ? ++i : ++j;
    }
  }

  std::uint32_t root(std::uint32_t i) {
    while (runs_[i].parent != i) i = runs_[i].parent = runs_[runs_[i].parent].parent;
    return i;
  }

  void join(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    runs_[std::max(i, j)].parent = std::min(i, j);
  }

  void number() {
    piece_of_.resize(runs_.size());
    for (std::uint32_t i = 0; i < piece_of_.size(); ++i)
      piece_of_[i] = runs_[i].parent == i ? pieces_++ : piece_of_[root(i)];
  }

  std::vector<Run> runs_;
  std::vector<std::uint32_t> rows_;  // the first run of each
  std::vector<std::uint32_t> piece_of_;
  std::uint32_t pieces_ = 0;
};

/// Follows the sides between blocked and other cells, the blocked one on the left.
class Outlines {
 public:
  explicit Outlines(const OccupancyGrid& grid)
      : width_(grid.width),
        height_(grid.height),
        stride_(std::size_t{grid.width} + 2),
        blocked_(stride_ * (std::size_t{grid.height} + 2), 0),
        followed_(blocked_.size(), false),
        pieces_(grid),
        solids_(pieces_.piece_count()) {
    for (std::size_t row = 0; row < height_; ++row)
      std::transform(grid.blocked.begin() + static_cast<std::ptrdiff_t>(row * width_),
                     grid.blocked.begin() + static_cast<std::ptrdiff_t>((row + 1) * width_),
                     blocked_.begin() + static_cast<std::ptrdiff_t>(cell(0, row)),
                     [](std::uint8_t b) { return b != 0; });
  }

  std::vector<Area> solids() {
    for (std::uint32_t row = 0; row < height_; ++row)
      for (const Run& run : pieces_.row(row))
        // Every outline has a side that runs to the right, along the upper side of some cell.
        for (std::uint32_t x = run.from; x < run.to; ++x)
          if (const std::size_t at = cell(x, row); !blocked_[at - stride_] && !followed_[at])
            follow(x, row, pieces_.piece(run));
    return std::move(solids_);
  }

 private:
  /// To the right, down, to the left, up: each a left turn from the last, for y grows downwards.
  static constexpr std::array<int, 4> kX{1, 0, -1, 0}, kY{0, 1, 0, -1};

  /// Around the map lies a rim of cells that are not blocked.
  std::size_t cell(std::size_t column, std::size_t row) const { return (row + 1) * stride_ + column + 1; }

  /// Is there a side from a corner, the upper left one of the cell `at`, in that direction?
  bool is_side(std::size_t at, std::size_t direction) const {
    const std::array<std::size_t, 4> around{at, at - 1, at - 1 - stride_, at - stride_};
    return blocked_[around[direction]] && !blocked_[around[(direction + 3) % 4]];
  }

  /// Four sides meet where two blocked cells touch at a corner only; nowhere else does an outline come by twice.
  bool is_touch(std::size_t at) const {
    return blocked_[at] == blocked_[at - 1 - stride_] && blocked_[at - 1] == blocked_[at - stride_] &&
           blocked_[at] != blocked_[at - 1];
  }

  /// From the upper left corner of a cell to the right and on until it closes. Where two blocked cells meet at a corner
  /// it stays with its own; a corner that it comes to again cuts off a ring.
  void follow(std::uint32_t column, std::uint32_t row, std::uint32_t piece) {
    int x = static_cast<int>(column), y = static_cast<int>(row);
    const std::size_t start = cell(column, row);
    std::size_t at = start, direction = 0;
    ring_.clear();
    at_.clear();
    do {
      if (direction == 0) followed_[at] = true;
      x += kX[direction];
      y += kY[direction];
      at = cell(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
      const std::size_t before = direction, left = (direction + 1) % 4;
      if (is_side(at, left))
        direction = left;
      else if (!is_side(at, direction))
        direction = (direction + 3) % 4;
      if (direction != before) turn_at(x, y, at, piece);
    } while (at != start || direction != 0);
    close(0, piece);
  }

  void turn_at(int x, int y, std::size_t at, std::uint32_t piece) {
    if (is_touch(at)) {
      const auto [seen, fresh] = at_.try_emplace(at, ring_.size());
      if (!fresh) {
        const std::size_t first = seen->second;
        close(first, piece);
        at_[at] = ring_.size();
      }
    }
    ring_.push_back({static_cast<double>(x), static_cast<double>(y)});
  }

  /// The corners from `first` on are a ring of their own.
  void close(std::size_t first, std::uint32_t piece) {
    if (ring_.size() < first + 4) return;
    Ring ring(ring_.begin() + static_cast<std::ptrdiff_t>(first), ring_.end());
    for (const Point p : ring)
      if (const std::size_t at = cell(static_cast<std::size_t>(p.x), static_cast<std::size_t>(p.y)); is_touch(at))
        at_.erase(at);
    ring_.resize(first);
    Polygon& polygon = solids_[piece].polygon;
    if (written::ring_orientation(ring) > 0)
      polygon.outer = std::move(ring);
    else
      polygon.holes.push_back(std::move(ring));
  }

  std::size_t width_, height_, stride_;
  std::vector<std::uint8_t> blocked_;
  std::vector<bool> followed_;  // by cell: the upper side, to the right
  Pieces pieces_;
  std::unordered_map<std::size_t, std::size_t> at_;  // by corner where blocked cells touch: where it is in ring_
  Ring ring_;
  std::vector<Area> solids_;
};

}  // namespace

namespace {

/// All but the solids.
WorldParts bare_parts(const OccupancyGrid& grid, std::string source) {
  if (grid.width == 0 || grid.height == 0) throw InputError(source, 0, "the map has no cells");
  WorldParts parts;
  parts.source = std::move(source);
  const double width = grid.width, height = grid.height;
  parts.areas = {{{{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}, 0}};
  parts.boundary = Boundary::walled;
  return parts;
}

WorldParts with_y_down(WorldParts parts) {
  parts.y_down = true;
  return parts;
}

}  // namespace

const std::vector<Area>& detail::Raster::solids() const {
  std::call_once(traced_, [this] {
    WorldParts parts;
    parts.solids = Outlines(grid_).solids();
    mend_rings(parts);
    solids_ = std::move(parts.solids);
  });
  return solids_;
}

World::World(OccupancyGrid grid, std::string source) : World(with_y_down(bare_parts(grid, std::move(source)))) {
  raster_ = std::make_shared<const detail::Raster>(std::move(grid));
}

World world_of(OccupancyGrid grid, std::string source) { return World(std::move(grid), std::move(source)); }

WorldParts parts_of(const OccupancyGrid& grid, const std::function<Point(std::uint32_t, std::uint32_t)>& corner,
                    std::string source) {
  WorldParts parts = bare_parts(grid, std::move(source));
  parts.solids = Outlines(grid).solids();
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
