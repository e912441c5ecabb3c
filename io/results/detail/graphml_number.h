// Numbers in the GraphML that Boost.Graph writes.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include <taut/geometry/text.h>

namespace taut::detail {

/// Boost.Graph prints doubles with six digits. These it takes for strings.
struct GraphmlNumber {
  double value;
  friend std::ostream& operator<<(std::ostream& out, GraphmlNumber n) { return out << text(n.value); }
};

/// Declares what it took for strings as doubles.
inline std::string with_doubles(std::string text) {
  constexpr std::string_view kString = "attr.type=\"string\"", kDouble = "attr.type=\"double\"";
  for (std::size_t at = 0; (at = text.find(kString, at)) != std::string::npos;)
    text.replace(at, kString.size(), kDouble);
  return text;
}

}  // namespace taut::detail
