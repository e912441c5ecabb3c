#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include <taut/geometry/cell_plan.h>
#include <taut/geometry/detail/outline.h>
#include <taut/geometry/occupancy_grid.h>

namespace taut {

namespace {

/// The different values of coordinates, and, once they are sorted, which each of them is.
class Lines {
 public:
  /// Says whether v is new.
  bool add(double v) {
    v += 0.0;  // -0 is 0
    const std::size_t i = place(v);
    if (slots_[i].line != kNone) return false;
    slots_[i] = {v, static_cast<std::uint32_t>(values_.size())};
    values_.push_back(v);
    if (2 * values_.size() > slots_.size()) grow();
    return true;
  }

  std::size_t size() const { return values_.size(); }

  std::vector<double> sorted() {
    std::sort(values_.begin(), values_.end());
    for (std::uint32_t i = 0; i < values_.size(); ++i) slots_[place(values_[i])].line = i;
    return values_;
  }

  std::uint32_t line(double v) const { return slots_[place(v + 0.0)].line; }

 private:
  struct Slot {
    double value = 0;
    std::uint32_t line = kNone;
  };

  std::size_t place(double v) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = std::bit_cast<std::uint64_t>(v) * 0x9e3779b97f4a7c15U >> (64 - std::countr_zero(slots_.size()));
    while (slots_[i].line != kNone && slots_[i].value != v) i = (i + 1) & mask;
    return i;
  }

  void grow() {
    std::vector<Slot> old(4 * slots_.size());
    std::swap(old, slots_);
    for (const Slot& slot : old)
      if (slot.line != kNone) slots_[place(slot.value)] = slot;
  }

  std::vector<double> values_;
  std::vector<Slot> slots_ = std::vector<Slot>(1024);
};

constexpr std::size_t kCellsAnEdge = 16, kCells = 4096;

void set_bits(std::uint64_t* words, std::size_t from, std::size_t to) {
  for (; from < to && from % 64 != 0; ++from) words[from / 64] |= std::uint64_t{1} << (from % 64);
  for (; from + 64 <= to; from += 64) words[from / 64] = ~std::uint64_t{0};
  for (; from < to; ++from) words[from / 64] |= std::uint64_t{1} << (from % 64);
}

/// Eight cells, 0 or 1 each, as bits.
std::uint64_t eight(const std::uint8_t* cells) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, cells, 8);
  return bytes * 0x0102040810204080U >> 56;
}

}  // namespace

class CellPlan::Maker {
 public:
  std::optional<CellPlan> of_raster(const OccupancyGrid& grid) {
    for (std::uint32_t x = 0; x <= grid.width; ++x) plan_.xs_.push_back(x);
    for (std::uint32_t y = 0; y <= grid.height; ++y) plan_.ys_.push_back(y);
    make_room();
    for (std::uint32_t row = 0; row < grid.height; ++row) {
      const std::uint8_t* const cells = grid.blocked.data() + std::size_t{row} * grid.width;
      std::uint64_t* const words = free_row(row);
      std::uint32_t x = 0;
      for (; x + 8 <= grid.width && std::endian::native == std::endian::little; x += 8)
        words[x / 64] |= (eight(cells + x) ^ 0xff) << (x % 64);
      for (; x < grid.width; ++x) words[x / 64] |= std::uint64_t{cells[x] == 0} << (x % 64);
    }
    open_sides();
    return std::move(plan_);
  }

  std::optional<CellPlan> of_sides(const World& world) {
    if (world.areas().size() != 1) return std::nullopt;
    for (const Wall& wall : world.walls())
      if (wall.thickness != 0 || !add_line({wall.a, wall.b})) return std::nullopt;
    for (const auto* areas : {&world.areas(), &world.solids()})
      for (const Area& area : *areas)
        for (const Segment& side : detail::outline(area.polygon))
          if (!add_line(side)) return std::nullopt;
    if (are_too_many()) return std::nullopt;
    plan_.xs_ = xs_.sorted();
    plan_.ys_ = ys_.sorted();
    make_room();
    fill(world);
    for (const Wall& wall : world.walls()) add_wall(wall);
    open_sides();
    return std::move(plan_);
  }

