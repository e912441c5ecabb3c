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
  Builder(const std::string& source, std::string_view bytes, const int& line)
      : source_(source), bytes_(bytes), line_(line) {}

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
    const int line = 1 + static_cast<int>(std::count(bytes_.begin(), end, '\n'));
    throw InputError(source_, line, "not valid JSON: " + readable(error.what()));
  }

 private:
  bool number(double value) {
    add(JsonTree::Kind::number).number = value;
    return true;
  }

  bool open(JsonTree::Kind kind) {
    if (open_.size() == kDeepest)
      Place{source_, line_}.fail("JSON is nested more than " + std::to_string(kDeepest) + " deep");
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
  JsonTree root_;
  std::vector<JsonTree*> open_;
  std::string key_;
};

}  // namespace

const JsonTree* JsonTree::find(std::string_view key) const {
  const auto at = std::find(keys.rbegin(), keys.rend(), key);
  return at == keys.rend() ? nullptr : &items[static_cast<std::size_t>(keys.rend() - at - 1)];
}

JsonTree parse_json(std::string_view bytes, const std::string& source) {
  const std::string_view content = stripped(bytes);
  int line = 1;
  Builder builder(source, content, line);
  const CountingIterator first(content.data(), &line), last(content.data() + content.size(), &line);
  nlohmann::json::sax_parse(first, last, &builder);
  return builder.take();
}

}  // namespace taut::detail
