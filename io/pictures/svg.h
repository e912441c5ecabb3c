// Pictures of a free space and what was found in it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/io/results/end_moves.h>
#include <taut/roadmaps/roadmap.h>
#include <taut/roadmaps/voronoi.h>
#include <taut/search/arc_path.h>
#include <taut/search/path.h>

namespace taut {

/// A path in a colour of its own (shade_colour): 0 the dark end of the scale, 1 the bright one.
struct SvgShade {
  std::vector<Bezier> curves;
  double shade = 0;
};

/// A word beside a dot.
struct SvgLabel {
  Point at;
  std::string text;
};

/// A robot that is a disc, where it stands or passes.
struct SvgDisc {
  Point centre;
  double radius = 0;
};

/// What a letter of labels stands for, for the key: `H`, `hit point`.
struct SvgLabelKey {
  std::string letter;
  std::string meaning;
};

/// What was in sight from somewhere on the path.
struct SvgView {
  Ring ring;
  double at = 0;  ///< when, as a part of the path's length
};

/// A part of the plane in a colour of its own (flood_colour).
struct SvgFill {
  Ring ring;
  double shade = 0;
};

/// A dot that moves evenly from place to place, each with when, a part of the round; the first is at 0, the last at 1.
struct SvgTraveller {
  std::vector<std::pair<double, Point>> places;
  std::string kind = "runner";  ///< or `goal`: its class
};

/// What to draw besides the free space. Pointers may be null and are only read during the call.
struct SvgPicture {
  std::string title{};               ///< first line of the legend, usually the file's name
  std::vector<std::string> facts{};  ///< second line, joined by dots: `length 77.262691`, `34 corners`; no times
  const Roadmap* roadmap = nullptr;
  const Path* path = nullptr;
  std::vector<Segment> separation{};  ///< the walls that separate start and goal
  std::optional<Point> start{};
  Goal goal{};
  const VoronoiRoadmap* diagram = nullptr;  ///< drawn as the roadmap, arcs as Bezier curves
  std::vector<Bezier> curves{};             ///< the path, when it is one of curves
  std::vector<SvgShade> shades{};           ///< further paths, the first at the bottom
  std::vector<Segment> gates{};             ///< narrow places
  const ArcPath* arcs = nullptr;            ///< drawn as `path`, with true arcs
  std::vector<SvgView> views{};             ///< tinted, in the order of `at`; a moving picture shows the last one only
  std::vector<Segment> guides{};            ///< auxiliary lines, dashed, below the path
  std::string guide_label{};                ///< what they are, for the key, where they are no straight line to the goal
  std::vector<SvgLabel> labels{};           ///< above all else, each where it hides least
  double seconds = 0;                       ///< > 0: a dot runs along `path` in that time, again and again (SMIL)
  bool milestones = false;                  ///< the roadmap's vertices are dots, also those joined to nothing
  std::vector<SvgDisc> discs{};             ///< the robot, below the path
  std::vector<SvgLabelKey> label_keys{};
  std::vector<Segment> contours{};         ///< thin lines below the walls (contours.h)
  std::vector<EndMove> moves{};            ///< of start and goal: dashed, from where they were given
  std::vector<SvgFill> fills{};            ///< above the free space, below all else
  std::string fill_label{};                ///< what their colours mean, for the key
  std::vector<SvgTraveller> travellers{};  ///< with `seconds`: these run instead of a dot along `path`
};

/// The picture as one SVG 1.1 document, north up.
///
///  1. The longer side of the world is 960 pixels long, whatever its unit; below it a legend with title, facts and a
///     key of what is drawn. Strokes, markers and the number of decimals follow the mean width of a corridor
///     (corridor_width), so that 5 x 7 and 300 x 300 cells both read well.
///  2. Groups, bottom to top, absent when they have nothing to show: `solid` (where the reference point cannot be),
///     `free` (polygons with holes), `fills`, `rooms` (the goal's), `views`, `contours`, `roadmap`, `milestones`,
///     `openings`, `walls` (as the world gives them: a line, or a bar as wide as it is thick), `separation`, `gates`,
///     `shades`, `guides`,
///     `moves`, `discs`, `path` (a casing and the line), `start`, `goal`, `labels`, `runner`; beside them
///     `legend`. Each is a `<g>` of that class under svg.taut, coloured by the `<style>` block alone; there are no ids,
///     so pictures can share a page. Colours follow `prefers-color-scheme`.
///  3. Each group is a few `<path>` elements with relative, rounded coordinates: about 4 bytes a corner. A roadmap of
///     more than kSvgRoadmapEdges edges is left out and the legend says so.
///  4. All text is escaped; bytes that are no UTF-8 become U+FFFD. Same input, same bytes.
/// O(size of the free space, world, roadmap and path).
std::string svg(const FreeSpace& space, const SvgPicture& picture = {});

inline constexpr std::size_t kSvgRoadmapEdges = 200'000;

}  // namespace taut
