// What Gates keeps.
#pragma once

#include <gmpxx.h>

#include <vector>

#include <taut/roadmaps/exact/gate_shape.h>
#include <taut/roadmaps/gates.h>
#include <taut/roadmaps/wall_index.h>

namespace taut {

struct Gates::Impl {
  detail::GateWalls walls;
  std::vector<Gate> gates;
  std::vector<detail::GateShape> shapes;
  std::vector<mpq_class> squared;  // widths, those to openings doubled first
  std::vector<std::array<std::uint32_t, 2>>
      nodes;  // the vertices that the gate connects: its end, and its foot or facing's a
};

}  // namespace taut
