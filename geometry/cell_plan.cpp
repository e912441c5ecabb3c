#include <taut/geometry/cell_plan.h>

#include <algorithm>
#include <cmath>

namespace taut {

namespace {

int sign(double v) { return (v > 0) - (v < 0); }

/// The quadrants whose closures hold a direction, by the signs of its coordinates.
unsigned quadrants_along(int x, int y) {
  unsigned all = 0;
  if (x >= 0 && y >= 0) all |= 1;
  if (x <= 0 && y >= 0) all |= 2;
  if (x <= 0 && y <= 0) all |= 4;
  if (x >= 0 && y <= 0) all |= 8;
  return all;
}

/// The last line that is not above v, or -1. Lines are mostly even: a guess is near.
std::ptrdiff_t line_before(const std::vector<double>& lines, double v) {
  const auto size = static_cast<std::ptrdiff_t>(lines.size());
  if (!(v >= lines.front())) return -1;
  if (v >= lines.back()) return size - 1;
  auto i =
      static_cast<std::ptrdiff_t>((v - lines.front()) / (lines.back() - lines.front()) * static_cast<double>(size - 1));
  i = std::clamp<std::ptrdiff_t>(i, 0, size - 2);
  for (int tries = 0; tries < 4; ++tries) {
    if (v < lines[static_cast<std::size_t>(i)])
      --i;
    else if (v >= lines[static_cast<std::size_t>(i) + 1])
      ++i;
    else
      return i;
  }
  return std::upper_bound(lines.begin(), lines.end(), v) - lines.begin() - 1;
}

/// Of a leg that is not vertical: where it is at x, roughly.
double height_at(const Segment& leg, double x) {
  return leg.a.y + (leg.b.y - leg.a.y) * ((x - leg.a.x) / (leg.b.x - leg.a.x));
}

}  // namespace

unsigned CellPlan::Around::sector(int i) const {
  unsigned reached = 1U << i;
  for (int k = i; !((closed >> ((k + 1) % 4)) & 1) && !((reached >> ((k + 1) % 4)) & 1); ++k)
    reached |= 1U << ((k + 1) % 4);
  for (int k = i; !((closed >> (k % 4)) & 1) && !((reached >> ((k + 3) % 4)) & 1); k += 3)
    reached |= 1U << ((k + 3) % 4);
  return reached;
}

unsigned CellPlan::Around::towards(Point p, Point q) const {
  const unsigned wanted = quadrants_along(sign(q.x - p.x), sign(q.y - p.y)) & free;
  unsigned all = 0;
  for (int i = 0; i < 4; ++i)
    if ((wanted >> i) & 1) all |= sector(i);
  return all;
}

std::array<std::int32_t, 2> CellPlan::cells_at(const std::vector<double>& lines, double v) {
  const auto last = static_cast<std::int32_t>(line_before(lines, v));
  return {last >= 0 && lines[static_cast<std::size_t>(last)] == v ? last - 1 : last, last};
}

CellPlan::Around CellPlan::around(Point p) const {
  const auto [left, right] = columns_at(p.x);
  const auto [low, high] = rows_at(p.y);
  Around result{{{{right, high}, {left, high}, {left, low}, {right, low}}}, 0, 0};
  for (int i = 0; i < 4; ++i) result.free |= unsigned{is_free(result.cells[static_cast<std::size_t>(i)])} << i;
  const auto open = [](bool same, bool free, bool passable) { return same ? free : passable; };
  const auto& [first, second, third, fourth] = result.cells;
  const bool is_open[] = {open(low == high, is_free(first), is_open_above(fourth)),
                          open(left == right, is_free(first), is_open_right(second)),
                          open(low == high, is_free(second), is_open_above(third)),
                          open(left == right, is_free(third), is_open_right(third))};
  for (int i = 0; i < 4; ++i) result.closed |= unsigned{!is_open[i]} << i;
  return result;
}

CellPlan::Around CellPlan::around_corner(std::uint32_t x_line, std::uint32_t y_line) const {
  const auto right = static_cast<std::int32_t>(x_line), high = static_cast<std::int32_t>(y_line);
  const std::int32_t left = right - 1, low = high - 1;
  Around result{{{{right, high}, {left, high}, {left, low}, {right, low}}}, 0, 0};
  if (x_line == 0 || y_line == 0 || x_line == columns() || y_line == rows()) {
    for (int i = 0; i < 4; ++i) result.free |= unsigned{is_free(result.cells[static_cast<std::size_t>(i)])} << i;
    const bool is_open[] = {is_open_above({right, low}), is_open_right({left, high}), is_open_above({left, low}),
                            is_open_right({left, low})};
    for (int i = 0; i < 4; ++i) result.closed |= unsigned{!is_open[i]} << i;
    return result;
  }
  const std::size_t below = (y_line - 1) * words_, above = below + words_, l = x_line - 1, r = x_line;
  const auto at = [](const std::vector<std::uint64_t>& bits, std::size_t row, std::size_t column) {
    return static_cast<unsigned>((bits[row + column / 64] >> (column % 64)) & 1);
  };
  result.free = at(free_, above, r) | at(free_, above, l) << 1 | at(free_, below, l) << 2 | at(free_, below, r) << 3;
  result.closed = ~(at(open_above_, below, r) | at(open_right_, above, l) << 1 | at(open_above_, below, l) << 2 |
                    at(open_right_, below, l) << 3) &
                  15;
  return result;
}

namespace {

/// Puts pieces together that go on straight, unless another one meets them where they do.
class Pieces {
 public:
  Pieces(const CellPlan& plan, std::vector<Constraint>& pieces) : plan_(plan), pieces_(pieces), first_(pieces.size()) {}

