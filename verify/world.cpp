#include <taut/verify/world.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>

namespace taut::proof {

// Calls visit(cell) for all cells that the segment meets, from p on, until it says true: column by column, in each the
// rows between where the segment enters and leaves it, a row more where that is rounded.
template <class Visit>
bool World::cells(Place p, Place q, Visit visit) const {
  const Int from = (p.x - low.x) / size_, to = (q.x - low.x) / size_, step = from <= to ? 1 : -1;
  const Int first = (p.y - low.y) / size_, last = (q.y - low.y) / size_, up = p.y <= q.y ? 1 : -1;
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
    if (!line.starts_with("start ") && !line.starts_with("goal "))
      for (const char c : line + '\n') hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    Real below = 1;
    if (std::sscanf(line.c_str(), "unit %Lf/%Lf", &unit, &below) > 0) unit /= below * static_cast<Real>(scale);
    if (word == "taut" || word == "unit" || word == "boundary" || word == "start" || word == "goal") continue;
    std::vector<Place> ring;
    for (Place p; fields >> p.x >> p.y; ring.push_back({p.x * scale, p.y * scale}))
      if (scale < 1 || std::hypot(static_cast<Real>(p.x), p.y) > static_cast<Real>(kLargest / scale))
        throw BadInput("coordinates, with the certificate's scale, are out of range");
    const bool hole = word == "hole", wall = word == "wall" && ring.size() == 2;
    if (!fields.eof() || !(wall || (ring.size() > 2 && (hole || word == "area" || word == "solid"))))
      throw BadInput("the world's text cannot be read at '" + line.substr(0, 40) + "'");
    has_area_ |= (area = word == "area" || ((hole || wall) && area));
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    if (side(ring.back(), ring[0], ring[1]) != (hole ? -1 : wall ? 0 : 1))
      throw BadInput("a ring goes the wrong way round");
    if (area) std::reverse(ring.begin(), ring.end());
    for (std::size_t i = 0; i + wall < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()], !wall});
  }
  if (!(unit > 0) || edges.empty()) throw BadInput("the world's text has no unit or no edges");
  low = high = edges.front().a;
  for (const Edge& e : edges) low = least(low, least(e.a, e.b)), high = most(high, most(e.a, e.b));
  const double longer = static_cast<double>(std::max(high.x - low.x, high.y - low.y));
  size_ = static_cast<Int>(longer / std::sqrt(static_cast<double>(edges.size()))) + 1;
  columns_ = (high.x - low.x) / size_ + 1, rows_ = (high.y - low.y) / size_ + 1;
  grid_.resize(static_cast<std::size_t>(columns_ * rows_));  // about as many cells as edges
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    cells(edges[i].a, edges[i].b, [&](std::size_t cell) { return grid_[cell].push_back(i), false; });
  find_corners();
}

std::string World::text(Place p) const {
  char out[80];
  std::snprintf(out, sizeof out, "(%.12Lg, %.12Lg)", unit * p.x, unit * p.y);
  return out;
}

bool World::joins(Place p, Place q) const {
  return std::any_of(edges.begin(), edges.end(), [&](const Edge& e) { return e.holds(p) && e.holds(q); });
}

void World::find_corners() {
  std::map<Place, std::vector<Edge>> ends;  // and what leaves them; sides are those with their solid on the left
  for (const Edge& e : edges)
    if (e.a != e.b) ends[e.a].push_back(e), ends[e.b].push_back({e.b, e.a});
  for (const auto& [end, leaving] : ends) {
    const Place p = end;
    bool bends = !cells(p, p, [&](std::size_t cell) {
      const auto passes = [&](std::uint32_t i) { return edges[i].a != p && edges[i].b != p && edges[i].holds(p); };
      return std::any_of(grid_[cell].begin(), grid_[cell].end(), passes);
    });
    Corner corner{p, leaving[0].b - p, leaving[0].b - p};
    for (const Edge& e : leaving) {
      if (cross(corner.left, e.b - p) > 0) corner.left = e.b - p;
      if (cross(corner.right, e.b - p) < 0) corner.right = e.b - p;
    }
    for (const Edge& e : leaving) {
      const Place d = e.b - p;
      const int l = sign(cross(d, corner.left)), r = sign(cross(corner.right, d));
      bends &= l >= 0 && r >= 0 && (l > 0 || dot(d, corner.left) > 0) && (r > 0 || dot(d, corner.right) > 0) &&
               !(e.is_side && l == 0);  // its solid is where the path would go
    }
    if (bends) corners.push_back(corner);
  }
}

int World::leg(const Corner& from, const Corner& to, int turn_at_u, int turn_at_v) const {
  std::vector<std::array<Wide, 4>> contacts;  // from, to, and whether it closes the left, the right
  const Place u = from.at, v = to.at, d = v - u;
  const Wide length = dot(d, d);
  if (from.is_end() && is_solid(u, d, 1) && is_solid(u, d, -1)) return kClosed;
  const auto add = [&](Wide begin, Wide end, bool left, bool right) {
    const bool aside = begin == end && ((begin == 0 && from.is_end()) || (end == length && to.is_end()));
    if (begin <= end && end >= 0 && begin <= length && !aside)
      contacts.push_back({begin, end, Wide{left}, Wide{right}});
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
  std::sort(contacts.begin(), contacts.end());
  Wide reach = -1, left = 0, right = 0;  // of the component
  for (const auto& [begin, end, closes_left, closes_right] : contacts) {
    if (begin > reach) left = right = 0;
    reach = std::max(reach, end), left |= closes_left, right |= closes_right;
    if ((left & right) != 0) return kClosed;
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
