#include <taut/robots/micromouse/detail/json_file.h>

#include <nlohmann/json.hpp>

#include <algorithm>

#include <taut/geometry/errors.h>

namespace taut::micromouse::detail {

namespace {

using Json = nlohmann::json;

int line_of(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return static_cast<int>(1 + std::count(text.begin(), end, '\n'));
}

}  // namespace

Json parse_json(std::string_view text, const std::string& source, const char* what, int deepest) {
  const auto refuse = [&](int line, const char* why) {
    throw InputError(source, line, std::string("is no ") + what + ": " + why);
  };
  const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > deepest) refuse(0, "nested too deep");
    return true;
  };
  try {
    return Json::parse(text.begin(), text.end(), shallow);
  } catch (const Json::parse_error& error) {
    refuse(line_of(text, error.byte), "this is not JSON");
  } catch (const Json::out_of_range&) {  // does not say where
    refuse(0, "a number in it is too large");
  }
  return {};
}

}  // namespace taut::micromouse::detail
