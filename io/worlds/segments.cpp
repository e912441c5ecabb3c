#include <array>
#include <map>
#include <utility>
#include <vector>

#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut::detail {

namespace {

using Numbers = std::vector<double>;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// A word that std::from_chars would not take for a number.
bool is_word(std::string_view field) {
  if (!is_letter(field[0])) return false;
  std::string lower;
  for (char c : field.substr(0, 9)) lower += static_cast<char>(c | 0x20);
  return lower != "nan" && lower != "inf" && lower != "infinity";
}

class Segments {
 public:
  explicit Segments(const std::string& source) : source_(source) { parts_.source = source; }

  WorldParts read(std::string_view bytes) {
    for (Lines lines(bytes); lines.next();) {
      const std::string_view line = lines.line().substr(0, lines.line().find('#'));
      if (line.empty()) continue;
      if (parts_.walls.empty() && is_header_of_segments(line)) continue;
      read_line(line, {source_, lines.number()});
    }
    return std::move(parts_);
  }

 private:
  void read_line(std::string_view line, const SourceLine& place) {
    Fields fields(line, place);
    std::string_view field;
    if (!fields.next(field)) return;
    if (is_word(field)) {
      read_directive(field, fields, place);
    } else {
      read_wall(field, fields, place);
    }
  }

  void read_wall(std::string_view field, Fields& fields, const SourceLine& place) {
    std::array<double, 5> v{};
    std::size_t n = 0;
    do {
      if (n == 5) place.fail("more than five numbers; a wall is x1 y1 x2 y2 [thickness]");
      v[n++] = coordinate(field, place);
    } while (fields.next(field));
    if (n < 4)
      place.fail("only " + std::to_string(n) + (n == 1 ? " number" : " numbers") +
                 "; a wall is x1 y1 x2 y2 [thickness]");
    if (v[4] < 0) place.fail("wall thickness " + text(v[4]) + " is negative");
    parts_.walls.push_back({{v[0], v[1]}, {v[2], v[3]}, v[4], place.line});
  }

  void read_directive(std::string_view word, Fields& fields, const SourceLine& place) {
    if (word != "start" && word != "goal" && word != "boundary")
      place.fail(quoted(word) + " is neither a number nor start, goal or boundary");
    const auto [first, fresh] = seen_.emplace(word, place.line);
    if (!fresh) place.fail("a second " + std::string(word) + "; the first is in line " + std::to_string(first->second));
    Numbers v;
    for (std::string_view field; fields.next(field);) v.push_back(coordinate(field, place));
    if (word == "start") read_start(v, place);
    if (word == "goal") read_goal(v, place);
    if (word == "boundary") read_boundary(v, place);
  }

  void read_start(const Numbers& v, const SourceLine& place) {
    if (v.size() != 2) place.fail("start needs two numbers: start X Y");
    parts_.start = Point{v[0], v[1]};
  }

  void read_goal(const Numbers& v, const SourceLine& place) {
    if (v.size() == 2) {
      parts_.goal.point = Point{v[0], v[1]};
      return;
    }
    if (v.empty() || v.size() % 4 != 0)
      place.fail("goal needs two numbers, goal X Y, or four for each box: goal XMIN YMIN XMAX YMAX ...");
    for (std::size_t i = 0; i < v.size(); i += 4)
      parts_.goal.room.push_back(box({v[i], v[i + 1]}, {v[i + 2], v[i + 3]}, "goal", place));
  }

  void read_boundary(const Numbers& v, const SourceLine& place) {
    Ring ring;
    if (v.size() == 4) {
      const Box b = box({v[0], v[1]}, {v[2], v[3]}, "boundary", place);
      ring = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}};
    } else if (v.size() >= 6 && v.size() % 2 == 0) {
      for (std::size_t i = 0; i < v.size(); i += 2) ring.push_back({v[i], v[i + 1]});
    } else {
      place.fail("boundary needs XMIN YMIN XMAX YMAX or at least three points");
    }
    parts_.areas = {{{std::move(ring), {}}, place.line}};
    parts_.boundary = Boundary::limit;
  }

  static Box box(Point min, Point max, const char* what, const SourceLine& place) {
    if (min.x >= max.x || min.y >= max.y)
      place.fail(std::string(what) + " box from " + text(min) + " to " + text(max) +
                 " has no area: the lower left corner comes first");
    return {min, max};
  }

  const std::string& source_;
  WorldParts parts_;
  std::map<std::string, int, std::less<>> seen_;
};

}  // namespace

bool is_header_of_segments(std::string_view line) {
  std::string names;
  for (const char c : line) {
    if (is_letter(c)) names += static_cast<char>(c | 0x20);
    if (c >= '0' && c <= '9') names += c;
  }
  return names == "x1y1x2y2" || names == "x1y1x2y2thickness";
}

WorldParts read_segments(std::string_view bytes, const std::string& source) { return Segments(source).read(bytes); }

}  // namespace taut::detail
