#include <fmt/format.h>

#include <cctype>
#include <optional>
#include <string>
#include <utility>

#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/shapes.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/detail/wkt_table.h>

namespace taut::detail {

namespace {

constexpr int kDeepest = 32;

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

class Wkt {
 public:
  Wkt(std::string_view bytes, const ReadOptions& options)
      : rest_(stripped(bytes)), source_(options.source), shapes_(options) {}

  WorldParts read(ReadNotes& notes) {
    for (;;) {
      skip_separators();
      if (rest_.empty()) return shapes_.take(Shapes::Alone::one_or_two, notes);
      if (!skip_srid()) geometry(0);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { SourceLine{source_, line_}.fail(message); }

  void advance() {
    if (rest_.front() == '\n') ++line_;
    rest_.remove_prefix(1);
  }

  void skip_space() {
    while (!rest_.empty() && is_space(rest_.front())) advance();
  }

  // Between geometries: blanks, semicolons, comment lines.
  void skip_separators() {
    for (skip_space(); !rest_.empty() && (rest_.front() == ';' || rest_.front() == '#'); skip_space()) {
      if (rest_.front() == ';')
        advance();
      else
        while (!rest_.empty() && rest_.front() != '\n') advance();
    }
  }

  bool skip_srid() {
    if (rest_.size() < 5 || upper(rest_.substr(0, 5)) != "SRID=") return false;
    while (!rest_.empty() && rest_.front() != ';' && rest_.front() != '\n') advance();
    return true;
  }

  static std::string upper(std::string_view text) {
    std::string out;
    for (char c : text) out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return out;
  }

  // What stands here, for messages.
  std::string found() const {
    if (rest_.empty()) return "the end of the file";
    std::size_t end = 1;
    while (end < rest_.size() && !is_space(rest_[end]) && rest_[end] != ',' && rest_[end] != '(' && rest_[end] != ')')
      ++end;
    return quoted(rest_.substr(0, end));
  }

  std::string word() {
    skip_space();
    std::size_t end = 0;
    while (end < rest_.size() && is_letter(rest_[end])) ++end;
    std::string result = upper(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return result;
  }

  bool take(char c) {
    skip_space();
    if (rest_.empty() || rest_.front() != c) return false;
    advance();
    return true;
  }

  void expect(char c) {
    if (!take(c)) fail(std::string("'") + c + "' is expected, not " + found());
  }

  bool take_empty() {
    skip_space();
    if (upper(rest_.substr(0, 5)) != "EMPTY" || (rest_.size() > 5 && is_letter(rest_[5]))) return false;
    rest_.remove_prefix(5);
    return true;
  }

  // `POLYGON`, without the Z and M that may follow at once or after a blank.
  std::string kind() {
    skip_space();
    const std::string shown = found();
    std::string result = word();
    if (result.empty()) fail("a geometry is expected, not " + shown);
    if (result.ends_with("ZM"))
      result.resize(result.size() - 2);
    else if (result.ends_with('Z') || result.ends_with('M'))
      result.pop_back();
    skip_space();
    const std::string_view before = rest_;
    const std::string dimensions = word();
    if (dimensions != "Z" && dimensions != "M" && dimensions != "ZM") rest_ = before;
    return result;
  }

  void geometry(int depth) {
    if (depth > kDeepest) fail("geometry collections are nested more than " + std::to_string(kDeepest) + " deep");
    const int line = line_;
    const std::string shown = found();
    const std::string what = kind();
    if (take_empty()) return;
    if (what == "POINT") return list([&] { shapes_.add_point(position()); }, false);
    if (what == "MULTIPOINT") return list([&] { multipoint_member(); });
    if (what == "LINESTRING" || what == "LINEARRING") return shapes_.add_walls(chain(), 0, line);
    if (what == "MULTILINESTRING") return list([&] { line_member(); });
    if (what == "POLYGON" || what == "TRIANGLE") return polygon();
    if (what == "MULTIPOLYGON" || what == "POLYHEDRALSURFACE") return list([&] { polygon(); });
    if (what == "GEOMETRYCOLLECTION") return list([&] { geometry(depth + 1); });
    const bool curved = what == "CIRCULARSTRING" || what == "COMPOUNDCURVE" || what == "CURVEPOLYGON" ||
                        what == "MULTICURVE" || what == "MULTISURFACE";
    SourceLine{source_, line}.fail("geometry " + shown + " is not supported" +
                                   (curved ? ": write its curves as legs (ST_CurveToLine)" : ""));
  }

  // ( item, item, ... )
  template <class Item>
  void list(Item item, bool many = true) {
    expect('(');
    do item();
    while (many && take(','));
    expect(')');
  }

  void multipoint_member() {
    if (take_empty()) return;
    const bool wrapped = take('(');
    shapes_.add_point(position());
    if (wrapped) expect(')');
  }

  void line_member() {
    skip_space();
    const int line = line_;
    if (!take_empty()) shapes_.add_walls(chain(), 0, line);
  }

  void polygon() {
    if (take_empty()) return;
    const int line = line_;
    Polygon result;
    bool first = true;
    list([&] {
      skip_space();
      const int ring_line = line_;
      Ring ring = shapes_.ring(chain(), ring_line);
      if (std::exchange(first, false))
        result.outer = std::move(ring);
      else
        result.holes.push_back(std::move(ring));
    });
    shapes_.add_polygon(std::move(result), line);
  }

  Ring chain() {
    Ring result;
    list([&] { result.push_back(position()); });
    return result;
  }

  // Two to four numbers; the first two count.
  Point position() {
    const double x = number(), y = number();
    for (int more = 0; more < 2; ++more) {
      skip_space();
      if (rest_.empty() || rest_.front() == ',' || rest_.front() == ')') break;
      skip_number();
    }
    return {x, y};
  }

  std::string_view field() {
    skip_space();
    std::size_t end = 0;
    while (end < rest_.size() && !is_space(rest_[end]) && rest_[end] != ',' && rest_[end] != '(' && rest_[end] != ')')
      ++end;
    if (end == 0) fail("a number is expected, not " + found());
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return text;
  }

  double number() { return coordinate(field(), {source_, line_}); }

  // Z or M: may be NaN.
  void skip_number() {
    const std::string_view text = field();
    const std::string word = upper(text);
    if (word != "NAN" && word != "-NAN") coordinate(text, {source_, line_});
  }

  std::string_view rest_;
  const std::string& source_;
  int line_ = 1;
  Shapes shapes_;
};

}  // namespace

WorldParts read_wkt(std::string_view bytes, const ReadOptions& options, ReadNotes& notes) {
  const std::optional<WktColumn> column = wkt_column(bytes);
  if (column && column->passed_by)
    notes.remarks.push_back(fmt::format("geometries are read from column {}, those of column {} are left out",
                                        column->number, *column->passed_by));
  return Wkt(column ? std::string_view(column->bytes) : bytes, options).read(notes);
}

}  // namespace taut::detail
