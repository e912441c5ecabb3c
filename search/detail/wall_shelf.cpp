#include <taut/search/detail/wall_shelf.h>

#include <algorithm>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

bool lies_on(const Segment& stretch, const Wall& wall) {
  return written::on_segment(stretch.a, wall.a, wall.b) && written::on_segment(stretch.b, wall.a, wall.b);
}

}  // namespace

void WallShelf::add(const Wall& wall) {
  ++size_;
  thick_ += wall.thickness > 0 ? 1 : 0;
  (wall.a.x == wall.b.x ? upright_[wall.a.x] : wall.a.y == wall.b.y ? level_[wall.a.y] : sloped_).push_back(wall);
}

bool WallShelf::take_out(const Segment& stretch) {
  bool taken = take_out(stretch, sloped_);
  if (const auto line = upright_.find(stretch.a.x); line != upright_.end()) taken |= take_out(stretch, line->second);
  if (const auto line = level_.find(stretch.a.y); line != level_.end()) taken |= take_out(stretch, line->second);
  return taken;
}

bool WallShelf::take_out(const Segment& stretch, std::vector<Wall>& walls) {
  const auto touched =
      std::stable_partition(walls.begin(), walls.end(), [&](const Wall& w) { return !lies_on(stretch, w); });
  const std::vector<Wall> whole(touched, walls.end());
  walls.erase(touched, walls.end());
  for (const Wall& wall : whole) {
    --size_;
    thick_ -= wall.thickness > 0 ? 1 : 0;
    // Its end that is nearer to wall.a: the one that the other does not lie before.
    const bool turned = !written::on_segment(stretch.a, wall.a, stretch.b);
    const Point near = turned ? stretch.b : stretch.a, far = turned ? stretch.a : stretch.b;
    if (near != wall.a) add({wall.a, near, wall.thickness, wall.line});
    if (far != wall.b) add({far, wall.b, wall.thickness, wall.line});
  }
  return !whole.empty();
}

bool WallShelf::holds(const Segment& stretch) const {
  const bool is_upright = stretch.a.x == stretch.b.x;
  const Lines& lines = is_upright ? upright_ : level_;
  const auto line = lines.find(is_upright ? stretch.a.x : stretch.a.y);
  return line != lines.end() &&
         std::any_of(line->second.begin(), line->second.end(), [&](const Wall& w) { return lies_on(stretch, w); });
}

}  // namespace taut::detail
