#include <algorithm>
#include <utility>
#include <vector>

#include <taut/io/saved/detail/fnv.h>
#include <taut/io/saved/roadmap_file.h>

namespace taut {

namespace {

using Rings = std::vector<Ring>;  // the outer one first

Ring turned(Ring ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

// In an order of their own, whatever the file's was.
std::vector<Rings> sorted(const std::vector<Area>& areas) {
  std::vector<Rings> all;
  for (const Area& area : areas) {
    Rings rings{turned(area.polygon.outer)};
    for (const Ring& hole : area.polygon.holes) rings.push_back(turned(hole));
    std::sort(rings.begin() + 1, rings.end());
    all.push_back(std::move(rings));
  }
  std::sort(all.begin(), all.end());
  return all;
}

void add(detail::Fnv& hash, Point p) {
  hash.add(p.x);
  hash.add(p.y);
}

void add(detail::Fnv& hash, const std::vector<Area>& areas) {
  hash.add(std::uint64_t{areas.size()});
  for (const Rings& rings : sorted(areas)) {
    hash.add(std::uint64_t{rings.size()});
    for (const Ring& ring : rings) {
      hash.add(std::uint64_t{ring.size()});
      for (const Point p : ring) add(hash, p);
    }
  }
}

void add(detail::Fnv& hash, const std::vector<Wall>& walls) {
  std::vector<std::pair<std::pair<Point, Point>, double>> all;
  all.reserve(walls.size());
  for (const Wall& wall : walls) all.emplace_back(std::minmax(wall.a, wall.b), wall.thickness);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  hash.add(std::uint64_t{all.size()});
  for (const auto& [ends, thickness] : all) {
    add(hash, ends.first);
    add(hash, ends.second);
    hash.add(thickness);
  }
}

}  // namespace

std::string fingerprint(const World& world) {
  detail::Fnv hash;
  hash.add(std::string_view("taut world 1"));
  hash.add(static_cast<std::uint64_t>(world.boundary()));
  add(hash, world.areas());
  add(hash, world.walls());
  add(hash, world.solids());
  return hash.hex();
}

}  // namespace taut
