// Options of readers as Python's keyword arguments.
#pragma once

#include <taut/geometry/snap.h>
#include <taut/python/bind.h>

namespace taut::python {

/// None: what lies within rounding; a number: what is no farther apart, 0 nothing; 'auto'. ValueError for all else.
Snap snap_of(py::handle value);

}  // namespace taut::python
