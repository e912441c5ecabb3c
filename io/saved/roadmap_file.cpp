#include <taut/io/saved/roadmap_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <taut/io/saved/detail/fnv.h>
#include <taut/io/saved/detail/saved_words.h>

namespace taut {

namespace {

using Vertex = Roadmap::Vertex;
using detail::one_line;
using detail::robot_text;

constexpr std::string_view kMagic = "taut roadmap ";
constexpr int kVersion = 1;
constexpr std::size_t kEndLine = 4 + 32 + 1;  // "end ", digits, line end

std::string hash_of(std::string_view bytes) {
  detail::Fnv hash;
  hash.add(bytes);
  return hash.hex();
}

/// Walks over the file's lines.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  [[noreturn]] void fail(const std::string& why) const { throw InputError(name_, line_, why); }

  int line_number() const { return line_; }

  std::string_view line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) throw InputError(name_, 0, "is cut off");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    ++line_;
    return line;
  }

  /// What follows the key on a line of its own.
  std::string value(std::string_view key) {
    const std::string_view text = line();
    if (!text.starts_with(key)) fail(fmt::format("'{} ...' should stand here", key));
    return std::string(text.substr(std::min(text.size(), key.size() + 1)));
  }

  std::size_t count(std::string_view key) {
    const std::string text = value(key);
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    // Each takes a byte at least: no file makes us ask for more memory than it has bytes.
    if (error != std::errc{} || end != text.data() + text.size() || n > rest_.size())
      fail(fmt::format("how many {}?", key));
    return n;
  }

  Point point() {
    const std::string_view text = line();
    const char* const last = text.data() + text.size();
    Point p;
    const auto x = std::from_chars(text.data(), last, p.x);
    if (x.ec != std::errc{} || x.ptr == last || *x.ptr != ' ') fail("a vertex is `x y`");
    const auto y = std::from_chars(x.ptr + 1, last, p.y);
    if (y.ec != std::errc{} || y.ptr != last || !std::isfinite(p.x) || !std::isfinite(p.y)) fail("a vertex is `x y`");
    return p;
  }

  void row(Vertex v, std::size_t vertices, std::vector<std::pair<Vertex, Vertex>>& edges) {
    const std::string_view text = line();
    const char* at = text.data();
    const char* const last = at + text.size();
    for (Vertex least = v; at != last;) {
      Vertex w = 0;
      const auto [end, error] = std::from_chars(at, last, w);
      if (error != std::errc{} || w <= least || w >= vertices || (end != last && *end != ' '))
        fail(fmt::format("the neighbours of vertex {} are no ascending list of vertices above it", v));
      edges.emplace_back(v, least = w);
      at = end == last ? end : end + 1;
    }
  }

 private:
  std::string_view rest_;
  const std::string& name_;
  int line_ = 0;
};

void require_this_format(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(kMagic)) throw InputError(name, 0, "is no saved roadmap");
  const std::string_view version = bytes.substr(kMagic.size(), bytes.find('\n') - kMagic.size());
  if (version != std::to_string(kVersion))
    throw InputError(name, 0,
                     fmt::format("is a saved roadmap of version {}; this program reads version {}",
                                 one_line(std::string(version.substr(0, 20))), kVersion));
}

/// All but the last line, which vouches for them.
std::string_view checked_body(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kEndLine || bytes.back() != '\n' || !bytes.substr(bytes.size() - kEndLine).starts_with("end "))
    throw InputError(name, 0, "is cut off: its last line is not `end` and a checksum");
  const std::string_view body = bytes.substr(0, bytes.size() - kEndLine);
  if (bytes.substr(bytes.size() - 33, 32) != hash_of(body))
    throw InputError(name, 0, "is damaged: its checksum is not that of its content");
  return body;
}

}  // namespace

std::string roadmap_file(const SavedRoadmap& saved, const FreeSpace& space) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  const Roadmap& roadmap = saved.roadmap;
  fmt::format_to(put, "{}{}\nkind {}\nhow {}\nsource {}\nworld {}\nrobot {}\nvertices {}\n", kMagic, kVersion,
                 saved.kind, one_line(saved.how), one_line(space.world().source()), fingerprint(space.world()),
                 robot_text(space.footprint()), roadmap.vertex_count());
  for (const Point p : roadmap.points()) fmt::format_to(put, "{} {}\n", p.x, p.y);
  fmt::format_to(put, "edges {}\n", roadmap.edge_count());
  for (Vertex v = 0; v < roadmap.vertex_count(); ++v) {
    const char* separator = "";
    for (const Vertex w : roadmap.neighbours(v))
      if (w > v) fmt::format_to(put, "{}{}", std::exchange(separator, " "), w);
    out.push_back('\n');
  }
  fmt::format_to(put, "end {}\n", hash_of({out.data(), out.size()}));
  return {out.data(), out.size()};
}

SavedRoadmap read_roadmap_file(std::string_view bytes, const std::string& name, const FreeSpace& space) {
  require_this_format(bytes, name);
  Reader reader(checked_body(bytes, name), name);
  reader.line();
  SavedRoadmap saved{reader.value("kind"), reader.value("how"), reader.value("source"), {}, 0, 0};
  const std::string world = reader.value("world"), robot = reader.value("robot");
  detail::require_same_world(name, space, saved.source, world, robot);
  std::vector<Point> points(reader.count("vertices"));
  saved.first_vertex_line = reader.line_number() + 1;
  for (Point& p : points) p = reader.point();
  const std::size_t edge_count = reader.count("edges");
  std::vector<std::pair<Vertex, Vertex>> edges;
  edges.reserve(edge_count);
  saved.first_row_line = reader.line_number() + 1;
  for (Vertex v = 0; v < points.size(); ++v) reader.row(v, points.size(), edges);
  if (edges.size() != edge_count) reader.fail("there are more or fewer edges than announced");
  saved.roadmap = Roadmap(std::move(points), edges);
  return saved;
}

}  // namespace taut
