#include <taut/io/worlds/detail/wkt_table.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>
#include <vector>

#include <taut/io/worlds/detail/text_input.h>

namespace taut::detail {

namespace {

constexpr std::size_t kRowsLookedAt = 50;  // the first ones may have no geometry

// A field of a table: where its content lies. Quotes are not in it.
struct Field {
  std::size_t begin = 0;
  std::size_t end = 0;
};
using Row = std::vector<Field>;

class Table {
 public:
  Table(std::string_view bytes, char separator) : bytes_(bytes), separator_(separator) {}

  bool next(Row& row) {
    row.clear();
    if (at_ == bytes_.size()) return false;
    do row.push_back(field());
    while (at_ < bytes_.size() && bytes_[at_] == separator_ && ++at_ <= bytes_.size());
    if (at_ < bytes_.size()) ++at_;  // the line's end
    return true;
  }

  std::string_view text(const Field& f) const { return trimmed(bytes_.substr(f.begin, f.end - f.begin)); }

 private:
  bool at_end() const { return at_ == bytes_.size() || bytes_[at_] == separator_ || bytes_[at_] == '\n'; }

  Field field() {
    while (!at_end() && (bytes_[at_] == ' ' || bytes_[at_] == '\r')) ++at_;
    if (at_ < bytes_.size() && bytes_[at_] == '"') return quoted_field();
    const Field f{at_, plain_end()};
    at_ = f.end;
    return f;
  }

  Field quoted_field() {
    Field f{at_ + 1, at_ + 1};
    for (f.end = f.begin; f.end < bytes_.size(); ++f.end) {
      if (bytes_[f.end] != '"') continue;
      if (f.end + 1 == bytes_.size() || bytes_[f.end + 1] != '"') break;
      ++f.end;
    }
    at_ = std::min(f.end + 1, bytes_.size());
    while (!at_end()) ++at_;
    return f;
  }

  // Of a geometry that nobody quoted: behind its last bracket.
  std::size_t plain_end() const {
    std::size_t end = at_;
    int depth = 0;
    const bool is_geometry = begins_wkt(bytes_.substr(at_, 64));
    for (; end < bytes_.size() && bytes_[end] != '\n'; ++end) {
      if (bytes_[end] == separator_ && depth <= 0) break;
      if (is_geometry) depth += (bytes_[end] == '(') - (bytes_[end] == ')');
    }
    return end;
  }

  std::string_view bytes_;
  char separator_;
  std::size_t at_ = 0;
};

std::string blanks(std::string_view bytes) {
  std::string result(bytes);
  std::ranges::replace_if(
      result, [](char c) { return c != '\n'; }, ' ');
  return result;
}

// For each column, in how many of the first rows `is` holds for it.
template <class Is>
std::vector<std::size_t> counts(std::string_view bytes, char separator, Is is) {
  std::vector<std::size_t> result;
  Table table(bytes, separator);
  Row row;
  for (std::size_t i = 0; i < kRowsLookedAt && table.next(row); ++i) {
    if (result.size() < row.size()) result.resize(row.size());
    for (std::size_t c = 0; c < row.size(); ++c) result[c] += is(table.text(row[c]));
  }
  return result;
}

// Longer than a name of a column could be.
bool is_geometry(std::string_view text) {
  return begins_wkt(text) && (text.find('(') != std::string_view::npos || text.ends_with("EMPTY"));
}

// All but that column becomes blanks, and its name, if it has one.
std::string only(std::size_t column, std::string_view bytes, char separator) {
  std::string result = blanks(bytes);
  Table table(bytes, separator);
  Row row;
  for (bool is_first = true; table.next(row); is_first = false)
    if (column < row.size() && (!is_first || is_geometry(table.text(row[column]))))
      std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(row[column].begin),
                bytes.begin() + static_cast<std::ptrdiff_t>(row[column].end),
                result.begin() + static_cast<std::ptrdiff_t>(row[column].begin));
  return result;
}

// Neither WKT as it is nor JSON.
bool may_be_table(std::string_view bytes) {
  for (Lines lines(bytes); lines.next();) {
    const std::string_view line = trimmed(lines.line());
    if (line.empty() || line[0] == '#') continue;
    return line[0] != '{' && line[0] != '[' && line[0] != '\x1e' && !begins_wkt(line);
  }
  return false;
}

constexpr std::array kSeparators{',', ';', '\t', '|'};

bool is_hex(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

}  // namespace

bool begins_wkt(std::string_view text) {
  static constexpr std::array<std::string_view, 16> kinds{
      "POINT",         "LINEARRING",         "LINESTRING",   "POLYGON",          "MULTIPOINT",   "MULTILINESTRING",
      "MULTIPOLYGON",  "GEOMETRYCOLLECTION", "SRID",         "TRIANGLE",         "CURVEPOLYGON", "CIRCULARSTRING",
      "COMPOUNDCURVE", "MULTICURVE",         "MULTISURFACE", "POLYHEDRALSURFACE"};
  std::string word;
  for (const char c : text) {
    if (!std::isalpha(static_cast<unsigned char>(c))) break;
    word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return std::any_of(kinds.begin(), kinds.end(), [&](std::string_view kind) {
    if (!word.starts_with(kind)) return false;
    const std::string_view rest = std::string_view(word).substr(kind.size());
    return rest.empty() || rest == "Z" || rest == "M" || rest == "ZM";
  });
}

std::optional<WktColumn> wkt_column(std::string_view bytes) {
  if (!may_be_table(bytes)) return std::nullopt;
  for (const char separator : kSeparators) {
    const std::vector<std::size_t> geometries = counts(bytes, separator, is_geometry);
    const auto most = std::ranges::max_element(geometries);
    if (most == geometries.end() || *most == 0) continue;
    const auto column = static_cast<std::size_t>(most - geometries.begin());
    WktColumn result{only(column, bytes, separator), column + 1, std::nullopt};
    for (std::size_t c = geometries.size(); c-- > 0;)
      if (c != column && geometries[c] > 0) result.passed_by = c + 1;
    return result;
  }
  return std::nullopt;
}

bool is_hex_wkb(std::string_view text) {
  if (text.starts_with("\\x")) text.remove_prefix(2);
  if (text.size() < 18 || text.size() % 2 != 0 || !std::ranges::all_of(text, is_hex)) return false;
  // The byte order, then the kind, 1 to 7, in four bytes; flags for Z, M and SRID in the highest, or 1000s added.
  const auto is_kind = [](char c) { return c >= '1' && c <= '7'; };
  if (text.starts_with("01")) return text[2] == '0' && is_kind(text[3]) && text.substr(4, 4) == "0000";
  return text.starts_with("00") && text.substr(4, 5) == "00000" && is_kind(text[9]);
}

bool has_hex_wkb_column(std::string_view bytes) {
  return may_be_table(bytes) && std::ranges::any_of(kSeparators, [&](char separator) {
           return std::ranges::any_of(counts(bytes, separator, is_hex_wkb), [](std::size_t n) { return n > 0; });
         });
}

}  // namespace taut::detail
