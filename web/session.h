// What a page asks of taut: JSON in, JSON out.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace taut::web {

/// One world at a time, prepared once and kept, so that a drag asks for a path and nothing else. The same in a browser
/// (WebAssembly) and behind a loopback server: no files, no threads, no clock, no exceptions out.
///
/// A request is an object with a member `do`. An answer is an object; one with `error` (a line for people) means that
/// nothing was changed. Points are [x, y]; `start` and `goal` may be absent in all requests: then they are the world's
/// own. Long lists of numbers are flat: four a segment, two a point.
///
///  load         `bytes` (text) or `base64`; `name` for messages; `format`, `polygons` (free, obstacles, nested),
///               `crossings` (even-odd), `wall_thickness`, `cell_size`, `resolution`, `unknown` (free): as the
///               options of read_world. Answers with what `world` answers.
///  edit         `walls`: five numbers a wall, the last its thickness; they replace all walls of the world; solids and
///               given areas stay, implied ones are found anew. Answers with what `world` answers.
///  world        `name`, `format`, `walls` (five numbers each), `solids` and `areas` (lists of polygons, a polygon a
///               list of flat rings, the outer first), `boundary` (walled, limit, open), `openings`, `box`
///               [xmin, ymin, xmax, ymax], `y_down`, `start`, `goal` (a point), `room` (list of boxes), `remarks`,
///               `corners` (where a path can bend), and `ends`: a start and a goal to begin with where the world has
///               none.
///  path         `radius` (0: a point), `digits` (of the length, 0 to 1000; of a point). Answers `status`:
///               found        `points` (flat) or, of a disc, `pieces` (seven numbers each: from, to, turn, centre;
///                            turn 0 is straight), `length`, `corners`, `digits` (a string), `within` where rounded
///                            crossings leave that much unproven, `width` of the enclosure of a disc's length
///               none         `reason`, `walls` (flat, they separate), `gates` (flat, too narrow for the disc)
///               unproven     `reason`
///               blocked      `end` (start, goal), `reason`, and `nearest`, a place where the robot can be, if any
///  widest       the largest disc that gets through: `status` found, `radius` (null: any), `limit` (gate, start, goal,
///               none), `text`, `at` (flat: the gate); none
///  layer        `name`: triangulation, mesh, visibility, voronoi, gates, region (of `at`, a point). Answers
///               `segments`, or of voronoi `curves` (six numbers each: from, control, to), or of region `ring`; of
///               gates `widths` as well
///  save         `as` (a format's word). Answers `text`, or `base64` of what is no text
///  formats      `formats`: the words that this world can be saved as
///  self-test    `passed`, `checks`: exactness, asked of the machine that it runs on
class Session {
 public:
  Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  std::string answer(std::string_view request) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut::web
