#include <string_view>
#include <utility>

#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/implied.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/write_world.h>

namespace taut {

namespace {

class Writer {
 public:
  explicit Writer(const SegmentsStyle& style) : shift_(style.shift) {
    for (detail::Lines lines(style.comment); lines.next();) out_.append("# ").append(lines.line()).append("\n");
  }

  std::string take() { return std::move(out_); }

  void wall(const Wall& wall) {
    point(wall.a);
    out_ += ' ';
    point(wall.b);
    if (wall.thickness > 0) {
      out_ += ' ';
      append(out_, wall.thickness);
    }
    out_ += '\n';
  }

  void directive(std::string_view word, const Ring& points) {
    out_ += word;
    for (Point p : points) {
      out_ += ' ';
      point(p);
    }
    out_ += '\n';
  }

 private:
  void point(Point p) {
    append(out_, p.x + shift_.x);
    out_ += ' ';
    append(out_, p.y + shift_.y);
  }

  std::string out_;
  Point shift_;
};

void check(const World& world) {
  const auto fail = [](const char* what) { throw InputError("", 0, std::string("segments cannot hold ") + what); };
  if (!world.solids().empty()) fail("solid polygons; use geojson");
  if (world.boundary() == Boundary::walled) fail("floor plans; use geojson");
  if (world.areas().size() > 1 || !world.areas().front().polygon.holes.empty())
    fail("a boundary of several rings; use geojson");
  if (world.goal().point && !world.goal().room.empty()) fail("both a goal point and a goal room");
}

}  // namespace

std::string write_segments(const World& world, const SegmentsStyle& style) {
  check(world);
  Writer writer(style);
  if (!detail::area_is_implied(world)) {
    if (world.boundary() == Boundary::open)
      throw InputError("", 0, "segments cannot hold a world without boundary that is nothing but ends");
    writer.directive("boundary", world.areas().front().polygon.outer);
  }
  if (!detail::ends_are_implied(world)) {
    if (world.start()) writer.directive("start", {*world.start()});
    if (world.goal().point) writer.directive("goal", {*world.goal().point});
    Ring room;
    for (const Box& box : world.goal().room) room.insert(room.end(), {box.min, box.max});
    if (!room.empty()) writer.directive("goal", room);
  }
  for (const Wall& wall : world.walls()) writer.wall(wall);
  return writer.take();
}

}  // namespace taut
