#include <taut/io/results/barrier_words.h>

#include <fmt/format.h>

#include <algorithm>

#include <taut/io/results/words.h>

namespace taut {

namespace {

constexpr std::size_t kNamed = 4;

std::string and_more(std::size_t all) { return all > kNamed ? fmt::format(" and {} more", all - kNamed) : ""; }

}  // namespace

std::string separation_text(const Barrier& barrier) {
  return fmt::format("{} start and goal: {}",
                     barrier.walls.size() == 1 ? "this wall separates" : "these walls separate",
                     segments_text(barrier.walls, kNamed));
}

std::string barrier_text(const Barrier& barrier, double r) {
  if (barrier.gates.empty()) return separation_text(barrier);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kNamed, barrier.gates.size()); ++i) names.push_back(barrier.gates[i].name);
  return fmt::format(
      "{} narrower than {}: {}{}",
      barrier.gates.size() == 1 ? "this gate is" : fmt::format("these {} gates are", barrier.gates.size()),
      number_text(2 * r), fmt::join(names, "; "), and_more(barrier.gates.size()));
}

std::string blocked_text(const Gates& gates, const DiscPassage& passage, const Barrier& barrier, Point start,
                         Point goal, double r) {
  if (passage.status != DiscStatus::none) {
    const bool at_start = passage.status == DiscStatus::start_blocked;
    const Point end = at_start ? start : goal;
    const char* role = at_start ? "start" : "goal";
    if (passage.barrier.empty()) return fmt::format("the {} {} is outside", role, point_text(end));
    return fmt::format("the {} {} is only {} from the wall {}", role, point_text(end),
                       number_text(distance_to(gates.space(), passage.barrier.front().constraint, end)),
                       segment_text(wall_near(gates.space(), passage.barrier.front().constraint, end)));
  }
  return barrier_text(barrier, r);
}

std::string pinch_text(const Pinch& pinch, const FreeSpace& space, const std::string& width) {
  const std::string first = segment_text(wall_of(space, pinch.constraints[0], &pinch.posts[0]));
  if (pinch.where == Pinch::Where::gate)
    return fmt::format("narrowest {} between {} and {}, of the walls {} and {}",
                       width.empty() ? number_text(2 * pinch.clearance) : width, point_text(pinch.posts[0]),
                       point_text(pinch.posts[1]), first,
                       segment_text(wall_of(space, pinch.constraints[1], &pinch.posts[1])));
  return fmt::format("nearest to a wall at the {} {}: {} from the wall {}",
                     pinch.where == Pinch::Where::start ? "start" : "goal", point_text(pinch.posts[1]),
                     number_text(pinch.clearance), first);
}

std::string limit_text(const Gates& gates, const WidestPassage& widest, Point start, Point goal) {
  if (widest.limit == WidestPassage::Limit::gate) return gates.name(widest.gate);
  if (widest.limit == WidestPassage::Limit::none) return "there is no wall at all";
  const bool at_start = widest.limit == WidestPassage::Limit::start;
  const Point end = at_start ? start : goal;
  return fmt::format("the {} {} is that far from the wall {}", at_start ? "start" : "goal", point_text(end),
                     segment_text(wall_near(gates.space(), widest.constraint, end)));
}

std::string place_text(const Pinch& pinch) {
  if (pinch.where == Pinch::Where::gate)
    return fmt::format("between {} and {}", point_text(pinch.posts[0]), point_text(pinch.posts[1]));
  return fmt::format("at the {}, from {}", pinch.where == Pinch::Where::start ? "start" : "goal",
                     point_text(pinch.posts[0]));
}

std::string plain_length(double length) {
  return length == 0 || (length >= 1e-3 && length < 1e12) ? fmt::format("{:.6f}", length)
                                                          : fmt::format("{:.9g}", length);
}

std::string none_text(const ClearanceQuery& query) {
  return query.kind == ClearanceQuery::Kind::at_least && query.clearance > 0
             ? "no path with clearance " + number_text(query.clearance)
             : "no path";
}

std::string clearance_reason(const ClearanceAnswer& answer, const Gates& gates) {
  if (answer.doubt == ClearanceAnswer::Doubt::no_witness)
    return "no way in the diagram, which does not prove that there is none";
  if (answer.doubt == ClearanceAnswer::Doubt::disagree)
    return fmt::format("the diagram, exact to {:.2g}, and the gates disagree by less than that", answer.max_error);
  if (answer.status != SearchStatus::none) return {};
  return answer.passage
             ? blocked_text(gates, *answer.passage, answer.barrier, answer.start, answer.goal, answer.query.clearance)
             : separation_text(answer.barrier);
}

}  // namespace taut
