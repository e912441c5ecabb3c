// JSON with line numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace taut::detail {

/// A JSON value and the line it begins in (of a number: the line it ends in, or the next).
struct JsonTree {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  int line = 0;
  double number = 0;  ///< also 0 and 1 of a boolean
  std::string string;
  std::vector<JsonTree> items;    ///< of an array or, in order, of an object
  std::vector<std::string> keys;  ///< of an object, one an item

  /// The last member of that name, nullptr when there is none or this is no object.
  const JsonTree* find(std::string_view key) const;
};

/// Parses with nlohmann-json's SAX interface. Throws InputError with the line on anything that is not JSON, on values
/// nested deeper than 64, and on numbers beyond the range of double.
JsonTree parse_json(std::string_view bytes, const std::string& source);

}  // namespace taut::detail
