#include <taut/io/pictures/detail/height_lines.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace taut::detail {

namespace {

struct Place {
  double x, y;
};

// Corners of a square in turn; side k goes from corner k to the next.
constexpr std::array<std::array<int, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

class Square {
 public:
  Square(const Heights& heights, int i, int j, double height) : i_(i), j_(j), height_(height) {
    for (std::size_t k = 0; k < 4; ++k) at_[k] = heights(i + kCorners[k][0], j + kCorners[k][1]);
  }

  bool is_whole() const {
    return std::ranges::all_of(at_, [](double h) { return std::isfinite(h); });
  }

  /// Calls visit with both ends of each piece of the line.
  template <typename Visit>
  void pieces(Visit visit) const {
    std::array<std::size_t, 4> crossed{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k)
      if (above(k) != above((k + 1) % 4)) crossed[count++] = k;
    if (count == 2) visit(on_side(crossed[0]), on_side(crossed[1]));
    if (count != 4) return;
    // Corner 0 is cut off where the middle is not on its side of the line; else its neighbours are.
    const bool cut_off = above(0) != (at_[0] + at_[1] + at_[2] + at_[3] >= 4 * height_);
    visit(on_side(0), on_side(cut_off ? 3 : 1));
    visit(on_side(2), on_side(cut_off ? 1 : 3));
  }

 private:
  bool above(std::size_t k) const { return at_[k] >= height_; }
  Place on_side(std::size_t k) const {
    const std::size_t to = (k + 1) % 4;
    const double part = (height_ - at_[k]) / (at_[to] - at_[k]);
    return {i_ + kCorners[k][0] + part * (kCorners[to][0] - kCorners[k][0]),
            j_ + kCorners[k][1] + part * (kCorners[to][1] - kCorners[k][1])};
  }

  int i_, j_;
  double height_;
  std::array<double, 4> at_{};
};

}  // namespace

double contour_interval(double greatest) {
  const double unit = std::pow(10, std::floor(std::log10(std::max(greatest, 1e-9) / 8)));
  for (const double times : {5.0, 2.0})
    if (greatest / (unit * times) >= 8) return unit * times;
  return unit;
}

std::string height_line(const Heights& heights, double height, double side, double x, double y) {
  std::string out;
  for (int j = 0; j + 1 < heights.rows; ++j)
    for (int i = 0; i + 1 < heights.columns; ++i)
      if (const Square square(heights, i, j, height); square.is_whole())
        square.pieces([&](Place a, Place b) {
          out += fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", x + side * a.x, y + side * a.y, x + side * b.x,
                             y + side * b.y);
        });
  return out;
}

}  // namespace taut::detail
