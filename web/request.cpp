#include <taut/web/detail/request.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>

#include <taut/geometry/errors.h>

namespace taut::web {

namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

[[noreturn]] void refuse(const char* key, const char* what) {
  throw InputError("", 0, fmt::format("the request's `{}` is no {}", key, what));
}

}  // namespace

struct Request::Impl {
  nlohmann::json json;

  const nlohmann::json* find(const char* key) const {
    const auto found = json.find(key);
    return found == json.end() || found->is_null() ? nullptr : &*found;
  }
};

Request::Request(std::string_view json) : impl_(std::make_unique<Impl>()) {
  impl_->json = nlohmann::json::parse(json, nullptr, false);
  if (!impl_->json.is_object()) throw InputError("", 0, "the request is no JSON object");
}

Request::~Request() = default;

std::optional<std::string> Request::text(const char* key) const {
  const auto* value = impl_->find(key);
  if (value == nullptr) return std::nullopt;
  if (!value->is_string()) refuse(key, "text");
  return value->get<std::string>();
}

std::optional<double> Request::number(const char* key) const {
  const auto* value = impl_->find(key);
  if (value == nullptr) return std::nullopt;
  if (!value->is_number()) refuse(key, "number");
  return value->get<double>();
}

std::optional<int> Request::count(const char* key, int most) const {
  const std::optional<double> value = number(key);
  if (!value) return std::nullopt;
  const int whole = *value >= 0 && *value <= most ? static_cast<int>(*value) : -1;
  if (whole != *value) throw InputError("", 0, fmt::format("the request's `{}` is no number from 0 to {}", key, most));
  return whole;
}

std::optional<Point> Request::point(const char* key) const {
  const auto values = numbers(key);
  if (!values) return std::nullopt;
  if (values->size() != 2) refuse(key, "point [x, y]");
  return Point{(*values)[0], (*values)[1]};
}

std::optional<std::vector<double>> Request::numbers(const char* key) const {
  const auto* value = impl_->find(key);
  if (value == nullptr) return std::nullopt;
  if (!value->is_array()) refuse(key, "list of numbers");
  std::vector<double> numbers;
  numbers.reserve(value->size());
  for (const auto& item : *value) {
    if (!item.is_number()) refuse(key, "list of numbers");
    numbers.push_back(item.get<double>());
  }
  return numbers;
}

std::string from_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) refuse("base64", "base64");
    bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xffffff;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<char>(bits >> held & 0xff));
  }
  return bytes;
}

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text.push_back(i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63]);
  }
  return text;
}

Flat& Flat::operator<<(double value) {
  fmt::format_to(std::back_inserter(text_), "{}{}", text_.empty() ? '[' : ',', value);
  return *this;
}

Json flat(std::span<const Point> points) {
  Flat out;
  for (const Point p : points) out << p;
  return out.json();
}

Json flat(std::span<const Segment> segments) {
  Flat out;
  for (const Segment& s : segments) out << s;
  return out.json();
}

}  // namespace taut::web
