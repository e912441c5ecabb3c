// Roadmaps kept in files, so that many queries share one build.
#pragma once

#include <string>
#include <string_view>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/roadmap.h>

namespace taut {

/// A roadmap and what it was made of.
struct SavedRoadmap {
  std::string kind;    ///< one word: `visibility`, `cells8`, ...
  std::string how;     ///< the builder's settings in one line, may be empty: `samples 500 seed 7`
  std::string source;  ///< the world's file; filled in by roadmap_file
  Roadmap roadmap;
  int first_vertex_line = 0;  ///< where vertex 0 stands, when read; vertex v stands v lines further on
  int first_row_line = 0;     ///< likewise its neighbours

  int line_of(Roadmap::Vertex v, bool is_row) const {
    return (is_row ? first_row_line : first_vertex_line) + static_cast<int>(v);
  }
};

/// 32 hexadecimal digits that stand for a world, the same on every machine and in every version that reads file version
/// 1: FNV-1a with 128 bits over areas, boundary, walls with thickness, and solids. The order of walls, areas and
/// solids, the direction of walls and the vertex a ring begins with do not count; neither do start, goal, line numbers
/// and file names. (Of a world without any boundary the box around it depends on the ends, so it counts there.)
std::string fingerprint(const World& world);

/// The file, text:
///
///     taut roadmap 1
///     kind visibility
///     how
///     source data/maze_25x25.txt
///     world 0d3f...               fingerprint(world)
///     robot disc 0.2              or `point`, `square R`, `polygon x y x y ...`
///     vertices 2
///     0.5 1.5
///     2.5 1.5
///     edges 1
///     1                           line v: the neighbours of vertex v above v, ascending, blanks between them
///
///     end 8a01...                 FNV-1a of all bytes before this line
///
/// Numbers are the shortest that read back as the same double. Same roadmap, same bytes.
std::string roadmap_file(const SavedRoadmap& saved, const FreeSpace& space);

/// Reads what roadmap_file wrote, for a space of the same world and robot. `name` is the file's, for messages. Throws
/// InputError, in one line: it is no such file, of another version, cut off, damaged, of another world (naming both) or
/// for another robot. A checksum
/// protects from accidents only: whether kind, vertices and edges are right is for the one who uses it to ask
/// (roadmap_check.h). O(bytes + E log E).
SavedRoadmap read_roadmap_file(std::string_view bytes, const std::string& name, const FreeSpace& space);

}  // namespace taut
