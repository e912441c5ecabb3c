#include <taut/search/clearance_planner.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <taut/geometry/corridor_width.h>
#include <taut/geometry/rounding.h>
#include <taut/search/no_path.h>
#include <taut/search/passage.h>
#include <taut/search/verify.h>

namespace taut {

namespace {

constexpr double kSampling = 1e-4;  // of a corridor

using Kind = ClearanceQuery::Kind;
using Doubt = ClearanceAnswer::Doubt;

void doubt(ClearanceAnswer& answer, Doubt why) {
  answer.status = SearchStatus::stopped;
  answer.doubt = why;
}

}  // namespace

ClearancePlanner::ClearancePlanner(FreeSpace space, VoronoiRoadmap map, Gates gates, Point start,
                                   const std::vector<Point>& goals)
    : space_(std::move(space)),
      map_(std::move(map)),
      gates_(std::move(gates)),
      start_(start),
      goal_(widest_goal(gates_, start, goals)) {}

ClearanceAnswer ClearancePlanner::answer(const ClearanceQuery& query,
                                         const std::function<void(const ClearanceTrade&)>& told) const {
  ClearanceAnswer answer;
  answer.query = query;
  answer.start = start_;
  answer.goal = goal_;
  answer.places = {map_.vertices().size(), map_.edges().size()};
  answer.max_error = map_.max_error();
  answer.within = rounding_bound(walled());
  answer.found = ways(query, told);
  answer.status = answer.found.empty() ? SearchStatus::none : SearchStatus::found;
  if (answer.found.empty())
    prove_none(answer);
  else if (query.kind == Kind::widest)
    name_limit(answer);
  return answer;
}

std::vector<ClearanceTrade> ClearancePlanner::ways(const ClearanceQuery& query,
                                                   const std::function<void(const ClearanceTrade&)>& told) const {
  const ClearanceSearch search(map_, start_, goal_);
  if (query.kind == Kind::tradeoff) return search.tradeoff(told);
  auto way = query.kind == Kind::widest ? search.widest() : search.shortest(query.clearance);
  if (!way) return {};
  return {{way->pinch.clearance, std::move(*way)}};
}

/// The gates prove it; where not even a point gets through, the walls.
void ClearancePlanner::prove_none(ClearanceAnswer& answer) const {
  const double r = answer.query.kind == Kind::at_least ? answer.query.clearance : 0;
  if (r == 0) {
    const auto walls = NoPath(walled()).walls(start_, {goal_, {}});
    if (!walls || walls->empty()) return doubt(answer, Doubt::no_witness);
    answer.barrier.walls = joined_walls(*walls, walled().world().box());
    return;
  }
  answer.passage = disc_passage(gates_, start_, goal_, r);
  if (answer.passage->status == DiscStatus::found) return doubt(answer, Doubt::disagree);
  answer.barrier = barrier_of(gates_, answer.passage->barrier);
}

void ClearancePlanner::name_limit(ClearanceAnswer& answer) const {
  answer.limit = widest_passage(gates_, start_, goal_);
  if (!answer.limit || answer.limit->limit != WidestPassage::Limit::gate) return;
  answer.barrier = barrier_of(gates_, answer.limit->barrier);
  answer.width = gates_.width_text(answer.limit->gate);
}

void ClearancePlanner::verify(ClearanceAnswer& answer) const {
  answer.verified = std::all_of(answer.found.begin(), answer.found.end(),
                                [&](const ClearanceTrade& t) { return is_followed(t.path); }) &&
                    gates_agree(answer);
  if (!answer.verified) doubt(answer, Doubt::disagree);
}

bool ClearancePlanner::is_followed(const ClearancePath& way) const {
  const std::vector<Point> points = points_of(way);
  const Path path{points, Length(points)};
  const double slack = tolerance() + 4 * map_.max_error() + 1e-12 * way.length;
  if (way.pinch.clearance <= slack) return true;  // rounded, it may cross the wall that it touches
  const Goal goal{goal_, {}};
  const Verdict inside = taut::verify(path, space_, start_, goal), wide = taut::verify(path, walled(), start_, goal);
  return inside.valid && wide.valid && wide.clearance >= way.pinch.clearance - slack;
}

bool ClearancePlanner::gates_agree(const ClearanceAnswer& answer) const {
  if (answer.query.kind == Kind::at_least)
    return answer.query.clearance == 0 ||
           disc_passage(gates_, start_, goal_, answer.query.clearance).status == DiscStatus::found;
  const double r = answer.found.back().clearance;
  const auto widest = widest_passage(gates_, start_, goal_);
  // The one is rounded to nearest, the other down.
  return widest && widest->radius <= r && r <= std::nextafter(widest->radius, HUGE_VAL);
}

double ClearancePlanner::tolerance() const { return kSampling * corridor_width(walled()); }

std::vector<Point> ClearancePlanner::points_of(const ClearancePath& way) const {
  if (way.curves.empty()) return {start_};
  return sampled(way.curves, tolerance());
}

}  // namespace taut
