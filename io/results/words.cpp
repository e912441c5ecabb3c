#include <taut/io/results/words.h>

#include <fmt/format.h>

#include <algorithm>

namespace taut {

std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string seconds_text(double seconds) {
  if (seconds < 0.0005) return "<0.001 s";
  return seconds < 1 ? fmt::format("{:.3f} s", seconds) : fmt::format("{:.{}f} s", seconds, seconds < 10 ? 2 : 1);
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

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + "\"";
}

std::string title_of(const std::string& source) { return source.substr(source.find_last_of('/') + 1); }

}  // namespace taut
