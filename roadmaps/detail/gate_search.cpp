#include <taut/roadmaps/detail/gate_search.h>

#include <algorithm>
#include <cmath>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

/// Screens only save time; what they hide is hidden by more than rounding.
constexpr double kMargin = 1 + 1e-9;
constexpr double kSlack = 0x1p-49;
/// Coordinates are off by that part of themselves from what they mean.
constexpr double kReading = 4e-16;

}  // namespace

void GateSearch::append_gates(std::uint32_t v, std::vector<FoundGate>& to) {
  if (walls_.at(v).empty()) return;
  v_ = v;
  p_ = walls_.triangulation().points[v];
  views_.clear();
  screens_.clear();
  candidates_.clear();
  look_around(v);
  for (std::size_t i = 0; i < views_.size(); ++i) look_through(View(views_[i]));

  const auto key = [](const FoundGate& g) { return std::pair(g.facing, g.foot_vertex); };
  std::sort(candidates_.begin(), candidates_.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  const auto same = [&](const FoundGate& a, const FoundGate& b) { return key(a) == key(b); };
  candidates_.erase(std::unique(candidates_.begin(), candidates_.end(), same), candidates_.end());
  for (const FoundGate& gate : candidates_)
    if (is_empty(gate)) to.push_back(gate);
}

void GateSearch::look_around(std::uint32_t v) {
  const Triangulation& tri = walls_.triangulation();
  for (const std::uint32_t t : walls_.around(v)) {
    if (!walls_.is_open(t)) continue;
    const int i = tri.corner(t, v);
    const std::uint32_t right = tri.triangles[t][Triangulation::ccw(i)], left = tri.triangles[t][Triangulation::cw(i)];
    meet_vertex(right);
    meet_vertex(left);
    views_.push_back({t, i, right, left});
  }
}

void GateSearch::look_through(const View& view) {
  if (is_hidden(view)) return;
  const Triangulation& tri = walls_.triangulation();
  const std::uint32_t c = walls_.along(view.triangle, view.side);
  if (c != kNone) meet_side(c);
  if (c != kNone && !walls_.is_opening(c)) return;
  const std::uint32_t n = tri.neighbours[view.triangle][view.side];
  if (n == kNone) return;
  const int m = tri.mirror(view.triangle, view.side);
  const std::uint32_t z = tri.triangles[n][m];
  const Point at = tri.points[z];
  const int of_right = written::orientation(p_, tri.points[view.right], at),
            of_left = written::orientation(p_, at, tri.points[view.left]);
  if (of_right >= 0 && of_left >= 0) meet_vertex(z);
  // Seen from n, the near side runs from its corner ccw(m) on the left to cw(m) on the right.
  if (of_right >= 0) views_.push_back({n, Triangulation::ccw(m), view.right, of_left >= 0 ? z : view.left});
  if (of_left >= 0) views_.push_back({n, Triangulation::cw(m), of_right >= 0 ? z : view.right, view.left});
}

void GateSearch::meet_side(std::uint32_t constraint) {
  const bool opening = walls_.is_opening(constraint);
  if (opening && !walls_.is_wall_vertex(v_)) return;
  const auto shape = gate_to_inside(p_, walls_.segment(constraint));
  if (!shape) return;
  candidates_.push_back({*shape, v_, kNone, constraint, opening || !walls_.is_wall_vertex(v_)});
  if (opening) return;
  const auto [a, b] = walls_.segment(constraint);
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double t = std::clamp(((p_.x - a.x) * ux + (p_.y - a.y) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
  const double x = a.x - p_.x + t * ux, y = a.y - p_.y + t * uy;
  // Nearer than that, rounding might have moved the point off the wall by too much.
  if (std::hypot(x, y) > 1e-5 * (std::hypot(a.x - p_.x, a.y - p_.y) + std::hypot(ux, uy))) add_screen(x, y);
}

void GateSearch::meet_vertex(std::uint32_t z) {
  const Point at = walls_.triangulation().points[z];
  const bool walls[] = {walls_.is_wall_vertex(v_), walls_.is_wall_vertex(z)};
  if (v_ < z && (walls[0] || walls[1]) && !is_hidden(at.x - p_.x, at.y - p_.y))
    candidates_.push_back({{p_, {at, at}}, v_, z, kNone, !(walls[0] && walls[1])});
  if (walls[1]) add_screen(at.x - p_.x, at.y - p_.y);
}

void GateSearch::add_screen(double x, double y) {
  if (is_hidden(x, y)) return;
  const double reach = std::abs(x) + std::abs(y);
  screens_.push_back({x, y, (x * x + y * y) * kMargin + kReading * (reach + std::abs(p_.x) + std::abs(p_.y)) * reach});
}

bool GateSearch::is_hidden(double x, double y) const {
  const double here = std::abs(p_.x) + std::abs(p_.y), far = std::abs(x) + std::abs(y);
  return std::any_of(screens_.begin(), screens_.end(), [&](const Screen& s) {
    const double reach = far + std::abs(s.x) + std::abs(s.y);
    const double slack = kSlack * (std::abs(s.x * x) + std::abs(s.y * y)) + kReading * (here + reach) * reach;
    return s.x * x + s.y * y - slack >= s.limit * kMargin;
  });
}

/// Clips the side to the view and to what no screen hides.
bool GateSearch::is_hidden(const View& view) const {
  const Triangulation& tri = walls_.triangulation();
  const auto& corners = tri.triangles[view.triangle];
  const Point a = tri.points[corners[Triangulation::ccw(view.side)]],
              b = tri.points[corners[Triangulation::cw(view.side)]];
  const double ax = a.x - p_.x, ay = a.y - p_.y, ux = b.x - a.x, uy = b.y - a.y;
  const double here = std::abs(p_.x) + std::abs(p_.y);
  double lo = 0, hi = 1;
  // What is left of the side: (a + t u) (x, y) <= limit, a little more for rounding.
  const auto keep = [&](double x, double y, double limit) {
    const double size = std::abs(ax * x) + std::abs(ay * y) + std::abs(ux * x) + std::abs(uy * y);
    const double reach = std::abs(ax) + std::abs(ay) + std::abs(ux) + std::abs(uy) + std::abs(x) + std::abs(y);
    const double slack = kSlack * size + kReading * (here + reach) * reach;
    const double at_a = ax * x + ay * y - limit - slack, rise = ux * x + uy * y;
    if (rise > 0) hi = std::min(hi, -at_a / rise + 1e-12);
    if (rise < 0) lo = std::max(lo, -at_a / rise - 1e-12);
    return (rise != 0 || at_a <= 0) && lo <= hi;
  };
  const Point r = tri.points[view.right], l = tri.points[view.left];
  if (!keep(r.y - p_.y, p_.x - r.x, 0) || !keep(p_.y - l.y, l.x - p_.x, 0)) return true;
  return !std::all_of(screens_.begin(), screens_.end(), [&](const Screen& s) { return keep(s.x, s.y, s.limit); });
}

bool GateSearch::is_empty(const FoundGate& gate) const {
  return gate.to_opening ? is_nearest_to_opening(gate) : is_empty_between_walls(gate);
}

/// Is no wall nearer to the place on the opening than the gate's?
bool GateSearch::is_nearest_to_opening(const FoundGate& gate) const {
  const bool from_opening = !walls_.is_wall_vertex(v_);
  const Point foot = nearest_foot(gate.shape), centre = from_opening ? p_ : foot;
  const double radius = std::hypot(foot.x - p_.x, foot.y - p_.y);
  const double reach = radius + 0x1p-48 * (std::abs(centre.x) + std::abs(centre.y) + radius);
  bool nearest = true;
  walls_.walls_meeting(
      {{centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}},
      [&](std::uint32_t c) { nearest = nearest && !nearer_than_gate(gate.shape, from_opening, walls_.segment(c)); });
  return nearest;
}

/// Does no wall but those at its ends touch the gate's disc?
bool GateSearch::is_empty_between_walls(const FoundGate& gate) const {
  const GateShape& shape = gate.shape;
  const Point foot = nearest_foot(shape);
  const double radius = std::hypot(foot.x - p_.x, foot.y - p_.y) / 2;
  const double mx = (foot.x + p_.x) / 2, my = (foot.y + p_.y) / 2;
  const double reach = radius + 0x1p-48 * (std::abs(mx) + std::abs(my) + radius);
  bool empty = true;
  walls_.walls_meeting({{mx - reach, my - reach}, {mx + reach, my + reach}}, [&](std::uint32_t c) {
    if (!empty || c == gate.facing) return;
    const Segment wall = walls_.segment(c);
    const auto [a, b] = walls_.ends()[c];
    const bool at_end = a == v_ || b == v_,
               at_foot = gate.foot_vertex != kNone && (a == gate.foot_vertex || b == gate.foot_vertex);
    empty = at_end    ? !disc_entered(shape, p_, wall)
            : at_foot ? !disc_entered(shape, shape.facing.a, wall)
                      : !disc_meets(shape, wall);
  });
  return empty;
}

}  // namespace taut::detail
