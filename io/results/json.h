// Values on their way to JSON.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <taut/geometry/point.h>

namespace taut {

/// A JSON value: null, a truth, a number, a string, an array, or an object that keeps the order of its members. A plain
/// value: copies are deep. Braces make arrays, and objects where every item is a pair that begins with a string:
///
///     Json json{{"status", "found"}, {"points", Json::array()}};
///     json["points"].push_back({p.x, p.y});
class Json {
 public:
  using Array = std::vector<Json>;
  using Members = std::vector<std::pair<std::string, Json>>;

  Json() = default;
  Json(std::nullptr_t) {}
  Json(bool value) : value_(value) {}
  template <std::signed_integral Number>
  Json(Number value) : value_(std::int64_t{value}) {}
  template <std::unsigned_integral Number>
  requires(!std::same_as<Number, bool>) Json(Number value) : value_(std::uint64_t{value}) {}
  Json(double value) : value_(value) {}  ///< not finite: null
  Json(const char* text) : value_(std::string(text)) {}
  Json(std::string_view text) : value_(std::string(text)) {}
  Json(std::string text) : value_(std::move(text)) {}
  Json(std::initializer_list<Json> items);
  Json(Point p) : value_(Array{Json(p.x), Json(p.y)}) {}
  Json(const Segment& s) : value_(Array{Json(s.a), Json(s.b)}) {}
  template <typename Value>
  Json(const std::optional<Value>& value) {
    if (value) *this = Json(*value);
  }
  template <typename Value>
  Json(const std::vector<Value>& values) : value_(Array(values.begin(), values.end())) {}

  static Json array() { return Json(Array{}); }
  static Json array(std::initializer_list<Json> items) { return Json(Array(items)); }
  static Json object() { return Json(Members{}); }

  /// A value that is written already: for millions of numbers, of which a tree would take gigabytes. Precondition: it
  /// is JSON; line ends in it stay.
  static Json verbatim(std::string json) { return Json(Verbatim{std::move(json)}); }

  bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
  const bool* truth() const { return std::get_if<bool>(&value_); }
  const std::string* text() const { return std::get_if<std::string>(&value_); }
  const Array* items() const { return std::get_if<Array>(&value_); }
  const Members* members() const { return std::get_if<Members>(&value_); }
  bool is_verbatim() const { return std::holds_alternative<Verbatim>(value_); }
  bool empty() const { return size() == 0; }  ///< of what is neither array nor object: true
  std::size_t size() const;

  /// The member of that name, added as null where there is none; null becomes an object. Precondition: one of the two.
  Json& operator[](std::string_view key);
  /// Null becomes an array. Precondition: one of the two.
  void push_back(Json item);

 private:
  friend class JsonWriter;

  struct Verbatim {
    std::string text;
  };

  explicit Json(Verbatim text) : value_(std::move(text)) {}
  explicit Json(Array items) : value_(std::move(items)) {}
  explicit Json(Members members) : value_(std::move(members)) {}

  std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, Array, Members, Verbatim> value_;
};

/// Indented by two; arrays without objects on one line, or wrapped at 100 columns, those with objects an item a line;
/// objects of scalars on one line where they fit in 100 columns. Numbers read back as the same double; bytes that are
/// no UTF-8 become U+FFFD. Ends in a newline.
std::string json_text(const Json& json);

/// All on one line, without a newline.
std::string json_line(const Json& json);

}  // namespace taut
