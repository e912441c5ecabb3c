#include <taut/geometry/written_places.h>

#include <vector>

#include <taut/geometry/box_index.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

/// Sloped ones do where crossings are rounded, and those whose line is no multiple of the unit.
bool may_bend(const Segment& s, const DecimalUnit& unit) {
  if (s.a.x != s.b.x && s.a.y != s.b.y) return true;
  const double line = s.a.x == s.b.x ? s.a.x : s.a.y;
  return unit.nearest(meaning(line)) != line;
}

void add_ring(const Ring& ring, const DecimalUnit& unit, std::vector<Segment>& to) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (const Segment side{ring[j], ring[i]}; may_bend(side, unit)) to.push_back(side);
}

/// Walls of no thickness and sides: what a point can stand on as written.
std::vector<Segment> bending_sides(const World& world) {
  const DecimalUnit unit(world.box());
  std::vector<Segment> result;
  for (const Wall& wall : world.walls())
    if (const Segment s{wall.a, wall.b}; wall.thickness == 0 && may_bend(s, unit)) result.push_back(s);
  for (const auto* areas : {&world.areas(), &world.solids()})
    for (const Area& area : *areas) {
      add_ring(area.polygon.outer, unit, result);
      for (const Ring& hole : area.polygon.holes) add_ring(hole, unit, result);
    }
  return result;
}

std::vector<Box> boxes_around(const std::vector<Segment>& sides) {
  std::vector<Box> boxes;
  boxes.reserve(sides.size());
  for (const Segment& s : sides) boxes.push_back(box_around(s.a, s.b));
  return boxes;
}

}  // namespace

struct WrittenPlaces::Impl {
  explicit Impl(const FreeSpace& s)
      : space(s),
        sides(s.displacement() > 0 && s.footprint().kind() == Footprint::Kind::point ? bending_sides(s.world())
                                                                                     : std::vector<Segment>{}),
        index(boxes_around(sides)) {}

  FreeSpace space;
  std::vector<Segment> sides;
  BoxIndex index;
};

WrittenPlaces::WrittenPlaces(const FreeSpace& space) : impl_(std::make_shared<const Impl>(space)) {}

bool WrittenPlaces::is_moved(Point p) const {
  if (impl_->sides.empty()) return false;
  bool stands = false;
  impl_->index.meeting({p, p}, [&](std::uint32_t i) {
    stands = stands || written::on_segment(p, impl_->sides[i].a, impl_->sides[i].b);
  });
  if (!stands) return false;
  const Location::Kind kind = impl_->space.locate(p).kind;
  return kind == Location::Kind::triangle || kind == Location::Kind::outside;
}

}  // namespace taut
