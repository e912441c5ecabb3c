// Lines, fields and numbers of text formats.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace taut::detail {

/// Where something was read, for messages.
struct SourceLine {
  const std::string& source;
  int line = 0;

  [[noreturn]] void fail(const std::string& message) const;
};

/// In single quotes, control and non-ASCII characters as `?`, long text shortened.
std::string quoted(std::string_view text);

/// A file name, control characters as `?`.
std::string printable_name(std::string name);

/// `; 2 more like it`; nothing for 0.
std::string more_like_it(std::size_t count);

/// Without byte order mark and DOS end-of-file mark.
std::string_view stripped(std::string_view bytes);

/// Without blanks at its end, or at both.
std::string_view trimmed_right(std::string_view line);
std::string_view trimmed(std::string_view line);

/// What a line says before a `#`, without blanks around it.
std::string_view without_comment(std::string_view line);

/// Walks over lines, numbered from 1, CR and blanks at their ends cut off.
class Lines {
 public:
  explicit Lines(std::string_view bytes) : rest_(stripped(bytes)) {}

  bool next();
  std::string_view line() const { return line_; }
  int number() const { return number_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  int number_ = 0;
};

/// Walks over the fields of a line, separated by blanks, by a comma, or by both.
class Fields {
 public:
  Fields(std::string_view line, const SourceLine& place);

  /// False at the end. Fails on empty fields between commas.
  bool next(std::string_view& field);

 private:
  std::string_view rest_;
  const SourceLine& place_;
  bool after_comma_ = false;
};

/// All fields of a line.
std::vector<std::string_view> fields_of(std::string_view line, const SourceLine& place);

/// A coordinate: decimal, finite, of magnitude <= World::kLargest; -0 is read as 0.
double coordinate(std::string_view field, const SourceLine& place);

/// A whole number in lo .. hi; `what` names it in the message.
int whole(std::string_view field, int lo, int hi, const char* what, const SourceLine& place);

}  // namespace taut::detail
