#include <taut/verify/world.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace taut::proof {

// Calls visit(cell) for all cells that the segment meets, from p on, until it says true: column by column, in each the
// rows between where the segment enters and leaves it, a row more where that is rounded.
template <class Visit>
bool World::cells(Place p, Place q, Visit visit) const {
  const Int from = (p.x - low.x) / size_, to = (q.x - low.x) / size_;
  const Int step = from <= to ? 1 : -1, up = p.y <= q.y ? 1 : -1;
  const Int first = (p.y - low.y) / size_, last = (q.y - low.y) / size_;
  const auto row_at = [&](Int column) {
    const Int x = low.x + (column + (step < 0)) * size_;
    return (p.y - low.y + static_cast<Int>(Wide{q.y - p.y} * (x - p.x) / (q.x - p.x))) / size_;
  };
  for (Int c = from;; c += step) {
    const Int enter = c == from ? first : std::clamp<Int>(row_at(c) - up, 0, rows_ - 1);
    const Int leave = c == to ? last : std::clamp<Int>(row_at(c + step) + up, 0, rows_ - 1);
    for (Int r = enter;; r += up) {
      if (visit(static_cast<std::size_t>(r * columns_ + c))) return true;
      if (r == leave) break;
    }
    if (c == to) return false;
  }
}

World::World(const std::string& text, Int scale) {
  std::istringstream lines(text);
  bool area = false;
  for (std::string line, word; std::getline(lines, line);) {
    std::istringstream fields(line);
    fields >> word;
    if (word == "taut" || word == "boundary" || word == "start" || word == "goal") continue;
    long double below = 1;
    char slash = 0;
    if (word == "unit" && fields >> unit && fields >> slash >> below) unit /= below;
    if (word == "unit") continue;
    std::vector<Place> ring;
    for (Place p; fields >> p.x >> p.y; ring.push_back({p.x * scale, p.y * scale}))
      if (scale < 1 || std::hypot(static_cast<long double>(p.x), p.y) > static_cast<long double>(kLargest / scale))
        throw BadInput("coordinates, with the certificate's scale, are out of range");
    const bool hole = word == "hole", wall = word == "wall" && ring.size() == 2;
    if (!fields.eof() || !(wall || (ring.size() > 2 && (hole || word == "area" || word == "solid"))))
      throw BadInput("the world's text cannot be read at '" + line.substr(0, 40) + "'");
    if (wall) edges.push_back({ring[0], ring[1]});
    if (wall) continue;
    area = word == "area" || (hole && area);
    has_area_ |= area;
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    if (side(ring.back(), ring[0], ring[1]) != (hole ? -1 : 1)) throw BadInput("a ring goes the wrong way round");
    if (area) std::reverse(ring.begin(), ring.end());
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()], true});
  }
  if (!(unit > 0) || edges.empty()) throw BadInput("the world's text has no unit or no edges");
  low = high = edges.front().a;
  for (const Edge& e : edges)
    for (const Place p : {e.a, e.b}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const double width = static_cast<double>(high.x - low.x) + 1, height = static_cast<double>(high.y - low.y) + 1;
  const double count = static_cast<double>(edges.size()), longer = std::max(width, height);
  size_ = static_cast<Int>(std::max(std::sqrt(width * height / count), longer / (4 * count + 16))) + 1;
  columns_ = (high.x - low.x) / size_ + 1;
  rows_ = (high.y - low.y) / size_ + 1;
  grid_.resize(static_cast<std::size_t>(columns_ * rows_));  // about as many cells as edges
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    cells(edges[i].a, edges[i].b, [&](std::size_t cell) { return grid_[cell].push_back(i), false; });
  find_corners();
}

