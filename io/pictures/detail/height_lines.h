// Contour lines of heights on a grid of points.
#pragma once

#include <string>
#include <vector>

namespace taut::detail {

/// Heights by rows; where one is infinite there is none.
struct Heights {
  int columns = 0, rows = 0;
  std::vector<double> of;

  double operator()(int i, int j) const {
    return of[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
  }
};

/// A round distance of lines (1, 2 or 5 times a power of ten) that makes 8 to 20 of them up to `greatest`.
double contour_interval(double greatest);

/// Path data of the line of one height, points `side` apart, the first at (x, y): straight through each square of four
/// points with heights, between the places on its sides where linear interpolation has that height; a saddle is split
/// by the mean of its corners. A corner of exactly that height counts as above. Neighbouring squares agree, so lines
/// end only where heights do.
std::string height_line(const Heights& heights, double height, double side, double x, double y);

}  // namespace taut::detail
