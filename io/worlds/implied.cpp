#include <taut/io/worlds/detail/implied.h>

#include <utility>

namespace taut::detail {

namespace {

WorldParts parts_of(const World& world) {
  WorldParts parts;
  parts.walls = world.walls();
  parts.solids = world.solids();
  parts.start = world.start();
  parts.goal = world.goal();
  parts.uncertainty = world.uncertainty();
  return parts;
}

bool same_areas(const World& a, const World& b) {
  if (a.areas().size() != b.areas().size()) return false;
  for (std::size_t i = 0; i < a.areas().size(); ++i)
    if (a.areas()[i].polygon != b.areas()[i].polygon) return false;
  return true;
}

}  // namespace

bool area_is_implied(const World& world) {
  if (world.walls().empty() && world.solids().empty()) return false;
  const World bare(parts_of(world));
  return bare.boundary() == world.boundary() && same_areas(bare, world);
}

bool ends_are_implied(const World& world) {
  if (world.boundary() != Boundary::limit || world.openings().size() != 2) return false;
  WorldParts parts = parts_of(world);
  parts.areas = world.areas();
  parts.start.reset();
  parts.goal = {};
  const World bare(std::move(parts));
  return bare.start() == world.start() && bare.goal().point == world.goal().point && world.goal().room.empty();
}

}  // namespace taut::detail
