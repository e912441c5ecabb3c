#include <taut/io/worlds/read_path.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>
#include <utility>

#include <taut/geometry/errors.h>

#include <taut/io/worlds/detail/path_json.h>
#include <taut/io/worlds/detail/path_poses.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::SourceLine;

std::string_view said(const detail::Lines& lines) { return detail::without_comment(lines.line()); }

bool begins_with(std::string_view text, std::string_view word) {
  return text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(), [](char wanted, char c) {
           return wanted == std::toupper(static_cast<unsigned char>(c));
         });
}

/// What a comment of the program's says of the points that follow.
void take_comment(std::string_view line, ClaimedPath& path) {
  constexpr std::string_view kSays = "# legs between points of a curve, no farther than ";
  const std::size_t at = line.find(kSays);
  if (at == std::string_view::npos) return;
  const char* const first = line.data() + at + kSays.size();
  path.approximate = true;
  double tolerance = 0;
  if (std::from_chars(first, line.data() + line.size(), tolerance).ec == std::errc() && tolerance > 0 &&
      std::isfinite(tolerance))
    path.tolerance = tolerance;
}

/// Of CSV the columns behind x and y are left out. A path of several begins where the number in front changes.
class LineReader {
 public:
  LineReader(const std::string& source, Breaks breaks) : source_(source), breaks_(breaks) {}

  std::vector<ClaimedPath> read(std::string_view bytes) {
    for (detail::Lines lines(bytes); lines.next();) {
      take_comment(lines.line(), said_);
      const std::string_view line = said(lines);
      if (breaks_ == Breaks::blank_lines && lines.line().empty()) ended_ = true;
      if (!line.empty() && !is_heading(line)) add(line, {source_, lines.number()});
    }
    if (paths_.empty()) paths_.push_back(said_);
    return std::move(paths_);
  }

 private:
  bool is_heading(std::string_view line) {
    if (!paths_.empty() || table_) return false;
    several_ = begins_with(line, "PATH,X,Y");
    table_ = several_ || begins_with(line, "X,Y");
    return table_;
  }

  void add(std::string_view line, const SourceLine& place) {
    std::vector<double> values;
    detail::Fields fields(line, place);
    for (std::string_view field; fields.next(field);) values.push_back(detail::coordinate(field, place));
    const bool ended = std::exchange(ended_, false) && !table_;
    if (paths_.empty() || ended || (several_ && !values.empty() && values.front() != number_)) {
      paths_.push_back(said_);
      number_ = values.empty() ? 0 : values.front();
    }
    const std::size_t skip = several_ ? 1 : 0;
    const std::size_t most = breaks_ == Breaks::blank_lines ? 3 : 2;
    if (values.size() < 2 + skip || (!table_ && values.size() > most))
      place.fail("a point is two numbers, not " + std::to_string(values.size()));
    paths_.back().points.push_back({values[skip], values[skip + 1]});
  }

  const std::string& source_;
  Breaks breaks_;
  bool table_ = false, several_ = false;
  bool ended_ = false;  // by a blank line
  double number_ = 0;   // of the path that is being read
  ClaimedPath said_;    // what comments say, without points
  std::vector<ClaimedPath> paths_;
};

constexpr double kSag = 1e-3;  // of an arc's radius: how far legs are from it

/// Legs along the arc from a through m to b.
void add_arc(ClaimedPath& path, Point a, Point m, Point b) {
  const double ux = m.x - a.x, uy = m.y - a.y, vx = b.x - a.x, vy = b.y - a.y, twice = 2 * (ux * vy - uy * vx);
  const double u2 = ux * ux + uy * uy, v2 = vx * vx + vy * vy;
  const Point centre{a.x + (vy * u2 - uy * v2) / twice, a.y + (ux * v2 - vx * u2) / twice};
  const double radius = std::hypot(a.x - centre.x, a.y - centre.y), whole = 2 * std::numbers::pi;
  if (twice != 0 && std::isfinite(radius)) {
    const double from = std::atan2(a.y - centre.y, a.x - centre.x), to = std::atan2(b.y - centre.y, b.x - centre.x);
    double sweep = std::fmod(to - from + 2 * whole, whole);
    if (twice < 0) sweep -= whole;
    const int legs = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (2 * std::acos(1 - kSag)))));
    for (int k = 1; k < legs; ++k) {
      const double angle = from + sweep * k / legs;
      path.points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    path.approximate = true;
    path.tolerance = std::max(path.tolerance, kSag * radius);
  }
  path.points.push_back(b);
}

/// `LINESTRING (0 0, 1 1)`, `POINT (0 0)`, COMPOUNDCURVEs of such and of CIRCULARSTRINGs; one after the other.
class WktReader {
 public:
  explicit WktReader(const std::string& source) : source_(source) {}