void World::find_corners() {
  std::vector<Place> ends;
  for (const Edge& e : edges) ends.insert(ends.end(), {e.a, e.b});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const Place p : ends) {
    std::vector<Edge> leaving;  // from p; sides are those with their solid on the left
    bool bends = true;
    cells(p, p, [&](std::size_t cell) {
      for (const std::uint32_t i : grid_[cell]) {
        const Edge& e = edges[i];
        if (e.a == p && e.b != p) leaving.push_back({p, e.b, e.is_side});
        if (e.b == p && e.a != p) leaving.push_back({p, e.a});
        if (e.a != p && e.b != p && side(e.a, e.b, p) == 0 && dot(e.a - p, e.b - p) < 0) bends = false;
      }
      return false;
    });
    Corner corner{p};
    for (const Edge& e : leaving) {
      if (corner.is_end()) corner = {p, e.b - p, e.b - p};
      if (cross(corner.left, e.b - p) > 0) corner.left = e.b - p;
      if (cross(corner.right, e.b - p) < 0) corner.right = e.b - p;
    }
    for (const Edge& e : leaving) {
      const Place d = e.b - p;
      const int l = sign(cross(d, corner.left)), r = sign(cross(corner.right, d));
      bends &= l >= 0 && r >= 0 && (l > 0 || dot(d, corner.left) > 0) && (r > 0 || dot(d, corner.right) > 0) &&
               !(e.is_side && l == 0);  // its solid is where the path would go
    }
    if (bends && !leaving.empty()) corners.push_back(corner);
  }
}

int World::leg(const Corner& from, const Corner& to, int turn_at_u, int turn_at_v) const {
  struct Contact {
    Wide from, to;
    bool left, right;
  };
  std::vector<Contact> contacts;
  const Place u = from.at, v = to.at, d = v - u;
  const Wide length = dot(d, d);
  if (from.is_end() && is_solid(u, d, 1) && is_solid(u, d, -1)) return kClosed;
  const auto add = [&](Wide begin, Wide end, bool left, bool right) {
    const bool aside = begin == end && ((begin == 0 && from.is_end()) || (end == length && to.is_end()));
    if (begin <= end && end >= 0 && begin <= length && !aside) contacts.push_back({begin, end, left, right});
  };
  int crossed = kOpen;
  const bool stopped = cells(u, v, [&](std::size_t cell) {
    for (const std::uint32_t i : grid_[cell]) {
      const Edge& e = edges[i];
      const int a = side(u, v, e.a), b = side(u, v, e.b);
      const Wide at_a = dot(d, e.a - u), at_b = dot(d, e.b - u);
      if (a == 0 && b == 0) {
        const Wide begin = std::max<Wide>(std::min(at_a, at_b), 0), end = std::min(std::max(at_a, at_b), length);
        const bool solid = e.is_side && begin < end;
        add(begin, end, solid && at_a < at_b, solid && at_a > at_b);
      } else if (a * b == 0) {
        add(a == 0 ? at_a : at_b, a == 0 ? at_a : at_b, a + b > 0, a + b < 0);
      } else if (a * b < 0) {
        const int at_u = side(e.a, e.b, u), at_v = side(e.a, e.b, v);
        crossed = static_cast<int>(i);
        if (at_u * at_v < 0) return true;
        if (at_u == 0) add(0, 0, true, true);
        if (at_v == 0) add(length, length, true, true);
      }
    }
    return false;
  });
  if (stopped) return crossed;
  if (turn_at_u != 0) add(0, 0, turn_at_u > 0, turn_at_u < 0);
  if (turn_at_v != 0) add(length, length, turn_at_v > 0, turn_at_v < 0);
  std::sort(contacts.begin(), contacts.end(), [](const Contact& c, const Contact& e) { return c.from < e.from; });
  Contact component{0, -1, false, false};
  for (const Contact& c : contacts) {
    if (c.from > component.to) component = c;
    component = {0, std::max(component.to, c.to), component.left || c.left, component.right || c.right};
    if (component.left && component.right) return kClosed;
  }
  return kOpen;
}

// By the sides above: how many solids are around the place, less the areas, which do not overlap.
bool World::is_solid(Place p, Place d, int shift) const {
  int around = has_area_ ? 1 : 0;
  const Int ahead = d.x != 0 ? d.x : -shift * d.y;
  const auto is_left = [&](Place q) { return q.x != p.x ? q.x < p.x : ahead > 0; };
  for (const Edge& e : edges) {
    if (!e.is_side || is_left(e.a) == is_left(e.b)) continue;
    int at = side(e.a, e.b, p);
    if (at == 0) at = sign(cross(e.b - e.a, d));
    if (at == 0) at = dot(e.b - e.a, d) > 0 ? shift : -shift;
    if ((e.a.x < e.b.x) == (at < 0)) around += at;
  }
  return around > 0;
}

}  // namespace taut::proof
