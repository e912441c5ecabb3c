#include <taut/io/pictures/kept_svg.h>

#include <fmt/format.h>

#include <taut/io/pictures/arc_curves.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/results/words.h>

namespace taut {

std::string kept_svg(const KeptAnswer& answer, const FreeSpace& space, const std::string& title,
                     const std::vector<EndMove>& moves) {
  SvgPicture picture;
  picture.title = title;
  picture.start = answer.start;
  picture.goal.point = answer.goal;
  picture.moves = moves;
  picture.separation = answer.barrier.walls;
  picture.gates = answer.barrier.gate_segments();
  const KeptPath& path = answer.path;
  const std::string kept = "clearance " + number_text(path.clearance);
  picture.facts = {path.parts.empty() ? "no path" : fmt::format("length {:.6f}", path.length.middle()), kept};
  if (path.parts.size() > 1) picture.facts.back() += " but near ends";
  for (const ArcPath& part : path.parts) {
    const auto curves = arc_curves(pieces(part));
    picture.curves.insert(picture.curves.end(), curves.begin(), curves.end());
    if (part.radius > 0)
      picture.discs.insert(picture.discs.end(), {{part.start, part.radius}, {part.goal, part.radius}});
  }
  return svg(space, picture);
}

}  // namespace taut
