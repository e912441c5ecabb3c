#include <taut/io/pictures/clearance_svg.h>

#include <fmt/format.h>

#include <vector>

#include <taut/io/pictures/svg.h>
#include <taut/io/pictures/svg_front.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/words.h>
#include <taut/search/passage_map.h>

namespace taut {

namespace {

using Kind = ClearanceQuery::Kind;

constexpr const char* kAlong = "along the Voronoi diagram";

std::vector<std::string> facts(const ClearanceAnswer& answer) {
  if (answer.status == SearchStatus::stopped) return {"not proven"};
  if (answer.status == SearchStatus::none) {
    const bool narrow = !answer.barrier.gates.empty();
    return {none_text(answer.query),
            narrow ? count_text(answer.barrier.gates.size(), "gate") + " too narrow" : separation_text(answer.barrier)};
  }
  if (answer.query.kind == Kind::tradeoff)
    return {count_text(answer.found.size(), "path") + " along the Voronoi diagram"};
  const ClearancePath& way = answer.found.front().path;
  return {fmt::format("length {} {}", plain_length(way.length), kAlong),
          answer.query.kind == Kind::widest ? "largest disc: radius " + number_text(way.pinch.clearance)
                                            : "least clearance " + number_text(way.pinch.clearance)};
}

std::vector<SvgShade> shades(const ClearanceAnswer& answer) {
  const double least = answer.found.front().clearance, most = answer.found.back().clearance;
  std::vector<SvgShade> all;
  for (const ClearanceTrade& t : answer.found)
    all.push_back({t.path.curves, most > least ? (t.clearance - least) / (most - least) : 1});
  return all;
}

SvgPicture picture_of(const ClearanceAnswer& answer, const std::string& title, const std::vector<EndMove>& moves) {
  SvgPicture picture;
  picture.title = title;
  picture.facts = facts(answer);
  picture.start = answer.start;
  picture.moves = moves;
  picture.goal.point = answer.goal;
  if (answer.status != SearchStatus::found) {
    picture.separation = answer.barrier.walls;
    picture.gates = answer.barrier.gate_segments();
    return picture;
  }
  if (answer.query.kind == Kind::widest) {  // the chain that stops any larger disc
    picture.separation = answer.barrier.walls;
    picture.gates = answer.barrier.gate_segments();
  }
  for (const ClearanceTrade& t : answer.found) picture.gates.push_back({t.path.pinch.posts[0], t.path.pinch.posts[1]});
  if (answer.query.kind == Kind::tradeoff)
    picture.shades = shades(answer);
  else
    picture.curves = answer.found.front().path.curves;
  return picture;
}

std::string front_picture(const ClearanceAnswer& answer, const FreeSpace& space, const std::string& title,
                          const std::vector<EndMove>& moves) {
  std::vector<SvgStep> steps;
  for (const ClearanceTrade& t : answer.found) steps.push_back({t.clearance, t.path.length, place_text(t.path.pinch)});
  return svg_front(space, picture_of(answer, title, moves), steps);
}

}  // namespace

std::string clearance_svg(const ClearanceAnswer& answer, const FreeSpace& space, const VoronoiRoadmap& map,
                          const std::string& title, const std::vector<EndMove>& moves) {
  if (answer.status == SearchStatus::found && answer.query.kind == Kind::tradeoff)
    return front_picture(answer, space, title, moves);
  SvgPicture picture = picture_of(answer, title, moves);
  picture.diagram = &map;
  return svg(space, picture);
}

std::string passage_svg(const Passage& passage, const FreeSpace& space, const std::string& title,
                        const std::vector<EndMove>& moves) {
  SvgPicture picture;
  picture.title = title;
  picture.start = passage.start;
  picture.moves = moves;
  picture.goal.point = passage.goal;
  if (passage.radius)
    picture.facts.push_back(fmt::format("a disc of radius {} {}", number_text(*passage.radius),
                                        passage.gets_through() ? "gets through" : "does not get through"));
  else if (!passage.widest)
    picture.facts.emplace_back("no path");
  if (passage.widest) picture.facts.push_back("largest radius " + number_text(passage.widest->radius));
  if (!passage.barrier.gates.empty())
    picture.facts.push_back(count_text(passage.barrier.gates.size(), "gate") + " in the barrier, the widest " +
                            passage.barrier.gates.front().width_text);
  picture.separation = passage.barrier.walls;
  picture.gates = passage.barrier.gate_segments();
  return svg(space, picture);
}

std::string passage_map_svg(const PassageIndex& index, Point start, const std::string& title,
                            const std::vector<EndMove>& moves) {
  SvgPicture picture;
  picture.title = title;
  picture.start = start;
  picture.moves = moves;
  const std::vector<PassageFace> faces = passage_map(index, start);
  const double most = faces.empty() ? 0 : faces.front().radius, least = faces.empty() ? 0 : faces.back().radius;
  for (const PassageFace& face : faces)
    picture.fills.push_back({face.outline, most > least ? (face.radius - least) / (most - least) : 1});
  picture.facts = {count_text(faces.size(), "face") + " between walls and gates"};
  picture.fill_label = fmt::format("the largest disc that gets there: radius {:.6g} to {:.6g}", least, most);
  return svg(index.gates().space(), picture);
}

}  // namespace taut
