#include <taut/verify/world.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>

namespace taut::proof {

World::World(const std::string& text, Int scale) {
  std::istringstream lines(text);
  std::vector<Edge> all;
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
    for (std::size_t i = 0; i + wall < ring.size(); ++i) all.push_back({ring[i], ring[(i + 1) % ring.size()], !wall});
  }
  if (!(unit > 0) || all.empty()) throw BadInput("the world's text has no unit or no edges");
  edges = Tree(all);
  std::set<Place> ends;
  for (const Edge& e : all) ends.insert({e.a, e.b});
  for (const Place p : ends) {
    const std::vector<Edge> out = leaving(p);
    for (const Edge& right : out)
      for (const Edge& left : out) {
        const auto is_within = [&](const Edge& e) {  // and has no solid where the path would go
          const int from = side(p, right.b, e.b), to = side(p, e.b, left.b);
          return from >= 0 && to >= 0 && (side(p, right.b, left.b) > 0 || dot(right.b - p, e.b - p) > 0) &&
                 !(e.is_side && to == 0);
        };
        if (std::ranges::all_of(out, is_within)) corners[p] = {p, right.b - p, left.b - p};
      }
  }
}

bool is_hidden(const Box& box, Place u, const std::vector<Edge>& edges, const Edge* last) {
  for (auto e = edges.rbegin(); e != edges.rend(); ++e) {
    const bool extends =
        last ? (e->a == last->b || side(u, last->b, e->a) < 0) && side(u, last->b, e->b) > 0 : box.is_left(u, e->a - u);
    if (extends && box.is_left(e->b, e->a - e->b)) return box.is_left(u, u - e->b) || is_hidden(box, u, edges, &*e);
  }
  return false;
}

bool World::joins(Place p, Place q) const {
  return std::ranges::any_of(leaving(p), [q](const Edge& e) { return e.holds(q); });
}

std::vector<Edge> World::leaving(Place p) const {
  std::vector<Edge> out;
  const auto is_away = [&](const Box& b) { return !b.holds(p); };
  edges.find(p, is_away, [&](const Edge& e) {
    if (e.holds(p) && p != e.b) out.push_back({p, e.b, e.is_side});
    if (e.holds(p) && p != e.a) out.push_back({p, e.a});
    return false;
  });
  return out;
}

const Edge* World::leg(const Corner& from, const Corner& to, int closed_at_u, int closed_at_v) const {
  const Place u = from.at, v = to.at, d = v - u, back = u - v, low = least(u, v), high = most(u, v);
  const Wide length = dot(d, d);
  // From, to, and whether it closes the left, the right.
  std::vector<std::array<Wide, 4>> contacts{{0, 0, closed_at_u & 1, closed_at_u & 2},
                                            {length, length, closed_at_v & 1, closed_at_v & 2}};
  if (from.is_end() && is_solid(u, d, 1) && is_solid(u, d, -1)) return &closed;
  const auto add = [&](Wide begin, Wide end, bool left, bool right) {
    const bool aside = begin == end && ((begin == 0 && from.is_end()) || (end == length && to.is_end()));
    if (begin <= end && end >= 0 && begin <= length && !aside)
      contacts.push_back({begin, end, Wide{left}, Wide{right}});
  };
  const auto is_away = [&](const Box& b) {
    return b.min.x > high.x || b.min.y > high.y || b.max.x < low.x || b.max.y < low.y || b.is_left(u, d) ||
           b.is_left(u, back);
  };
  const Edge* const crossing = edges.find(u, is_away, [&](const Edge& e) {
    const int a = side(u, v, e.a), b = side(u, v, e.b);
    if (a * b > 0) return false;
    const int at_u = side(e.a, e.b, u), at_v = side(e.a, e.b, v);
    const Wide at_a = dot(d, e.a - u), at_b = dot(d, e.b - u);
    if (a == 0 && b == 0) {
      const Wide begin = std::max<Wide>(std::min(at_a, at_b), 0), end = std::min(std::max(at_a, at_b), length);
      const bool solid = e.is_side && begin < end;
      add(begin, end, solid && at_a < at_b, solid && at_a > at_b);
    } else if (a * b == 0) {
      add(a == 0 ? at_a : at_b, a == 0 ? at_a : at_b, a + b > 0, a + b < 0);
    } else if (at_u * at_v == 0) {
      add(at_u == 0 ? 0 : length, at_u == 0 ? 0 : length, true, true);
    }
    return a * b < 0 && at_u * at_v < 0;
  });
  if (crossing) return crossing;
  std::sort(contacts.begin(), contacts.end());
  Wide reach = -1, left = 0, right = 0;  // of the component
  for (const auto& [begin, end, closes_left, closes_right] : contacts) {
    if (begin > reach) left = right = 0;
    reach = std::max(reach, end), left |= closes_left, right |= closes_right;
    if (left != 0 && right != 0) return &closed;
  }
  return nullptr;
}

// By the sides above: how many solids are around the place, less the areas, which do not overlap.
bool World::is_solid(Place p, Place d, int shift) const {
  int around = has_area_ ? 1 : 0;
  const Int ahead = d.x != 0 ? d.x : -shift * d.y;
  const auto is_left = [&](Place q) { return q.x != p.x ? q.x < p.x : ahead > 0; };
  for (const Edge& e : edges.items) {
    if (!e.is_side || is_left(e.a) == is_left(e.b)) continue;
    int at = side(e.a, e.b, p);
    if (at == 0) at = sign(cross(e.b - e.a, d));
    if (at == 0) at = dot(e.b - e.a, d) > 0 ? shift : -shift;
    if ((e.a.x < e.b.x) == (at < 0)) around += at;
  }
  return around > 0;
}

}  // namespace taut::proof
