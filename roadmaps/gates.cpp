#include <taut/roadmaps/gates.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include <taut/geometry/segment_distance.h>
#include <taut/roadmaps/detail/gate_search.h>
#include <taut/roadmaps/exact/exact_gates.h>

namespace taut {

namespace {

std::strong_ordering compare(const Rational& a, const Rational& b) { return cmp(a, b) <=> 0; }

std::vector<detail::FoundGate> find_gates(const WallIndex& walls) {
  std::vector<detail::FoundGate> found;
  detail::GateSearch search(walls);
  for (std::uint32_t v = 0; v < walls.triangulation().points.size(); ++v) search.append_gates(v, found);
  return found;
}

Rational squared(const detail::FoundGate& found) {
  const Rational square = squared_width(found.shape);
  return found.to_opening ? Rational(4 * square) : square;
}

Gate gate_of(const detail::FoundGate& found, const WallIndex& walls) {
  const auto lowest = [&](std::uint32_t v) { return walls.at(v).front(); };
  const bool foot_is_end = found.facing == kNone;
  const Segment end{found.shape.end, found.shape.end};
  return {.end = found.shape.end,
          .foot = nearest_foot(found.shape),
          .constraint = lowest(found.vertex),
          .facing = foot_is_end ? lowest(found.foot_vertex) : found.facing,
          .foot_is_end = foot_is_end,
          .foot_is_exact = found.shape.exact(),
          .to_opening = found.to_opening,
          .width = segment_distance(end, found.shape.facing) * (found.to_opening ? 2 : 1)};
}

/// The order of the gates: widths exactly, then by place.
std::vector<std::uint32_t> order_of(const std::vector<Rational>& squares, const std::vector<Gate>& gates) {
  std::vector<double> rough;
  rough.reserve(squares.size());
  for (const Rational& q : squares) rough.push_back(to_double(q));
  std::vector<std::uint32_t> order(gates.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t i) { return std::tuple(gates[i].end, gates[i].foot, gates[i].facing); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    // Truncated doubles: off by less than one ulp each.
    if (std::abs(rough[i] - rough[j]) > 0x1p-50 * (rough[i] + rough[j])) return rough[i] < rough[j];
    if (const int sign = cmp(squares[i], squares[j]); sign != 0) return sign < 0;
    return place(i) < place(j);
  });
  return order;
}

/// The distance of two points, when it is a fraction with a small denominator.
std::optional<std::string> printed_distance(Point p, Point q, int times) {
  const ExactPoint from(p), to(q);
  const Rational dx = from.x - to.x, dy = from.y - to.y, square = dx * dx + dy * dy;
  if (!is_square(numerator(square)) || !is_square(denominator(square))) return std::nullopt;
  const Rational root = times * fraction(sqrt(numerator(square)), sqrt(denominator(square)));
  return denominator(root) <= 1000 ? std::optional(text_of(root)) : std::nullopt;
}

}  // namespace

Gates::Gates(const FreeSpace& space) {
  auto exact = std::make_shared<ExactGates>(ExactGates{WallIndex(space), {}, {}, {}, {}});
  const std::vector<detail::FoundGate> found = find_gates(exact->walls);
  std::vector<Gate> gates;
  std::vector<Rational> squares;
  for (const detail::FoundGate& one : found) {
    gates.push_back(gate_of(one, exact->walls));
    squares.push_back(squared(one));
  }
  for (const std::uint32_t i : order_of(squares, gates)) {
    const std::uint32_t foot =
        found[i].facing == kNone ? found[i].foot_vertex : exact->walls.ends()[found[i].facing][0];
    exact->gates.push_back(gates[i]);
    exact->shapes.push_back(found[i].shape);
    exact->squared.push_back(std::move(squares[i]));
    exact->nodes.push_back({found[i].vertex, foot});
  }
  exact_ = std::move(exact);
}

const FreeSpace& Gates::space() const { return exact_->walls.space(); }
const std::vector<Gate>& Gates::gates() const { return exact_->gates; }
bool Gates::is_opening(std::uint32_t constraint) const { return exact_->walls.is_opening(constraint); }

std::strong_ordering Gates::compare_width(std::uint32_t i, double diameter) const {
  const Rational d = meaning(diameter);
  return compare(exact_->squared[i], d * d);
}

std::strong_ordering Gates::compare_widths(std::uint32_t i, std::uint32_t j) const {
  return compare(exact_->squared[i], exact_->squared[j]);
}

std::string Gates::width_text(std::uint32_t i) const {
  const Gate& gate = exact_->gates[i];
  std::optional<std::string> width;
  if (gate.foot_is_exact) width = printed_distance(gate.end, gate.foot, gate.to_opening ? 2 : 1);
  return width.value_or(fmt::format("{}", gate.width));
}

std::string Gates::name(std::uint32_t i) const {
  const Gate& gate = exact_->gates[i];
  const auto [p, q] = std::minmax(gate.end, gate.foot);
  return fmt::format("{} between ({}, {}) and ({}, {})", width_text(i), p.x, p.y, q.x, q.y);
}

}  // namespace taut
