#include <taut/io/worlds/detail/json_tree.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut::detail {

namespace {

constexpr std::size_t kDeepest = 64;

// Feeds the parser and counts the lines it has taken.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, int* line) : at_(at), line_(line) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (*at_ == '\n') ++*line_;
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  int* line_;
};

// What of nlohmann's message tells something: `syntax error while parsing value - ...`.
std::string readable(const std::string& what) {
  const std::size_t at = what.find("syntax error");
  std::string message = what.substr(at != std::string::npos ? at : what.find(']') + 2);
  for (char& c : message)
    if (c < ' ' || c > '~') c = '?';
  return message.substr(0, 160);
}

class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(const std::string& source, std::string_view bytes, const int& line, int first_line)
      : source_(source), bytes_(bytes), line_(line), first_line_(first_line) {}

  JsonTree take() { return std::move(root_); }

  bool null() override { return add(JsonTree::Kind::null), true; }
  bool boolean(bool value) override { return add(JsonTree::Kind::boolean).number = value, true; }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool string(string_t& value) override { return add(JsonTree::Kind::string).string = std::move(value), true; }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonTree::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonTree::Kind::array); }
  bool end_object() override { return open_.pop_back(), true; }
  bool end_array() override { return open_.pop_back(), true; }
  bool key(string_t& value) override {
    key_ = std::move(value);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    const auto end =
        bytes_.begin() + static_cast<std::ptrdiff_t>(std::min(position > 0 ? position - 1 : 0, bytes_.size()));
    const int line = first_line_ + static_cast<int>(std::count(bytes_.begin(), end, '\n'));
    throw InputError(source_, line, "not valid JSON: " + readable(error.what()));
  }

 private:
  bool number(double value) {
    add(JsonTree::Kind::number).number = value;
    return true;
  }

  bool open(JsonTree::Kind kind) {
    if (open_.size() == kDeepest)
      SourceLine{source_, line_}.fail("JSON is nested more than " + std::to_string(kDeepest) + " deep");
    open_.push_back(&add(kind));
    return true;
  }

  // Only the innermost open value grows, so pointers to the open ones stay good.
  JsonTree& add(JsonTree::Kind kind) {
    JsonTree value;
    value.kind = kind;
    value.line = line_;
    if (open_.empty()) return root_ = std::move(value);
    JsonTree& parent = *open_.back();
    if (parent.kind == JsonTree::Kind::object) parent.keys.push_back(std::move(key_));
    return parent.items.emplace_back(std::move(value));
  }

  const std::string& source_;
  std::string_view bytes_;
  const int& line_;
  int first_line_;
  JsonTree root_;
  std::vector<JsonTree*> open_;
  std::string key_;
};

}  // namespace

const JsonTree* JsonTree::find(std::string_view key) const {
  const auto at = std::find(keys.rbegin(), keys.rend(), key);
  return at == keys.rend() ? nullptr : &items[static_cast<std::size_t>(keys.rend() - at - 1)];
}

namespace {

// A text that begins in some line of the file.
JsonTree parse_from_line(std::string_view text, const std::string& source, int first_line) {
  int line = first_line;
  Builder builder(source, text, line, first_line);
  const CountingIterator first(text.data(), &line), last(text.data() + text.size(), &line);
  nlohmann::json::sax_parse(first, last, &builder);
  return builder.take();
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n\x1e") == std::string_view::npos; }

// A text a line: the first line is a whole text, and another one begins below it.
bool is_text_a_line(std::string_view bytes) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos || is_blank(bytes.substr(end))) return false;
  return nlohmann::json::accept(bytes.substr(0, end)) &&
         bytes.substr(bytes.find_first_not_of(" \t\r\n", end))[0] == '{';
}

}  // namespace

JsonTree parse_json(std::string_view bytes, const std::string& source) {
  return parse_from_line(stripped(bytes), source, 1);
}

std::vector<JsonTree> parse_json_texts(std::string_view bytes, const std::string& source) {
  const std::string_view content = stripped(bytes);
  const char separator = content.find('\x1e') != std::string_view::npos ? '\x1e' : '\n';
  std::vector<JsonTree> texts;
  if (separator == '\n' && !is_text_a_line(content)) {
    texts.push_back(parse_json(bytes, source));
    return texts;
  }
  int line = 1;
  for (std::size_t from = 0; from < content.size();) {
    const std::size_t end = std::min(content.find(separator, from), content.size());
    const std::string_view text = content.substr(from, end - from);
    if (!is_blank(text)) texts.push_back(parse_from_line(text, source, line));
    line += static_cast<int>(std::count(text.begin(), text.end(), '\n')) + (separator == '\n' ? 1 : 0);
    from = end + 1;
  }
  return texts;
}

}  // namespace taut::detail
