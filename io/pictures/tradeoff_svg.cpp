#include <taut/io/pictures/tradeoff_svg.h>

#include <algorithm>

#include <taut/io/pictures/arc_curves.h>
#include <taut/io/pictures/svg_front.h>
#include <taut/io/results/words.h>

namespace taut {

namespace {

constexpr int kChartPoints = 24;  // of a stretch
constexpr int kMoments = 160;     // of a film, about
constexpr int kLeastMoments = 6;  // of a stretch
constexpr double kSeconds = 16;

std::vector<Bezier> way_at(const TradeoffAnswer& answer, const TradeoffStretch& stretch, double r) {
  const auto straight = [](Point a, Point b) { return Bezier{a, {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}, b}; };
  std::vector<Bezier> curves;
  if (stretch.start != answer.start) curves.push_back(straight(answer.start, stretch.start));
  const std::vector<Bezier> way = arc_curves(pieces(stretch.path(r)));
  curves.insert(curves.end(), way.begin(), way.end());
  if (stretch.goal != answer.goal) curves.push_back(straight(stretch.goal, answer.goal));
  return curves;
}

std::vector<SvgStep> steps_of(const TradeoffAnswer& answer, const Gates& gates) {
  std::vector<SvgStep> steps;
  for (const TradeoffStretch& stretch : answer.found.stretches) {
    SvgStep step{stretch.to, stretch.at_to.middle(), stretch_end_text(stretch, gates), {}};
    const LengthFormula length = stretch.formula();
    for (int i = 0; i <= kChartPoints; ++i) {
      const double r = stretch.from + (stretch.to - stretch.from) * i / kChartPoints;
      step.curve.push_back({r, length(r)});
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

SvgFilm film_of(const TradeoffAnswer& answer) {
  SvgFilm film{kSeconds, {}};
  const double most = answer.found.stretches.back().to;
  for (const TradeoffStretch& stretch : answer.found.stretches) {
    const LengthFormula length = stretch.formula();
    const double width = stretch.to - stretch.from;
    const int moments = std::max(kLeastMoments, static_cast<int>(kMoments * width / most));
    for (int i = 0; i <= moments; ++i) {
      const double r = stretch.from + width * i / moments;
      film.moments.push_back({r, length(r), way_at(answer, stretch, r)});
    }
  }
  return film;
}

}  // namespace

std::string tradeoff_svg(const TradeoffAnswer& answer, const FreeSpace& space, const Gates& gates,
                         const std::string& title, const std::vector<EndMove>& moves, bool animate) {
  const std::vector<TradeoffStretch>& all = answer.found.stretches;
  SvgPicture picture;
  picture.title = title;
  picture.facts = {count_text(all.size(), "stretch", "stretches") + " of radii",
                   "the largest disc: radius " + number_text(all.back().to)};
  picture.start = answer.start;
  picture.goal.point = answer.goal;
  picture.moves = moves;
  for (const TradeoffStretch& stretch : all) {
    picture.shades.push_back({way_at(answer, stretch, stretch.to), all.back().to > 0 ? stretch.to / all.back().to : 0});
    if (stretch.gate != kNone) picture.gates.push_back(named_gate(gates, stretch.gate).at);
  }
  if (answer.found.widest && answer.found.widest->gate != kNone)
    picture.gates.push_back(named_gate(gates, answer.found.widest->gate).at);
  return svg_front(space, picture, steps_of(answer, gates),
                   {"length of its shortest way", "then", animate ? film_of(answer) : SvgFilm{}});
}

}  // namespace taut
