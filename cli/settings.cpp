#include <taut/cli/settings.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

constexpr const char* kBlanks = " \t\r";

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

bool is_comment(char c) { return c == '#' || c == ';'; }

/// Is it `grid.solve` or `max-seconds`?
bool is_name(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), fits) && text.front() != '.' && text.back() != '.';
}

class Lines {
 public:
  Lines(const std::string& text, std::string source) : text_(text), source_(std::move(source)) {}

  std::vector<Setting> all() {
    while (std::getline(text_, row_)) {
      ++line_;
      at_ = 0;
      skip_blanks();
      if (is_at_end()) continue;
      if (row_[at_] == '[')
        section_ = section();
      else
        add(setting());
    }
    return std::move(all_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw InputError(source_, line_, why); }

  void skip_blanks() { at_ = std::min(row_.find_first_not_of(kBlanks, at_), row_.size()); }
  /// Nothing left, but for a comment?
  bool is_at_end() const { return at_ == row_.size() || is_comment(row_[at_]); }

  void require_end(const std::string& after) {
    skip_blanks();
    if (!is_at_end()) refuse("'" + trimmed(row_.substr(at_)) + "' after " + after);
  }

  std::string section() {
    const std::size_t end = row_.find(']', at_);
    std::string name = trimmed(row_.substr(at_ + 1, end == std::string::npos ? end : end - at_ - 1));
    if (end == std::string::npos || !is_name(name)) refuse("'" + trimmed(row_) + "' is no section like [grid.solve]");
    at_ = end + 1;
    require_end("the section [" + name + "]");
    return name;
  }

  Setting setting() {
    const std::size_t equals = row_.find('=', at_);
    if (equals == std::string::npos) refuse("'" + trimmed(row_) + "' is neither `name = value` nor a [section]");
    Setting setting{section_, trimmed(row_.substr(at_, equals - at_)), {}, false, line_};
    if (setting.name.starts_with('-')) refuse("'" + setting.name + "': names stand here without dashes");
    if (!is_name(setting.name)) refuse("'" + setting.name + "' is not the name of an option");
    if (const std::size_t dot = setting.name.rfind('.'); dot != std::string::npos) {
      setting.section += (section_.empty() ? "" : ".") + setting.name.substr(0, dot);
      setting.name.erase(0, dot + 1);
    }
    at_ = equals + 1;
    take_value(setting);
    require_end("the value of " + setting.name);
    return setting;
  }

  void take_value(Setting& setting) {
    skip_blanks();
    if (is_at_end()) refuse(setting.name + " has no value");
    if (row_[at_] == '[') return take_list(setting);
    setting.is_word = row_[at_] != '"' && row_[at_] != '\'';
    setting.values.push_back(setting.is_word ? word("") : quoted());
  }

  void take_list(Setting& setting) {
    for (++at_, skip_blanks(); at_ < row_.size() && row_[at_] != ']'; skip_blanks()) {
      setting.values.push_back(row_[at_] == '"' || row_[at_] == '\'' ? quoted() : word(",]"));
      skip_blanks();
      if (at_ < row_.size() && row_[at_] == ',')
        ++at_;
      else if (at_ < row_.size() && row_[at_] != ']')
        refuse("the list of " + setting.name + " needs a comma before '" + trimmed(row_.substr(at_)) + "'");
    }
    if (at_ == row_.size()) refuse("the list of " + setting.name + " does not end on its line");
    ++at_;
  }

  /// Up to one of `ends`, or a comment, which follows a blank.
  std::string word(std::string_view ends) {
    const std::size_t begin = at_;
    while (at_ < row_.size() && ends.find(row_[at_]) == std::string_view::npos &&
           !(is_comment(row_[at_]) && std::string_view(kBlanks).find(row_[at_ - 1]) != std::string_view::npos))
      ++at_;
    return trimmed(row_.substr(begin, at_ - begin));
  }

  std::string quoted() {
    const char quote = row_[at_++];
    std::string text;
    for (; at_ < row_.size() && row_[at_] != quote; ++at_)
      text += quote == '"' && row_[at_] == '\\' ? escaped() : row_[at_];
    if (at_ == row_.size()) refuse("a text that begins with " + std::string(1, quote) + " does not end on its line");
    ++at_;
    return text;
  }

  /// What the two characters mean that begin here; stays at the second.
  char escaped() {
    static constexpr std::string_view kWritten = "\"\\nt", kMeant = "\"\\\n\t";
    const std::size_t which = at_ + 1 < row_.size() ? kWritten.find(row_[at_ + 1]) : std::string_view::npos;
    if (which == std::string_view::npos) refuse("'" + row_.substr(at_, 2) + "' means nothing in a text");
    ++at_;
    return kMeant[which];
  }

  void add(Setting setting) {
    const auto [first, is_new] = lines_.try_emplace({setting.section, setting.name}, line_);
    if (!is_new) refuse(setting.name + " is in line " + std::to_string(first->second) + " already");
    all_.push_back(std::move(setting));
  }

  std::istringstream text_;
  std::string source_, row_, section_;
  std::size_t at_ = 0;
  int line_ = 0;
  std::vector<Setting> all_;
  std::map<std::pair<std::string, std::string>, int> lines_;
};

}  // namespace

std::vector<Setting> settings_of(const std::string& text, const std::string& source) {
  static constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) return settings_of(text.substr(kByteOrderMark.size()), source);
  return Lines(text, source).all();
}

}  // namespace taut::cli
