#include <taut/geometry/snap.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <taut/geometry/detail/near_pairs.h>
#include <taut/geometry/detail/snapper.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

constexpr std::size_t kFewEnds = 16;  // that a look at every wall is less than an index of them

bool is_valid(Point p) { return std::abs(p.x) <= World::kLargest && std::abs(p.y) <= World::kLargest; }

bool is_valid(const WorldParts& parts) {
  bool valid = true;
  detail::for_each_place(parts, [&](Point p) { valid = valid && is_valid(p); });
  return valid;
}

bool any_computed(const WorldParts& parts) {
  bool any = false;
  detail::for_each_place(parts, [&](Point p) { any = any || detail::is_computed(p); });
  return any;
}

/// Is one of them near to a wall or side, but not on it?
bool any_beside(const std::vector<Point>& ends, const WorldParts& parts, double reach) {
  bool any = false;
  const auto look = [&](const Segment& s) {
    for (const Point p : ends) any = any || (detail::foot(p, s).distance <= reach && !written::on_segment(p, s.a, s.b));
  };
  for (const Wall& wall : parts.walls) look({wall.a, wall.b});
  detail::for_each_ring(parts, [&](const Ring& ring, std::uint32_t, int) {
    for (std::size_t i = 0; i < ring.size(); ++i) look({ring[i], ring[(i + 1) % ring.size()]});
  });
  return any;
}

std::vector<Point> all_ends(const WorldParts& parts, std::span<const Point> ends) {
  std::vector<Point> all(ends.begin(), ends.end());
  if (parts.start) all.push_back(*parts.start);
  if (parts.goal.point) all.push_back(*parts.goal.point);
  std::erase_if(all, [](Point p) { return !is_valid(p); });
  return all;
}

/// Nothing to do for numbers that were written, which most are.
bool is_plain(const WorldParts& parts, std::vector<Point> ends, double rounding) {
  std::erase_if(ends, [](Point p) { return !detail::is_computed(p); });
  return ends.size() <= kFewEnds && !any_beside(ends, parts, rounding);
}

/// Is it so, or is nothing to be joined? False says nothing.
bool is_passed_through(const WorldParts& parts, const Snap& snap, std::span<const Point> ends) {
  if (snap.what == Snap::What::nothing) return true;
  return snap.what == Snap::What::rounding && is_valid(parts) && !any_computed(parts) &&
         is_plain(parts, all_ends(parts, ends), rounding_tolerance(parts));
}

/// Of the ends that could not be joined those that still touch nothing there, no farther than all may have moved; and
/// what came to be near by moving.
std::vector<NearContact> remaining(const SnappedParts& joined, double reach) {
  const std::vector<NearContact>& apart = joined.report.remaining;
  const auto is_apart = [&](Point p) {
    return std::any_of(apart.begin(), apart.end(), [&](const NearContact& c) { return c.end == p; });
  };
  std::vector<NearContact> result;
  for (const NearContact& c : detail::contacts_within(joined.parts, 3 * reach, 0))
    if (c.distance <= reach || is_apart(c.end) || is_apart(c.wall.a) || is_apart(c.wall.b)) result.push_back(c);
  return result;
}

SnappedParts joined(WorldParts parts, const Snap& snap, std::span<const Point> given, bool polygons_apart) {
  if (snap.what == Snap::What::nothing || !is_valid(parts)) return {std::move(parts), {}};
  const std::vector<Point> ends = all_ends(parts, given);
  const bool computed = any_computed(parts);
  detail::Joining joining{rounding_tolerance(parts), 0, polygons_apart};
  if (snap.what == Snap::What::automatic) joining.reach = auto_tolerance(parts);
  if (snap.what == Snap::What::within) {
    joining.reach = snap.tolerance;
    joining.rounding = std::min(joining.rounding, snap.tolerance);
  }
  const double rounding = computed ? joining.rounding : 0;
  if (joining.reach == 0 && !computed && is_plain(parts, ends, joining.rounding)) return {std::move(parts), {}};
  SnappedParts result = detail::joined(std::move(parts), joining, ends);
  result.report.tolerance = std::max(joining.reach, joining.rounding);
  result.parts.uncertainty = std::max({result.parts.uncertainty, rounding, result.report.displacement});
  if (result.report.joined > 0) result.parts.grid.reset();
  if (joining.reach > 0) result.report.remaining = remaining(result, joining.reach);
  return result;
}

void require_joined(const Snapped& result, const WorldParts& parts, const Snap& snap) {
  const auto& remaining = result.report.remaining;
  if (snap.what != Snap::What::within || remaining.empty()) return;
  throw InputError(parts.source, remaining.front().line,
                   "joining what is no farther apart than " + taut::text(snap.tolerance) +
                       " leaves contacts that it would have to move farther for: " + text(remaining));
}

/// `0.00082`
std::string rounded(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 3).ptr};
}

std::string ends_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " end" : " ends"); }

}  // namespace

double rounding_tolerance(const WorldParts& parts) {
  double largest = 0;
  detail::for_each_place(parts, [&](Point p) { largest = std::max({largest, std::abs(p.x), std::abs(p.y)}); });
  return std::max(std::ldexp(detail::extent(parts), -40), 8 * (std::nextafter(largest, HUGE_VAL) - largest));
}

SnappedParts snapped(WorldParts parts, const Snap& snap, std::span<const Point> ends) {
  return joined(std::move(parts), snap, ends, false);
}

Snapped snapped_world(const WorldParts& parts, const Snap& snap, std::span<const Point> ends) {
  for (const bool polygons_apart : {false, true}) {
    SnappedParts result = joined(parts, snap, ends, polygons_apart);
    const bool last = result.report.joined == 0 || (polygons_apart && snap.what != Snap::What::rounding);
    try {
      Snapped snapped{World(std::move(result.parts)), std::move(result.report)};
      require_joined(snapped, parts, snap);
      return snapped;
    } catch (const InputError&) {
      if (last) throw;
    }
  }
  return {World(parts), {}};
}

Snapped snapped_world(WorldParts&& parts, const Snap& snap, std::span<const Point> ends) {
  if (!is_passed_through(parts, snap, ends)) return snapped_world(std::as_const(parts), snap, ends);
  return {World(std::move(parts)), {}};
}

Snapped snapped(const World& world, const Snap& snap, std::span<const Point> ends) {
  return snapped_world(world.parts(), snap, ends);
}

Snapped snapped(const World& world, double tolerance) {
  const Snap snap = tolerance > 0 ? Snap{Snap::What::within, tolerance} : Snap{Snap::What::nothing, 0};
  const WorldParts parts = world.parts();
  SnappedParts result = joined(parts, snap, {}, false);
  return {World(std::move(result.parts)), std::move(result.report)};
}

std::string text(const SnapReport& report) {
  if (report.joined == 0) return {};
  std::string text =
      ends_text(report.joined) + " joined to other walls, moved by at most " + rounded(report.displacement);
  if (!report.remaining.empty()) text += "; " + ends_text(report.remaining.size()) + " remain apart";
  return text;
}

std::string text(const std::vector<NearContact>& contacts) {
  if (contacts.empty()) return {};
  const NearContact& largest = *std::max_element(contacts.begin(), contacts.end(),
                                                 [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return ends_text(contacts.size()) + (contacts.size() == 1 ? " nearly touches" : " nearly touch") +
         " another wall, at most " + rounded(largest.distance) + " apart: " + taut::text(largest.end) + " and " +
         taut::text(largest.wall);
}

}  // namespace taut
