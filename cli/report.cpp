#include <taut/cli/report.h>

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/geometry/written.h>

namespace taut::cli {

namespace {

// With its ends in order, to be found again.
std::pair<Point, Point> key(const Constraint& c) { return std::minmax(c.a, c.b); }

std::vector<Constraint> without_dead_ends(const std::vector<Constraint>& chain) {
  std::map<std::pair<Point, Point>, int> passes;
  for (const Constraint& c : chain) ++passes[key(c)];
  std::vector<Constraint> rest;
  for (const Constraint& c : chain)
    if (passes[key(c)] == 1) rest.push_back(c);
  return rest;
}

// Turns each piece so that it begins where the one before ends.
std::vector<Segment> oriented(const std::vector<Constraint>& chain) {
  std::vector<Segment> result;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    Segment s{chain[i].a, chain[i].b};
    const bool follows = i > 0 && (result.back().b == s.a || result.back().b == s.b);
    const bool flip =
        follows ? s.b == result.back().b : i + 1 < chain.size() && (s.a == chain[i + 1].a || s.a == chain[i + 1].b);
    if (flip) std::swap(s.a, s.b);
    result.push_back(s);
  }
  return result;
}

bool on_side(const Constraint& c, const Box& box) {
  return (c.a.x == c.b.x && (c.a.x == box.min.x || c.a.x == box.max.x)) ||
         (c.a.y == c.b.y && (c.a.y == box.min.y || c.a.y == box.max.y));
}

// Beginning after a gap, where there is one.
std::vector<Constraint> without_border(std::vector<Constraint> chain, const Box& border) {
  const auto gap = std::find_if(chain.begin(), chain.end(), [&](const Constraint& c) { return on_side(c, border); });
  if (gap == chain.end()) return chain;
  std::rotate(chain.begin(), gap, chain.end());
  std::vector<Constraint> rest;
  std::remove_copy_if(chain.begin(), chain.end(), std::back_inserter(rest),
                      [&](const Constraint& c) { return on_side(c, border); });
  return rest.empty() ? chain : rest;
}

bool goes_on(const Segment& s, const Segment& next) {
  return s.b == next.a && written::orientation(s.a, s.b, next.b) == 0 && written::on_segment(s.b, s.a, next.b);
}

}  // namespace

std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string seconds_text(double seconds) {
  if (seconds < 0.0005) return "<0.001 s";
  return seconds < 1 ? fmt::format("{:.3f} s", seconds) : fmt::format("{:.{}f} s", seconds, seconds < 10 ? 2 : 1);
}

void note_stage(const char* stage, double seconds, const std::string& what) {
  note(fmt::format("{:<12}{:>9.4f} s   {}", stage, seconds, what));
}

std::string length_text(const Length& length) {
  const double value = length.value();
  return value == 0 || (value >= 1e-3 && value < 1e12) ? length.decimals(6) : fmt::format("{:.9g}", value);
}

std::string count_text(std::size_t count, const char* one, const char* many) {
  if (count == 1) return fmt::format("1 {}", one);
  return many ? fmt::format("{} {}", count, many) : fmt::format("{} {}s", count, one);
}

std::string points_text(const std::vector<Point>& points) {
  std::string lines;
  for (const Point& p : points) lines += number_text(p.x) + " " + number_text(p.y) + "\n";
  return lines;
}

std::string point_text(Point p) { return fmt::format("({}, {})", number_text(p.x), number_text(p.y)); }

std::string segment_text(const Segment& s) { return point_text(s.a) + "-" + point_text(s.b); }

std::string segments_text(const std::vector<Segment>& segments, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < std::min(most, segments.size()); ++i) out += (i ? ", " : "") + segment_text(segments[i]);
  return segments.size() > most ? out + fmt::format(" and {} more", segments.size() - most) : out;
}

std::string title_of(const std::string& source) { return source.substr(source.find_last_of('/') + 1); }

std::string peak_memory_text() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return fmt::format("{:.1f} MB", static_cast<double>(usage.ru_maxrss) / 1024);
}

std::vector<Segment> joined_walls(const std::vector<Constraint>& chain, const Box& border) {
  std::vector<Segment> joined;
  for (const Segment& s : oriented(without_border(without_dead_ends(chain), border))) {
    if (!joined.empty() && goes_on(joined.back(), s))
      joined.back().b = s.b;
    else
      joined.push_back(s);
  }
  if (joined.size() > 1 && goes_on(joined.back(), joined.front())) {
    joined.front().a = joined.back().a;
    joined.pop_back();
  }
  return joined;
}

}  // namespace taut::cli