  /// The side to the right of a cell, upwards.
  void add_right(CellPlan::Cell c) {
    const CellPlan::Cell across{c.column + 1, c.row};
    if (const auto free = free_at(c, across, plan_.is_open_right(c)))
      add({corner(c.column + 1, c.row), corner(c.column + 1, c.row + 1), !free->first, !free->second, kNone},
          {c.column + 1, c.row});
  }

  /// The side above a cell, to the right.
  void add_above(CellPlan::Cell c) {
    const CellPlan::Cell across{c.column, c.row + 1};
    if (const auto free = free_at(c, across, plan_.is_open_above(c)))
      add({corner(c.column, c.row + 1), corner(c.column + 1, c.row + 1), !free->second, !free->first, kNone},
          {c.column, c.row + 1});
  }

 private:
  struct Free {
    bool first, second;
  };

  /// Nothing where no piece stands.
  std::optional<Free> free_at(CellPlan::Cell c, CellPlan::Cell across, bool open) const {
    if (open) return std::nullopt;
    const Free free{plan_.is_free(c), plan_.is_free(across)};
    return free.first || free.second ? std::optional(free) : std::nullopt;
  }

  Point corner(std::int32_t x, std::int32_t y) const {
    return {plan_.x(static_cast<std::size_t>(x)), plan_.y(static_cast<std::size_t>(y))};
  }

  void add(const Constraint& piece, CellPlan::Cell from) {
    for (std::size_t i = pieces_.size(); i > first_ && i + kBack > pieces_.size(); --i)
      if (continues(pieces_[i - 1], piece, from)) {
        pieces_[i - 1].b = piece.b;
        return;
      }
    pieces_.push_back(piece);
  }

  bool continues(const Constraint& before, const Constraint& piece, CellPlan::Cell from) const {
    const bool vertical = piece.a.x == piece.b.x;
    if (before.b != piece.a || (before.a.x == before.b.x) != vertical || before.solid_left != piece.solid_left ||
        before.solid_right != piece.solid_right)
      return false;
    const CellPlan::Around around =
        plan_.around_corner(static_cast<std::uint32_t>(from.column), static_cast<std::uint32_t>(from.row));
    // What stands across: a ray to the right or left of a vertical piece, above or below a level one, that bounds
    // something free.
    for (int ray = vertical ? 0 : 1; ray < 4; ray += 2)
      if (((around.closed >> ray) & 1) && ((around.free >> ray) & 1 || (around.free >> ((ray + 3) % 4)) & 1))
        return false;
    return true;
  }

  static constexpr std::size_t kBack = 6;  // how far back to look for what a piece continues

  const CellPlan& plan_;
  std::vector<Constraint>& pieces_;
  std::size_t first_;
};

}  // namespace

void CellPlan::append_along(const Segment& leg, std::vector<Constraint>& pieces) const {
  const auto [left, right] = std::minmax(leg.a.x, leg.b.x);
  const auto [low, high] = std::minmax(leg.a.y, leg.b.y);
  const std::int32_t first = columns_at(left)[0], last = columns_at(right)[1];
  const double reach = 1e-9 * (std::abs(low) + std::abs(high) + (right - left) + (high - low));
  Pieces found(*this, pieces);
  std::int32_t last_low = 0, last_high = -1;  // the rows of the column before
  for (std::int32_t column = std::max(first, 0); column <= std::min(last, static_cast<std::int32_t>(columns()) - 1);
       ++column) {
    double from = low, to = high;
    if (low != high && right - left > 0) {
      const double y0 = height_at(leg, std::max(left, x(static_cast<std::size_t>(column)))),
                   y1 = height_at(leg, std::min(right, x(static_cast<std::size_t>(column) + 1)));
      from = std::max(low, std::min(y0, y1) - reach);
      to = std::min(high, std::max(y0, y1) + reach);
    }
    const std::int32_t bottom = std::max(rows_at(from)[0], 0),
                       top = std::min(rows_at(to)[1], static_cast<std::int32_t>(rows()) - 1);
    for (std::int32_t row = bottom; row <= top; ++row)
      if (row < last_low || row > last_high) found.add_right({column - 1, row});
    for (std::int32_t row = bottom - 1; row <= top; ++row) found.add_above({column, row});
    for (std::int32_t row = bottom; row <= top; ++row) found.add_right({column, row});
    last_low = bottom;
    last_high = top;
  }
}

void CellPlan::append_within(const Box& box, std::vector<Constraint>& pieces) const {
  Pieces found(*this, pieces);
  const std::int32_t left = std::max(columns_at(box.min.x)[0], 0), bottom = std::max(rows_at(box.min.y)[0], 0),
                     right = std::min(columns_at(box.max.x)[1], static_cast<std::int32_t>(columns()) - 1),
                     top = std::min(rows_at(box.max.y)[1], static_cast<std::int32_t>(rows()) - 1);
  for (std::int32_t row = bottom - 1; row <= top; ++row)
    for (std::int32_t column = left; column <= right; ++column) found.add_above({column, row});
  for (std::int32_t column = left - 1; column <= right; ++column)
    for (std::int32_t row = bottom; row <= top; ++row) found.add_right({column, row});
}

}  // namespace taut
