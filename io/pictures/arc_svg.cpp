#include <taut/io/pictures/arc_svg.h>

#include <fmt/format.h>

#include <algorithm>

#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>

namespace taut {

namespace {

// Exact where that is short.
std::string width_text(const NamedGate& gate) {
  return gate.width_text.size() <= 8 ? gate.width_text : fmt::format("{:.6g}", gate.width);
}

std::vector<std::string> facts(const ArcAnswer& answer) {
  const std::string radius = "disc of radius " + number_text(answer.radius);
  if (answer.result.status != DiscStatus::found)
    return {answer.barrier.walls.empty() && answer.barrier.gates.empty() ? "not proven" : "no path", radius};
  const ArcPath& path = answer.result.path;
  const auto arcs = std::count_if(path.bends.begin(), path.bends.end(), [](const ArcBend& b) { return b.turn != 0; });
  std::vector<std::string> facts{fmt::format("length {:.6f}", path.value()),
                                 count_text(static_cast<std::size_t>(arcs), "arc"), radius};
  if (answer.pinch) facts.push_back("narrowest passage " + width_text(answer.pinch->gate));
  return facts;
}

}  // namespace

std::string arc_svg(const ArcAnswer& answer, const FreeSpace& space, const std::string& title,
                    const std::vector<EndMove>& moves) {
  SvgPicture picture;
  picture.title = title;
  picture.facts = facts(answer);
  picture.start = answer.start;
  picture.moves = moves;
  picture.goal.point = answer.goal;
  picture.separation = answer.barrier.walls;
  picture.gates = answer.barrier.gate_segments();
  picture.discs = {{answer.start, answer.radius}, {answer.goal, answer.radius}};
  if (answer.result.status == DiscStatus::found) picture.arcs = &answer.result.path;
  if (answer.pinch) {
    picture.gates.push_back(answer.pinch->gate.at);
    picture.discs.push_back({answer.pinch->at, answer.radius});
  }
  return svg(space, picture);
}

}  // namespace taut
