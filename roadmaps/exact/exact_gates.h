// What Gates keeps: exact widths and shapes, and what the gates connect.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <vector>

#include <taut/roadmaps/exact/gate_shape.h>
#include <taut/roadmaps/gates.h>
#include <taut/roadmaps/wall_index.h>

namespace taut {

/// All vectors are in the order of Gates::gates().
struct ExactGates {
  WallIndex walls;
  std::vector<Gate> gates;
  std::vector<GateShape> shapes;
  /// Squares of the widths, those to openings doubled first.
  std::vector<Rational> squared;
  /// The vertices that a gate connects: its end, and its foot or facing's a.
  std::vector<std::array<std::uint32_t, 2>> nodes;
};

}  // namespace taut
