// A JSON array of millions of items.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

#include <taut/io/results/json.h>

namespace taut::detail {

/// Written as it grows, an item a line: a tree of millions of edges would take gigabytes.
class LongList {
 public:
  /// An item, as fmt::format has it. Precondition: it is JSON.
  template <typename... Values>
  void add(fmt::format_string<const Values&...> format, const Values&... values) {
    text_ += text_.empty() ? "[\n      " : ",\n      ";
    fmt::format_to(std::back_inserter(text_), format, values...);
  }

  Json json() { return Json::verbatim(text_.empty() ? "[]" : std::move(text_) + "\n    ]"); }

 private:
  std::string text_;
};

}  // namespace taut::detail
