// How to get from start to goal, or why not.
#include <fmt/format.h>

#include <cmath>

#include <taut/geometry/rounding.h>
#include <taut/io/results/barrier_words.h>
#include <taut/roadmaps/disc_places.h>
#include <taut/search/arc_search.h>
#include <taut/search/barrier.h>
#include <taut/search/corner_count.h>
#include <taut/search/disc_passage.h>
#include <taut/search/query_ends.h>
#include <taut/web/detail/answers.h>

namespace taut::web {

namespace {

constexpr int kMostDigits = 1000;

bool is_place(Point p) {
  const auto is_read = [](double v) {
    return v == 0 || (std::abs(v) <= World::kLargest && std::abs(v) >= World::kSmallest);
  };
  return is_read(p.x) && is_read(p.y);
}

Json blocked(const World& world, Point p, const char* role, const std::optional<FreePlace>& nearest) {
  return {{"status", "blocked"},
          {"end", role},
          {"reason", blocked_text(world, p, role, nearest)},
          {"nearest", nearest ? Json(nearest->point) : Json()}};
}

/// Where an end is no place for a point; null when both are.
Json blocked_end(const FreeSpace& space, const Query& query) {
  const auto is_blocked = [&](Point p) { return !space.holds(p); };
  if (is_blocked(query.start)) return blocked(space.world(), query.start, "start", nearest_free(space, query.start));
  if (query.goal.point && is_blocked(*query.goal.point))
    return blocked(space.world(), *query.goal.point, "goal", nearest_free(space, *query.goal.point));
  return {};
}

Json found_point(Ground& ground, const Request& request) {
  const std::vector<Point>& points = ground.search().points();
  Json answer{{"status", "found"}, {"points", flat(points)}};
  const Length length{points};
  answer["length"] = length.value();
  answer["corners"] = corner_count(points, ground.world().uncertainty());
  if (const auto digits = request.count("digits", kMostDigits)) answer["digits"] = length.decimals(*digits);
  if (const double bound = rounding_bound(ground.space()); bound > 0) answer["within"] = bound;
  return answer;
}

Json no_way_for_a_point(Ground& ground, const Query& query) {
  const auto chain = ground.no_path().walls(query.start, query.goal);
  if (!chain)
    return {{"status", "unproven"},
            {"reason", "no path, but an end is so near a rounded crossing of walls that this is no proof"}};
  const Barrier barrier{joined_walls(*chain, ground.world().box()), {}};
  return {{"status", "none"},
          {"reason", separation_text(barrier)},
          {"walls", flat(barrier.walls)},
          {"gates", Json::array()}};
}

Json point_path(Ground& ground, const Query& query, const Request& request) {
  if (Json end = blocked_end(ground.space(), query); !end.is_null()) return end;
  if (ground.search().find(query.start, query.goal) == SearchStatus::found) return found_point(ground, request);
  return no_way_for_a_point(ground, query);
}

Json flat(const std::vector<ArcPiece>& pieces) {
  Flat out;
  for (const ArcPiece& piece : pieces)
    out << piece.from << piece.to << piece.turn << (piece.turn == 0 ? piece.from : piece.centre);
  return out.json();
}

Json found_disc(const ArcPath& path) {
  return {{"status", "found"},
          {"pieces", flat(pieces(path))},
          {"length", path.value()},
          {"width", path.length.hi - path.length.lo},
          {"corners", path.bends.size()}};
}

Json no_way_for_a_disc(Ground& ground, Point start, Point goal, double radius) {
  const DiscPassage passage = disc_passage(ground.gates(), start, goal, radius);
  if (passage.status != DiscStatus::none || passage.barrier.empty())
    return {{"status", "unproven"}, {"reason", "no path found, but no walls and gaps that prove that there is none"}};
  const Barrier barrier = barrier_of(ground.gates(), passage.barrier);
  return {{"status", "none"},
          {"reason", blocked_text(ground.gates(), passage, barrier, start, goal, radius)},
          {"walls", web::flat(barrier.walls)},
          {"gates", web::flat(barrier.gate_segments())}};
}

Point point_of(const Goal& goal) {
  if (goal.point) return *goal.point;
  const Box& b = goal.room.front();
  return {b.min.x + (b.max.x - b.min.x) / 2, b.min.y + (b.max.y - b.min.y) / 2};
}

Json disc_path(Ground& ground, const Query& query, double radius) {
  const Point goal = point_of(query.goal);
  const ArcSearchResult result = arc_search(ground.tangents(radius), query.start, goal);
  if (result.status == DiscStatus::found) return found_disc(result.path);
  if (result.status == DiscStatus::none) return no_way_for_a_disc(ground, query.start, goal, radius);
  const bool at_start = result.status == DiscStatus::start_blocked;
  const Point end = at_start ? query.start : goal;
  return blocked(ground.world(), end, at_start ? "start" : "goal", DiscPlaces(ground.space(), radius).nearest(end));
}

}  // namespace

Query query_of(const Ground& ground, const Request& request) {
  std::optional<Point> start = request.point("start");
  if (!start) start = ground.world().start();
  Goal goal = ground.world().goal();
  if (const auto point = request.point("goal")) goal = {point, {}};
  if (!start) throw InputError("", 0, "there is no start");
  if (!goal.point && goal.room.empty()) throw InputError("", 0, "there is no goal");
  if (!is_place(*start)) throw InputError("", 0, "the start is no point");
  if (goal.point && !is_place(*goal.point)) throw InputError("", 0, "the goal is no point");
  return {*start, std::move(goal)};
}

Json path_answer(Ground& ground, const Request& request) {
  const Query query = query_of(ground, request);
  const double radius = request.number("radius").value_or(0);
  if (!(radius >= 0 && (radius == 0 || is_place({radius, 0}))))
    throw InputError("", 0, "the radius is no number from 0 on");
  return radius == 0 ? point_path(ground, query, request) : disc_path(ground, query, radius);
}

Json widest_answer(Ground& ground, const Request& request) {
  const Query query = query_of(ground, request);
  const Point goal = point_of(query.goal);
  if (Json end = blocked_end(ground.space(), {query.start, {goal, {}}}); !end.is_null()) return end;
  const auto widest = widest_passage(ground.gates(), query.start, goal);
  if (!widest) return {{"status", "none"}};
  static constexpr const char* kLimits[]{"gate", "start", "goal", "none"};
  Json answer{{"status", "found"},
              {"radius", widest->radius},
              {"limit", kLimits[static_cast<int>(widest->limit)]},
              {"text", limit_text(ground.gates(), *widest, query.start, goal)}};
  if (widest->gate != kNone) {
    const Gate& gate = ground.gates().gates()[widest->gate];
    answer["at"] = web::flat(std::vector<Segment>{{gate.end, gate.foot}});
  }
  return answer;
}

}  // namespace taut::web
