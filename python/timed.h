// Rows time, x, y: the ways of those who move.
#pragma once

#include <string>
#include <vector>

#include <taut/python/bind.h>
#include <taut/robots/fleet/fleet.h>

namespace taut::python {

/// From (n, 3), n >= 1, times ascending strictly. Throws InputError, which begins with `who`.
std::vector<fleet::TimedPoint> timed_points_of(py::handle rows, const std::string& who);

}  // namespace taut::python
