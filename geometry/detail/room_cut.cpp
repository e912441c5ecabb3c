#include <taut/geometry/detail/room_cut.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>

namespace taut::detail {

namespace {

std::optional<Box> cut_to(const Box& world, const Box& b) {
  const Box cut{{std::max(b.min.x, world.min.x), std::max(b.min.y, world.min.y)},
                {std::min(b.max.x, world.max.x), std::min(b.max.y, world.max.y)}};
  return cut.min.x < cut.max.x && cut.min.y < cut.max.y ? std::optional(cut) : std::nullopt;
}

}  // namespace

bool is_within(const Box& inner, const Box& outer) { return outer.contains(inner.min) && outer.contains(inner.max); }

void cut_room(std::vector<Box>& room, const Box& world, const std::string& source) {
  std::vector<Box> rest;
  for (const Box& b : room)
    if (const std::optional<Box> cut = is_within(b, world) ? b : cut_to(world, b)) rest.push_back(*cut);
  if (rest.empty() && !room.empty())
    throw InputError(source, 0,
                     "the goal room " + text(room[0].min) + " to " + text(room[0].max) + " lies outside the world");
  room = std::move(rest);
}

}  // namespace taut::detail
