#include <taut/io/results/visibility_stream.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include <taut/geometry/text.h>

namespace taut {

namespace {

constexpr std::size_t kPiece = 1 << 16;

/// Text that goes on in pieces.
class Pieces {
 public:
  explicit Pieces(const std::function<void(std::string_view)>& write) : write_(write) { text_.reserve(kPiece + 128); }

  void vertex(Point p) {
    text_ += "v ";
    append(text_, p.x);
    text_ += ' ';
    append(text_, p.y);
    end_line();
  }
  void edge(Roadmap::Vertex u, Roadmap::Vertex v) {
    text_ += "e ";
    add(u);
    text_ += ' ';
    add(v);
    end_line();
  }
  void end(std::uint64_t edges) {
    text_ += "end ";
    add(edges);
    end_line();
    write_(text_);
  }

 private:
  void add(std::uint64_t n) {
    char digits[24];
    text_.append(digits, std::to_chars(digits, digits + sizeof digits, n).ptr);
  }
  void end_line() {
    text_ += '\n';
    if (text_.size() < kPiece) return;
    write_(text_);
    text_.clear();
  }

  const std::function<void(std::string_view)>& write_;
  std::string text_;
};

}  // namespace

std::uint64_t stream_visibility(const VisibilityRows& rows, const std::function<void(std::string_view)>& write,
                                const TellProgress& tell) {
  Pieces pieces(write);
  const Triangulation& tri = rows.space().triangulation();
  for (const std::uint32_t sector : rows.vertices().sectors) pieces.vertex(tri.points[tri.sectors[sector].vertex]);
  VisibilityRows::Finder finder(rows);
  std::uint64_t edges = 0;
  std::vector<Roadmap::Vertex> sorted;
  ProgressCount done("corners", rows.vertices().sectors.size(), tell);
  for (Roadmap::Vertex u = 0; u < rows.vertices().sectors.size(); ++u, done.add()) {
    const auto row = finder.row(u);
    sorted.assign(row.begin(), row.end());
    std::sort(sorted.begin(), sorted.end());
    for (const Roadmap::Vertex v : sorted) pieces.edge(u, v);
    edges += sorted.size();
  }
  pieces.end(edges);
  return edges;
}

}  // namespace taut
