#include <taut/io/worlds/read_chase_map.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/cost_store.h>
#include <taut/io/worlds/detail/decimal.h>

namespace taut::pursuit {

namespace {

using detail::Decimal;

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\v' || c == '\f'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string_view without_marks(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  while (bytes.ends_with('\x1a') || bytes.ends_with('\0')) bytes.remove_suffix(1);
  return bytes;
}

/// The tokens of a text. Knows where it is.
class Tokens {
 public:
  Tokens(std::string_view bytes, const std::string& source)
      : begin_(bytes.data()), at_(begin_), end_(begin_ + bytes.size()), source_(source) {
    skip();
  }

  bool at_end() const { return at_ == end_; }
  bool at_letter() const { return at_ != end_ && is_letter(*at_); }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  /// A section's letter.
  char letter() {
    const char c = upper(*at_);
    if (at_ + 1 != end_ && !is_space(at_[1]) && at_[1] != ',')
      fail("'" + word() + "' is no section; they are N, C, R, T and M");
    ++at_;
    skip();
    return c;
  }

  int whole(const char* what, int most) {
    const char* before = at_;
    Decimal value;
    const bool negative = at_ != end_ && *at_ == '-';
    if (negative || !detail::scan(at_, end_, value) || value.cut || value.places > 0 || !ends_here()) {
      at_ = before;
      fail(std::string(what) + " expected, not '" + word() + "'");
    }
    for (; value.places < 0 && value.mantissa <= static_cast<std::uint64_t>(most); ++value.places) value.mantissa *= 10;
    if (value.mantissa > static_cast<std::uint64_t>(most)) {
      at_ = before;
      fail(std::string(what) + " " + word() + " is beyond " + std::to_string(most));
    }
    separate();
    return static_cast<int>(value.mantissa);
  }

  std::optional<Decimal> number() {
    const char* before = at_;
    Decimal value;
    if (detail::scan(at_, end_, value) && ends_here()) {
      separate();
      return value;
    }
    at_ = before;
    return std::nullopt;
  }

  Decimal number(const char* what) {
    const std::optional<Decimal> value = number();
    if (!value) {
      if (at_ != end_ && *at_ == '-') fail(std::string(what) + " " + word() + " is negative");
      fail(std::string(what) + " expected, " + (at_end() ? "not the end of the file" : "not '" + word() + "'"));
    }
    return *value;
  }

  /// One to four digits and a fraction of zeros, if any: the usual cost. Absent, and nothing read, when it is something
  /// else.
  std::optional<std::uint32_t> small() {
    const char* p = at_;
    std::uint32_t value = 0;
    const auto digit = [&] { return static_cast<unsigned char>(*p - '0'); };
    if (end_ - p > 5) {  // mostly, a comma and the next cost follow
      for (int digits = 0; digits < 4 && digit() < 10; ++digits, ++p) value = 10 * value + digit();
      if (p != at_ && *p == ',' && static_cast<unsigned char>(p[1] - '0') < 10) {
        at_ = p + 1;
        return value;
      }
      p = at_;
      value = 0;
    }
    for (int digits = 0; p != end_ && *p >= '0' && *p <= '9'; ++p) {
      if (++digits > 4) return std::nullopt;
      value = 10 * value + static_cast<std::uint32_t>(*p - '0');
    }
    if (p == at_) return std::nullopt;
    if (p != end_ && *p == '.')
      for (++p; p != end_ && *p == '0';) ++p;
    if (p == end_ || (*p != ',' && !is_space(*p))) return std::nullopt;
    at_ = p;
    separate();
    return value;
  }

  std::string word() const {
    const char* p = at_;
    while (p != end_ && !is_space(*p) && *p != ',' && p - at_ < 24) ++p;
    std::string text(at_, p);
    if (text.empty() && at_ != end_) text = *at_;
    for (char& c : text)
      if (c < ' ' || c > '~') c = '?';
    return text;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(source_, 1 + static_cast<int>(std::count(begin_, at_, '\n')), message);
  }

 private:
  bool ends_here() const { return at_ == end_ || is_space(*at_) || *at_ == ','; }

  void skip() {
    while (at_ != end_ && is_space(*at_)) ++at_;
  }
  // Blanks, one comma, blanks.
  void separate() {
    if (at_ != end_ && *at_ == ',') {
      ++at_;
      if (at_ != end_ && !is_space(*at_)) return;  // mostly
      return skip();
    }
    skip();
    if (at_ == end_ || *at_ != ',') return;
    ++at_;
    skip();
  }

  const char* begin_;
  const char* at_;
  const char* end_;
  const std::string& source_;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& source) : tokens_(without_marks(bytes), source) {
    parts_.source = source;
  }

  ChaseMap read() {
    if (tokens_.at_end()) throw InputError(parts_.source, 0, "file is empty");
    while (!tokens_.at_end()) section();
    if (!has('M')) tokens_.fail(std::string("section ") + missing() + " is missing");
    return ChaseMap(std::move(parts_));
  }

