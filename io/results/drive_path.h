// A car's drive as a path to be written.
#pragma once

#include <vector>

#include <taut/io/results/path_file.h>
#include <taut/robots/car/leg.h>

namespace taut {

/// Where the reference point goes, straight pieces and arcs; arcs also as points, so many that legs between them are no
/// farther from the arc than a thousandth of its radius. Columns: `heading` in degrees, from the x-axis, at each point,
/// and `gear`, 1 or -1, by which it came there (of the first point: by which it leaves).
PathToWrite drive_path(const std::vector<car::Leg>& legs, const car::LatticePose& start, double length);

}  // namespace taut
