// Files that describe a World.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/mend_rings.h>
#include <taut/geometry/snap.h>
#include <taut/geometry/world.h>

namespace taut {

class GeographicWorld;

/// What a file is written in. In every text format lines may end in CRLF, the last one in nothing; a byte order mark
/// and blanks at line ends are skipped. Numbers are decimal, whatever the locale; nan, inf and magnitudes beyond
/// World::kLargest are errors.
///
///  segments     `x1 y1 x2 y2 [thickness]` per wall, separated by blanks or a comma; `#` starts a comment. At most one
///               line each of `start X Y`; `goal X Y`, or a room of boxes `goal XMIN YMIN XMAX YMAX ...`;
///               `boundary XMIN YMIN XMAX YMAX`, or a ring `boundary X1 Y1 X2 Y2 X3 Y3 ...` (Boundary::limit).
///  cell_values  line 1: n, 2..256; then n lines of n values 0..15 separated by commas: line x is column x, from
///               the left, its entry y the cell at height y, from the bottom. A value is the sum of the open sides: 1
///               up, 2 right, 4 down, 8 left. Neighbours agree, the border is closed. Lines that begin with `#` are
///               comments.
///  drawing      posts `o` or `+`, walls `---` and `|`; `S` start and `G` goal cells; 2h + 1 lines of 4w + 1
///               characters, first line = north; or cells of any other size, all alike: `+--+`. Missing ends of lines
///               count as blank. What follows a row after a blank, or the drawing after its last row of posts, is a
///               comment, as are lines before it that begin with `#`, `/`, `*` or `;`. `.` or ` . ` is a wall nobody
///               has looked at: read as open, on the border as closed (ReadNotes counts them).
///  maz          256 (16 x 16) or 1024 (32 x 32) bytes, byte x * size + y, bits 0 up, 1 right, 2 down, 3 left, 1 =
///               wall; high bits are ignored. Neighbours agree.
///  num          `X Y N E S W` per line, 1 = wall, every cell once, any order. Neighbours agree.
///  wkt          geometries on lines of their own or separated by `;`, upper or lower case, Z and M ignored: POLYGON,
///               MULTIPOLYGON, LINESTRING, MULTILINESTRING, LINEARRING (walls), POINT, MULTIPOINT (the start, then
///               the goal; of more than two none, with a remark), GEOMETRYCOLLECTION; EMPTY is skipped,
///               so is `SRID=...;` and lines that begin with `#`. A table (CSV) with a column of WKT is read as that
///               column. Z and M may be NaN.
///  geojson      Geometry, Feature, FeatureCollection (RFC 7946), or one of them a line (with or without the RS
///               character of RFC 8142); any coordinate system taken as a plane. Properties are the writer's own: of
///               "role" = "free" | "obstacle" | "wall" | "start" | "goal" | "door" | "opening", "thickness" of walls,
///               "boundary" = "walled" | "limit" of free polygons, in the properties or in an object "taut" among
///               them, these values count where they fit the geometry, any other is none. Without a role polygons are
///               as ReadOptions says, lines are walls; of points two are start and goal when they are all there are,
///               else none, with a remark. A goal that is a polygon or multipolygon of axis-parallel rectangles is a
///               room; the outline of a polygon with role "wall" is walls. A line with role "door" or "opening" takes
///               away what it covers of the walls that it lies on.
///  movingai     MovingAI grid map: `type octile`, `height H`, `width W`, `map`, H rows of W cells; `.` `G` `S` free,
///               `@` `O` `T` `W` blocked. In the map's own coordinates: cell (column c, row r) is [c, c + 1] x [r, r +
///               1], y downwards. No start, no goal.
///
///  ros_map      the yaml file of a ROS map (ros_map.h), whose picture lies beside it: metres, y up, the border walled.
///  picture      a PNG or a portable grey map (P2, P5) alone, with ReadOptions::resolution: dark is blocked, as a
///               ROS map with default thresholds and origin 0, 0.
///  blocks       a cell a character: `#` blocked, blank, `.` or `_` free, `S` (or `s`, `A`) start, `G` (`g`, `E`, `B`,
///               `X`) goal; or a matrix of 0 (free) and 1 (blocked), with or without blanks, commas and brackets. Rows
///               from the top, 1 unit a cell, y up; ends are the middles of their cells; short rows end in free cells.
///
///  svg          a drawing: `line` and `polyline` are walls, `polygon`, `rect`, closed pieces of a `path` are polygons
///               without a role, or walls where nothing fills them (`fill` is `none`); pieces of one path are holes in
///               each other. Transforms count, widths and heights of strokes do not; y downwards. Texts and images are
///               left out with a remark; curves, circles, round corners, `use` are refused by name.
///
/// Broken rings that mean one thing are taken so, with a remark (mend_rings.h); those that cross, and those whose last
/// point is not their first, need ReadOptions::crossings. A floor plan wholly in another one changes nothing: a remark
/// says so.
///
/// Of drawing, maz and num: without S the start is the bottom left cell; without G the goal is the room in the middle,
/// 2 cells wide in an even direction and 1 in an odd one, unless the border has exactly two openings: then the world
/// goes from the one to the other.
///
///  integers     what is written, not read: walls and rings as integers over one unit (write_integers).
enum class Format {
  segments,
  cell_values,
  drawing,
  maz,
  num,
  wkt,
  geojson,
  movingai,
  ros_map,
  picture,
  blocks,
  svg,
  integers
};

/// The word for it in options: `segments`, `cells`, `drawing`, `maz`, `num`, `wkt`, `geojson`, `movingai`, `ros`,
/// `picture`, `blocks`, `svg`, `integers`.
std::string_view name(Format format);
/// Nothing for any other word.
std::optional<Format> format_named(std::string_view word);

/// How to read what the bytes alone do not say.
struct ReadOptions {
  enum class Polygons {
    free,       ///< floor plans: the world is their union (Boundary::walled)
    obstacles,  ///< solids
    nested,     ///< floor plans by the even-odd rule over all: one inside another is a hole (mend_rings.h)
  };
  std::optional<Format> format{};           ///< absent: by content
  Polygons polygons = Polygons::free;       ///< what polygons without a role are
  Crossings crossings = Crossings::refuse;  ///< even_odd: rings that cross are read, too, and open ones closed
  double cell_size = 1;                     ///< of grid mazes, > 0
  std::optional<double> resolution{};       ///< of a picture alone: metres a pixel, > 0
  bool unknown_is_free = false;             ///< of ros_map: cells between the thresholds
  Snap snap{};                              ///< what to join; grids, maps and pictures have nothing to join
  std::optional<double> wall_thickness{};   ///< of every wall, instead of what the bytes say
  /// Of segments, wkt and geojson: coordinates are longitude and latitude, also those of `start` and `goal`;
  /// thicknesses and what to snap are metres, and so is the world (geographic_world.h).
  bool project = false;
  std::optional<Point> start{};  ///< instead of what the bytes say
  std::optional<Point> goal{};
  std::string folder{};  ///< where files lie that the bytes name; read_world_file sets it
  std::string source{};  ///< file name for messages
};

/// What reading met that a World does not keep.
struct ReadNotes {
  Format format = Format::segments;
  std::size_t unknown_walls = 0;       ///< `.` in a drawing
  std::vector<std::string> remarks{};  ///< what was taken in a way that one may wish to know, a line each
  SnapReport snap{};                   ///< what was joined; a remark says so too
  std::vector<NearContact> near{};     ///< what still nearly touches; a remark says how many
  std::optional<std::string> crs{};    ///< of geojson: the name of the coordinate system that a member `crs` gives
  std::shared_ptr<const GeographicWorld> geographic{};  ///< where a world that was projected lies
};

/// The format of these bytes, by content alone. Throws InputError when they are empty or of no known format.
Format detect_format(std::string_view bytes, const std::string& source = {});

/// Reads a world; throws InputError with file, line and culprit. Time O(n log n), for text about 0.5 s per million
/// walls.
World read_world(std::string_view bytes, const ReadOptions& options = {}, ReadNotes* notes = nullptr);
World read_world(std::istream& in, const ReadOptions& options = {}, ReadNotes* notes = nullptr);

/// The same from a file, `-` for standard input. options.source is replaced by the path or `<stdin>`.
World read_world_file(const std::string& path, ReadOptions options = {}, ReadNotes* notes = nullptr);

/// The bytes of a file, `-` for standard input; what gzip packed is unpacked. Throws InputError when it is missing, a
/// directory or unreadable.
std::string read_bytes(const std::string& path);

}  // namespace taut
