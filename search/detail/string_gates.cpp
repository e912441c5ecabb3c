#include <taut/search/detail/string_gates.h>

#include <taut/geometry/written.h>
#include <taut/search/arc_pinch.h>

namespace taut::detail {

namespace {

/// The string a little to the free side of its corners.
ArcPath beside(const Path& path, double radius) {
  ArcPath way{radius, path.points.front(), path.points.back(), {}, {}};
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i)
    way.bends.push_back(
        {path.points[i], written::orientation(path.points[i - 1], path.points[i], path.points[i + 1]) >= 0 ? 1 : -1});
  return way;
}

}  // namespace

std::optional<std::uint32_t> narrowest_gate_of(const Gates& gates, const Path& path) {
  if (gates.gates().empty() || path.points.size() < 2) return std::nullopt;
  const auto pinch = narrowest_gate(gates, beside(path, gates.gates().front().width * 0x1p-20));
  return pinch ? std::optional(pinch->index) : std::nullopt;
}

}  // namespace taut::detail