 private:
  bool has(char letter) const { return seen_.find(letter) != std::string::npos; }

  char missing() const {
    for (const char c : {'N', 'C', 'R', 'T'})
      if (!has(c)) return c;
    return 'M';
  }

  void section() {
    if (!tokens_.at_letter())
      tokens_.fail(seen_.empty() ? "a cost map begins with N, not '" + tokens_.word() + "'"
                                 : "'" + tokens_.word() + "' after the end of section " + seen_.back());
    const std::string named = tokens_.word();
    if (named.size() > 1 || std::string("NCRTM").find(upper(named[0])) == std::string::npos)
      tokens_.fail("'" + named + "' is no section; they are N, C, R, T and M");
    const char letter = upper(named[0]);
    if (has(letter)) tokens_.fail(std::string("a second section ") + letter);
    if (has('M')) tokens_.fail(std::string("section ") + letter + " after section M, which comes last");
    if (letter != 'N' && !has('N')) tokens_.fail(std::string("section ") + letter + " before section N");
    if (letter == 'M' && missing() != 'M')
      tokens_.fail(std::string("section M, but section ") + missing() + " has not been read");
    tokens_.letter();
    seen_ += letter;
    read_section(letter);
  }

  void read_section(char letter) {
    switch (letter) {
      case 'N': return read_size();
      case 'C':
        threshold_text_ = tokens_.word();
        threshold_ = tokens_.number("the collision threshold");
        return;
      case 'R': parts_.start = position("the robot's"); return;
      case 'T': return read_target();
      default: return read_costs();
    }
  }

  void read_size() {
    parts_.x_size = tokens_.whole("the map's x_size", ChaseMap::kLongestSide);
    parts_.y_size = tokens_.whole("the map's y_size", ChaseMap::kLongestSide);
    if (parts_.x_size < 1 || parts_.y_size < 1) tokens_.fail("the map has no cells");
  }

  Cell position(const char* whose) {
    const auto coordinate = [&](const char* axis, int size) {
      const Tokens before = tokens_;
      const int value = tokens_.whole((std::string(whose) + " " + axis).c_str(), 1'000'000'000);
      if (value < 1 || value > size)
        before.fail(std::string(whose) + " " + axis + " " + std::to_string(value) + " is not on the map, 1 to " +
                    std::to_string(size));
      return value;
    };
    const int x = coordinate("x", parts_.x_size);
    return {x, coordinate("y", parts_.y_size)};
  }

  void read_target() {
    while (!tokens_.at_end() && !tokens_.at_letter()) {
      if (parts_.target.size() == 1'000'000) tokens_.fail("the trajectory has more than 1000000 entries");
      parts_.target.push_back(position("the target's"));
    }
    if (parts_.target.empty()) tokens_.fail("the trajectory has no entries");
  }

  void read_costs() {
    const std::size_t columns = static_cast<std::size_t>(parts_.y_size),
                      count = columns * static_cast<std::size_t>(parts_.x_size);
    // Before memory is taken for them: a cost and what separates it are two bytes.
    if (tokens_.bytes_left() + 1 < 2 * count) too_few(count);
    const std::size_t border = 2 * (columns + static_cast<std::size_t>(parts_.x_size)) + 4;  // ChaseMap adds it
    detail::CostStore costs(threshold_, ChaseMap::largest_cost(parts_.target.size()), count + border);
    while (costs.size() < count) {
      if (const auto whole = tokens_.small()) {
        costs.add(*whole);
        continue;
      }
      if (tokens_.at_end() || tokens_.at_letter()) too_few(count, costs.size());
      const std::optional<Decimal> cost = tokens_.number();
      costs.add(cost ? *cost : tokens_.number(cost_name(costs.size()).c_str()));
    }
    if (!tokens_.at_end())
      tokens_.fail("more than " + count_text(count) + " costs: '" + tokens_.word() + "' is left over");
    parts_.decimals = costs.decimals();
    parts_.rounded = costs.rounded();
    parts_.costs = costs.take();
    parts_.threshold = threshold_text_;
  }

  std::string cost_name(std::size_t i) const {
    const std::size_t columns = static_cast<std::size_t>(parts_.y_size);
    return "the cost of cell " + taut::text(Cell{static_cast<int>(i / columns) + 1, static_cast<int>(i % columns) + 1});
  }

  std::string count_text(std::size_t count) const {
    return std::to_string(parts_.x_size) + " x " + std::to_string(parts_.y_size) + " = " + std::to_string(count);
  }

  [[noreturn]] void too_few(std::size_t count, std::size_t read = 0) const {
    tokens_.fail("section M ends too soon: " + count_text(count) + " costs expected" +
                 (read ? ", " + std::to_string(read) + " found" : ""));
  }

  Tokens tokens_;
  ChaseMap::Parts parts_;
  std::string seen_;
  Decimal threshold_;
  std::string threshold_text_;
};

}  // namespace

ChaseMap read_chase_map(std::string_view bytes, const std::string& source) { return Reader(bytes, source).read(); }

}  // namespace taut::pursuit
