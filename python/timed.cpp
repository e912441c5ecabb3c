#include <taut/python/timed.h>

#include <cmath>

namespace taut::python {

std::vector<fleet::TimedPoint> timed_points_of(py::handle rows, const std::string& who) {
  const Doubles array = rows_of(rows, 3, who.c_str());
  std::vector<fleet::TimedPoint> points;
  const auto values = array.unchecked<2>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    points.push_back({values(i, 0), {values(i, 1), values(i, 2)}});
    if (!std::isfinite(points.back().time) || !is_in_reach(points.back().at))
      throw InputError("", 0, who + ": not all rows are a time and a point");
    if (i > 0 && !(points[points.size() - 2].time < points.back().time))
      throw InputError("", 0, who + ": times do not ascend");
  }
  if (points.empty()) throw InputError("", 0, who + ": has no rows");
  return points;
}

}  // namespace taut::python
