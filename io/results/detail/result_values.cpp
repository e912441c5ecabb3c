#include <taut/io/results/detail/result_values.h>

namespace taut::detail {

namespace {

using Json = nlohmann::ordered_json;

// Of values without objects.
std::string flat(const Json& json) {
  if (!json.is_array()) return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out = "[";
  for (const Json& item : json) {
    if (out.size() > 1) out += ", ";
    out += flat(item);
  }
  return out.append("]");
}

// A list with a line for each point would be unreadable, as would one with all of them on a line.
std::string wrapped(const Json& array, const std::string& indent) {
  constexpr std::size_t kWidest = 100;
  std::string all = flat(array);
  if (all.size() <= kWidest) return all;
  std::string out = "[";
  std::size_t width = kWidest;
  for (const Json& item : array) {
    const std::string text = flat(item);
    const bool first = &item == &array.front(), breaks = width + text.size() > kWidest;
    out.append(first ? "" : ",").append(breaks ? "\n" + indent + "  " : " ").append(text);
    width = (breaks ? 0 : width) + text.size() + 2;
  }
  return out.append("\n").append(indent).append("]");
}

std::string indented(const Json& json, const std::string& indent) {
  if (json.is_array()) return wrapped(json, indent);
  if (!json.is_object()) return flat(json);
  std::string out = "{";
  for (const auto& [key, value] : json.items())
    out.append(out.size() > 1 ? ",\n" : "\n")
        .append(indent)
        .append("  \"")
        .append(key)
        .append("\": ")
        .append(indented(value, indent + "  "));
  return out.append("\n").append(indent).append("}");
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& json) { return indented(json, "") + "\n"; }

}  // namespace taut::detail
