#include <taut/io/detail/result_values.h>

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
  return out + "]";
}

// A list with a line for each point would be unreadable, as would one with all of them on a line.
std::string wrapped(const Json& array, const std::string& indent) {
  std::string out = "[", line;
  for (const Json& item : array) {
    const std::string text = flat(item);
    if (line.size() + text.size() > 100) {
      out += "\n" + indent + "  " + line;
      line.clear();
    }
    line += text + (&item == &array.back() ? "" : ", ");
  }
  const bool single = out.size() == 1;
  return single ? out + line + "]" : out + "\n" + indent + "  " + line + "\n" + indent + "]";
}

std::string indented(const Json& json, const std::string& indent) {
  if (json.is_array()) return wrapped(json, indent);
  if (!json.is_object()) return flat(json);
  std::string out = "{";
  for (const auto& [key, value] : json.items())
    out += (out.size() > 1 ? ",\n" : "\n") + indent + "  \"" + key + "\": " + indented(value, indent + "  ");
  return out + "\n" + indent + "}";
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& json) { return indented(json, "") + "\n"; }

}  // namespace taut::detail
