#include <taut/io/results/json.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace taut {

namespace {

constexpr std::size_t kWidest = 100;

bool is_member(const Json& item) {
  return item.items() != nullptr && item.items()->size() == 2 && item.items()->front().text() != nullptr;
}

template <typename Scalar>
std::string dumped(const Scalar& value) {
  return nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool is_leaf(const Json& json) { return !json.items() && !json.members() && !json.is_verbatim(); }

bool holds_object(const Json& json) {
  return json.members() != nullptr || (json.items() && std::ranges::any_of(*json.items(), holds_object));
}

}  // namespace

class JsonWriter {
 public:
  // A list with a line for each point would be unreadable, as would one with all of them on a line.
  static std::string indented(const Json& json, const std::string& indent) {
    if (const Json::Members* members = json.members()) {
      const bool is_flat = std::ranges::all_of(*members, [](const auto& member) { return is_leaf(member.second); });
      return is_flat && !indent.empty() && flat(json).size() <= kWidest ? flat(json) : block(*members, indent);
    }
    if (!json.items()) return flat(json);
    return holds_object(json) ? block(*json.items(), indent) : wrapped(*json.items(), indent);
  }

  static std::string flat(const Json& json) {
    const auto visit = [](const auto& value) { return flat_value(value); };
    return std::visit(visit, json.value_);
  }

 private:
  static std::string flat_value(std::monostate) { return "null"; }
  static std::string flat_value(const Json::Array& items) {
    std::string out = "[";
    for (const Json& item : items) out.append(out.size() > 1 ? ", " : "").append(flat(item));
    return out + "]";
  }
  static std::string flat_value(const Json::Members& members) {
    std::string out = "{";
    for (const auto& [key, value] : members)
      out.append(out.size() > 1 ? ", " : "").append(dumped(key)).append(": ").append(flat(value));
    return out + "}";
  }
  static std::string flat_value(const Json::Verbatim& value) { return value.text; }
  template <typename Scalar>
  static std::string flat_value(const Scalar& value) {
    return dumped(value);
  }

  static std::string wrapped(const Json::Array& items, const std::string& indent) {
    std::string all = flat_value(items);
    if (all.size() <= kWidest) return all;
    std::string out = "[";
    std::size_t width = kWidest;
    for (const Json& item : items) {
      const std::string text = flat(item);
      const bool breaks = width + text.size() > kWidest;
      out.append(out.size() == 1 ? "" : ",").append(breaks ? "\n" + indent + "  " : " ").append(text);
      width = (breaks ? 0 : width) + text.size() + 2;
    }
    return out.append("\n").append(indent).append("]");
  }

  static std::string block(const Json::Array& items, const std::string& indent) {
    std::string out = "[";
    for (const Json& item : items)
      out.append(out.size() > 1 ? ",\n" : "\n")
          .append(indent)
          .append("  ")
          .append(short_or_indented(item, indent + "  "));
    return out.append("\n").append(indent).append("]");
  }

  static std::string block(const Json::Members& members, const std::string& indent) {
    if (members.empty()) return "{}";
    std::string out = "{";
    for (const auto& [key, value] : members) {
      out.append(out.size() > 1 ? ",\n" : "\n").append(indent).append("  ").append(dumped(key)).append(": ");
      out.append(indented(value, indent + "  "));
    }
    return out.append("\n").append(indent).append("}");
  }

  // A row of a table on a line of its own.
  static std::string short_or_indented(const Json& item, const std::string& indent) {
    std::string line = flat(item);
    return line.size() <= kWidest ? line : indented(item, indent);
  }
};

Json::Json(std::initializer_list<Json> items) {
  if (items.size() == 0 || !std::ranges::all_of(items, is_member)) {
    value_ = Array(items);
    return;
  }
  Members members;
  for (const Json& item : items) members.emplace_back(*item.items()->front().text(), item.items()->back());
  value_ = std::move(members);
}

std::size_t Json::size() const { return items() ? items()->size() : members() ? members()->size() : 0; }

Json& Json::operator[](std::string_view key) {
  if (is_null()) value_ = Members{};
  auto& members = std::get<Members>(value_);
  for (auto& [name, value] : members)
    if (name == key) return value;
  return members.emplace_back(std::string(key), Json()).second;
}

void Json::push_back(Json item) {
  if (is_null()) value_ = Array{};
  std::get<Array>(value_).push_back(std::move(item));
}

std::string json_text(const Json& json) { return JsonWriter::indented(json, "") + "\n"; }

std::string json_line(const Json& json) { return JsonWriter::flat(json); }

}  // namespace taut
