#include <taut/io/worlds/read_path.h>

#include <algorithm>
#include <cctype>

#include <taut/geometry/errors.h>

#include <taut/io/worlds/detail/path_json.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::Place;

/// The text of a line before a comment.
std::string_view said(const detail::Lines& lines) {
  return detail::trimmed(lines.line().substr(0, lines.line().find('#')));
}

bool begins_with(std::string_view text, std::string_view word) {
  return text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(), [](char wanted, char c) {
           return wanted == std::toupper(static_cast<unsigned char>(c));
         });
}

/// Of CSV the columns behind x and y are left out.
ClaimedPath read_lines(std::string_view bytes, const std::string& source) {
  ClaimedPath path;
  bool table = false;
  for (detail::Lines lines(bytes); lines.next();) {
    const std::string_view line = said(lines);
    if (line.empty()) continue;
    const Place place{source, lines.number()};
    if (path.points.empty() && !table && begins_with(line, "PATH,X,Y")) place.fail("holds several paths");
    if (path.points.empty() && !table && (table = begins_with(line, "X,Y"))) continue;
    std::vector<double> values;
    detail::Fields fields(line, place);
    for (std::string_view field; fields.next(field);) values.push_back(detail::coordinate(field, place));
    if (values.size() < 2 || (!table && values.size() != 2))
      place.fail("a point is two numbers, not " + std::to_string(values.size()));
    path.points.push_back({values[0], values[1]});
  }
  return path;
}

/// A word outside of parentheses, or CIRCULARSTRING; else a point, Z and M left out.
void add_wkt(ClaimedPath& path, std::string_view text, int depth, const Place& place) {
  if (text.empty()) return;
  if (begins_with(text, "CIRCULARSTRING") || begins_with(text, "COMPOUNDCURVE")) path.approximate = true;
  if (std::isalpha(static_cast<unsigned char>(text.front())) != 0) return;
  if (depth == 0) place.fail("a point stands outside of parentheses");
  std::vector<double> values;
  detail::Fields fields(text, place);
  for (std::string_view field; fields.next(field);) values.push_back(detail::coordinate(field, place));
  if (values.size() < 2) place.fail("a point is two numbers, not " + std::to_string(values.size()));
  const Point p{values[0], values[1]};
  if (path.points.empty() || path.points.back() != p) path.points.push_back(p);
}

/// Of `LINESTRING (0 0, 1 1)`, `POINT (0 0)` or a COMPOUNDCURVE: everything is a point but words and parentheses.
ClaimedPath read_wkt(std::string_view bytes, const std::string& source) {
  ClaimedPath path;
  int geometries = 0, depth = 0;
  for (detail::Lines lines(bytes); lines.next();) {
    path.approximate = path.approximate || lines.line().find('#') != std::string_view::npos;
    const Place place{source, lines.number()};
    for (std::string_view rest = said(lines); !rest.empty();) {
      const std::size_t length = std::min(rest.find_first_of(",()"), rest.size());
      add_wkt(path, detail::trimmed(rest.substr(0, length)), depth, place);
      if (length < rest.size() && rest[length] == '(' && depth++ == 0 && ++geometries > 1)
        place.fail("holds several paths");
      if (length < rest.size() && rest[length] == ')' && depth-- == 0) place.fail("a ) without its (");
      rest.remove_prefix(std::min(length + 1, rest.size()));
    }
  }
  return path;
}

/// The first line that says something.
std::string_view first_words(std::string_view bytes) {
  for (detail::Lines lines(bytes); lines.next();)
    if (!said(lines).empty()) return said(lines);
  return {};
}

}  // namespace

ClaimedPath read_path(std::string_view bytes, const std::string& source) {
  const std::string_view text = detail::trimmed(detail::stripped(bytes));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) throw InputError(source, 0, "file is empty");
  if (text[first] == '{' || text[first] == '[') return detail::read_path_json(bytes, source);
  const std::string_view words = first_words(bytes);
  for (const char* word : {"LINESTRING", "POINT", "COMPOUNDCURVE"})
    if (begins_with(words, word)) return read_wkt(bytes, source);
  return read_lines(bytes, source);
}

}  // namespace taut