  std::vector<ClaimedPath> read(std::string_view bytes) {
    for (detail::Lines lines(bytes); lines.next();) {
      const SourceLine place{source_, lines.number()};
      if (std::exchange(closed_, closed_ && detail::trimmed(lines.line()).empty())) paths_.emplace_back();
      take_comment(lines.line(), paths_.back());
      for (std::string_view rest = said(lines); !rest.empty();) {
        if (std::exchange(closed_, false)) paths_.emplace_back();
        const std::size_t length = std::min(rest.find_first_of(",()"), rest.size());
        take(detail::trimmed(rest.substr(0, length)), place);
        if (length < rest.size()) take(rest[length], place);
        rest.remove_prefix(std::min(length + 1, rest.size()));
      }
    }
    if (paths_.size() > 1 && paths_.back().points.empty()) paths_.pop_back();  // a comment at the end
    return std::move(paths_);
  }

 private:
  void take(char mark, const SourceLine& place) {
    if (mark == '(') ++depth_;
    if (mark != ')') return;
    if (depth_-- == 0) place.fail("a ) without its (");
    if (std::exchange(in_arc_, false)) end_arc(place);
    closed_ = depth_ == 0;
  }

  /// A word outside of parentheses, or CIRCULARSTRING; else a point, Z and M left out.
  void take(std::string_view text, const SourceLine& place) {
    if (text.empty()) return;
    if (begins_with(text, "CIRCULARSTRING")) in_arc_ = true;
    if (std::isalpha(static_cast<unsigned char>(text.front())) != 0) return;
    if (depth_ == 0) place.fail("a point stands outside of parentheses");
    std::vector<double> values;
    detail::Fields fields(text, place);
    for (std::string_view field; fields.next(field);) values.push_back(detail::coordinate(field, place));
    if (values.size() < 2) place.fail("a point is two numbers, not " + std::to_string(values.size()));
    const Point p{values[0], values[1]};
    std::vector<Point>& points = in_arc_ ? arc_ : paths_.back().points;
    if (in_arc_ || points.empty() || points.back() != p) points.push_back(p);
  }

  void end_arc(const SourceLine& place) {
    if (arc_.size() < 3 || arc_.size() % 2 == 0)
      place.fail("a CIRCULARSTRING is 3, 5, 7, ... points, not " + std::to_string(arc_.size()));
    ClaimedPath& path = paths_.back();
    if (path.points.empty() || path.points.back() != arc_.front()) path.points.push_back(arc_.front());
    for (std::size_t i = 0; i + 2 < arc_.size(); i += 2) add_arc(path, arc_[i], arc_[i + 1], arc_[i + 2]);
    arc_.clear();
  }

  const std::string& source_;
  std::vector<ClaimedPath> paths_{ClaimedPath{}};
  int depth_ = 0;
  bool closed_ = false, in_arc_ = false;
  std::vector<Point> arc_;
};

/// Each message has the comment of its own in front of it.
std::vector<ClaimedPath> read_poses(std::string_view bytes, const std::string& source) {
  std::vector<ClaimedPath> paths = detail::read_paths_poses(bytes, source);
  std::size_t k = 0;
  for (detail::Lines lines(bytes); lines.next() && k < paths.size();) {
    if (lines.line() == "---")
      ++k;
    else
      take_comment(lines.line(), paths[k]);
  }
  return paths;
}

/// The first line that says something.
std::string_view first_words(std::string_view bytes) {
  for (detail::Lines lines(bytes); lines.next();)
    if (!said(lines).empty()) return said(lines);
  return {};
}

}  // namespace

std::vector<ClaimedPath> read_paths(std::string_view bytes, const std::string& source, Breaks breaks) {
  const std::string_view text = detail::trimmed(detail::stripped(bytes));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) throw InputError(source, 0, "file is empty");
  if (text[first] == '{' || text[first] == '[') return detail::read_paths_json(bytes, source);
  if (detail::holds_poses(bytes)) return read_poses(bytes, source);
  const std::string_view words = first_words(bytes);
  for (const char* word : {"LINESTRING", "POINT", "COMPOUNDCURVE", "CIRCULARSTRING"})
    if (begins_with(words, word)) return WktReader(source).read(bytes);
  return LineReader(source, breaks).read(bytes);
}

ClaimedPath read_path(std::string_view bytes, const std::string& source) {
  std::vector<ClaimedPath> paths = read_paths(bytes, source);
  if (paths.size() > 1) throw InputError(source, 0, "holds " + std::to_string(paths.size()) + " paths");
  return std::move(paths.front());
}

}  // namespace taut