 private:
  bool are_too_many() const { return xs_.size() * ys_.size() > std::max(kCells, kCellsAnEdge * edges_); }

  /// False when there can be no plan any more: the edges to come are not counted, so it waits for as many as there are
  /// lines.
  bool add_line(const Segment& s) {
    if (s.a.x != s.b.x && s.a.y != s.b.y) return false;
    ++edges_;
    xs_.add(s.a.x);
    ys_.add(s.a.y);
    if (s.a.x != s.b.x) xs_.add(s.b.x);
    if (s.a.y != s.b.y) ys_.add(s.b.y);
    return true;
  }

  void make_room() {
    plan_.words_ = (plan_.columns() + 63) / 64;
    for (auto* bits : {&plan_.free_, &plan_.open_right_, &plan_.open_above_})
      bits->assign(plan_.rows() * plan_.words_, 0);
  }

  std::uint64_t* free_row(std::size_t row) { return plan_.free_.data() + row * plan_.words_; }

  /// Free is what the area winds around more often than the solids do.
  void fill(const World& world) {
    const std::size_t columns = plan_.columns();
    std::vector<std::int32_t> change(plan_.rows() * columns, 0);  // of the winding number, from the left into a cell
    const auto add = [&](const Polygon& polygon, int turn) {
      for (const Segment& side : detail::outline(polygon)) {
        const std::size_t column = xs_.line(side.a.x);
        if (side.a.x != side.b.x || column == columns) continue;
        const std::size_t from = ys_.line(side.a.y), to = ys_.line(side.b.y);
        for (std::size_t row = std::min(from, to); row < std::max(from, to); ++row)
          change[row * columns + column] += from < to ? -turn : turn;
      }
    };
    add(world.areas().front().polygon, -1);
    for (const Area& solid : world.solids()) add(solid.polygon, 1);
    for (std::size_t row = 0; row < plan_.rows(); ++row) {
      int winding = 1;
      for (std::size_t column = 0; column < columns; ++column) {
        winding += change[row * columns + column];
        free_row(row)[column / 64] |= std::uint64_t{winding == 0} << (column % 64);
      }
    }
  }

  /// As closed sides, first; the outline is closed by itself.
  void add_wall(const Wall& wall) {
    const std::size_t x0 = xs_.line(wall.a.x), x1 = xs_.line(wall.b.x), y0 = ys_.line(wall.a.y),
                      y1 = ys_.line(wall.b.y);
    if (y0 == y1 && y0 > 0) {
      if (y0 < ys_.size() - 1)
        set_bits(plan_.open_above_.data() + (y0 - 1) * plan_.words_, std::min(x0, x1), std::max(x0, x1));
    } else if (x0 == x1 && x0 > 0 && x0 < xs_.size() - 1) {
      for (std::size_t row = std::min(y0, y1); row < std::max(y0, y1); ++row)
        plan_.open_right_[row * plan_.words_ + (x0 - 1) / 64] |= std::uint64_t{1} << ((x0 - 1) % 64);
    }
  }

  /// From closed sides and free cells to open sides.
  void open_sides() {
    const std::size_t words = plan_.words_;
    for (std::size_t row = 0; row < plan_.rows(); ++row)
      for (std::size_t w = 0; w < words; ++w) {
        const std::size_t i = row * words + w;
        const std::uint64_t next = w + 1 < words ? plan_.free_[i + 1] << 63 : 0,
                            above = row + 1 < plan_.rows() ? plan_.free_[i + words] : 0;
        plan_.open_right_[i] = plan_.free_[i] & (plan_.free_[i] >> 1 | next) & ~plan_.open_right_[i];
        plan_.open_above_[i] = plan_.free_[i] & above & ~plan_.open_above_[i];
      }
  }

  CellPlan plan_;
  Lines xs_, ys_;
  std::size_t edges_ = 0;
};

std::optional<CellPlan> CellPlan::of(const World& world) {
  return world.raster() ? Maker().of_raster(*world.raster()) : Maker().of_sides(world);
}

}  // namespace taut
