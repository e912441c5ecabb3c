#include <taut/io/worlds/read_drive.h>

#include <cmath>

#include <taut/geometry/errors.h>
#include <taut/geometry/world.h>
#include <taut/io/worlds/detail/json_tree.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::JsonTree;
using Kind = JsonTree::Kind;

class DriveReader {
 public:
  explicit DriveReader(const std::string& source) : source_(source) {}

  ClaimedDrive read(const JsonTree& file) const {
    const JsonTree* const result = file.find("result");
    const JsonTree& json = result ? *result : file;
    const JsonTree& legs = member(json, "legs");
    if (legs.kind != Kind::array) fail(legs, "the legs are not a list");
    ClaimedDrive drive;
    for (const JsonTree& leg : legs.items) drive.legs.push_back(leg_of(leg));
    if (const JsonTree* length = json.find("length"); length && length->kind == Kind::number)
      drive.length = length->number;
    if (const JsonTree* shape = json.find("car"); shape && shape->kind == Kind::object) drive.car = shape_of(*shape);
    return drive;
  }

 private:
  [[noreturn]] void fail(const JsonTree& at, const std::string& message) const {
    detail::SourceLine{source_, at.line}.fail(message);
  }

  const JsonTree& member(const JsonTree& json, const char* name) const {
    const JsonTree* const found = json.find(name);
    if (!found) fail(json, std::string("there is no \"") + name + "\"");
    return *found;
  }

  double number(const JsonTree& json) const {
    if (json.kind != Kind::number || !(std::abs(json.number) <= World::kLargest)) fail(json, "a number is expected");
    return json.number;
  }

  bool truth(const JsonTree& json) const {
    if (json.kind != Kind::boolean) fail(json, "true or false is expected");
    return json.number != 0;
  }

  car::LatticePose pose(const JsonTree& place, const JsonTree& heading) const {
    if (place.kind != Kind::array || place.items.size() < 2) fail(place, "a place is not written as [x, y]");
    const double h = number(heading);
    if (h != std::floor(h) || h < 0 || h >= car::kHeadings) fail(heading, "a heading is not one of 0 to 63");
    return {{number(place.items[0]), number(place.items[1])}, static_cast<int>(h)};
  }

  car::Leg leg_of(const JsonTree& json) const {
    const JsonTree& headings = member(json, "headings");
    if (headings.kind != Kind::array || headings.items.size() != 2) fail(headings, "a leg has two headings");
    const JsonTree* const backward = json.find("backward");
    return {pose(member(json, "from"), headings.items[0]), pose(member(json, "to"), headings.items[1]),
            backward && truth(*backward)};
  }

  car::CarShape shape_of(const JsonTree& json) const {
    car::CarShape shape;
    shape.front = number(member(json, "front"));
    shape.back = number(member(json, "back"));
    shape.half_width = number(member(json, "half_width"));
    shape.radius = number(member(json, "radius"));
    shape.reverse = truth(member(json, "reverse"));
    if (shape.front < 0 || shape.back < 0 || shape.front + shape.back <= 0 || shape.half_width <= 0 ||
        shape.radius <= 0)
      fail(json, "there is no such car");
    return shape;
  }

  const std::string& source_;
};

}  // namespace

bool holds_drive(std::string_view bytes) {
  const std::string_view text = detail::trimmed(detail::stripped(bytes));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{' && text.find("\"legs\"") != std::string_view::npos &&
         text.find("\"headings\"") != std::string_view::npos;
}

ClaimedDrive read_drive(std::string_view bytes, const std::string& source) {
  return DriveReader(source).read(detail::parse_json(bytes, source));
}

}  // namespace taut
