#include <string_view>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/io/worlds/write_world.h>

namespace taut {

namespace {

class Writer {
 public:
  std::string take() {
    out_ += features_ == 0 ? "]}\n" : "\n]}\n";
    return std::move(out_);
  }

  // `more`: further properties, each with a comma in front.
  void polygon(const Polygon& polygon, std::string_view role, std::string_view more = {}) {
    begin(role, more, "Polygon");
    rings(polygon);
    end();
  }

  void point(Point p, std::string_view role) {
    begin(role, {}, "Point");
    position(p);
    end();
  }

  // Walls first .. last - 1 have one thickness.
  void walls(const std::vector<Wall>& walls, std::size_t first, std::size_t last) {
    const double t = walls[first].thickness;
    begin("wall", t > 0 ? ", \"thickness\": " + text(t) : "", "MultiLineString");
    for (std::size_t i = first; i < last; ++i) {
      out_ += i == first ? "[[" : ", [";
      position(walls[i].a);
      out_ += ", ";
      position(walls[i].b);
      out_ += ']';
    }
    out_ += ']';
    end();
  }

  void room(const std::vector<Box>& boxes) {
    begin("goal", {}, "MultiPolygon");
    for (const Box& b : boxes) {
      out_ += &b == &boxes.front() ? "[" : ", ";
      rings({{b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}}, {}});
    }
    out_ += ']';
    end();
  }

 private:
  void begin(std::string_view role, std::string_view more, std::string_view type) {
    out_ += features_++ == 0 ? "\n" : ",\n";
    out_.append("{\"type\": \"Feature\", \"properties\": {\"role\": \"").append(role).append("\"").append(more);
    out_.append("}, \"geometry\": {\"type\": \"").append(type).append("\", \"coordinates\": ");
  }

  void end() { out_ += "}}"; }

  void position(Point p) {
    out_ += '[';
    append(out_, p.x);
    out_ += ", ";
    append(out_, p.y);
    out_ += ']';
  }

  void ring(const Ring& ring) {
    out_ += '[';
    for (Point p : ring) {
      position(p);
      out_ += ", ";
    }
    position(ring.front());
    out_ += ']';
  }

  void rings(const Polygon& polygon) {
    out_ += '[';
    ring(polygon.outer);
    for (const Ring& hole : polygon.holes) {
      out_ += ", ";
      ring(hole);
    }
    out_ += ']';
  }

  std::string out_ = "{\"type\": \"FeatureCollection\", \"features\": [";
  std::size_t features_ = 0;
};

}  // namespace

std::string write_geojson(const World& world) {
  if (world.goal().point && !world.goal().room.empty())
    throw InputError("", 0, "geojson cannot hold both a goal point and a goal room");
  Writer writer;
  if (world.boundary() != Boundary::open) {
    const std::string_view kind =
        world.boundary() == Boundary::limit ? ", \"boundary\": \"limit\"" : ", \"boundary\": \"walled\"";
    for (const Area& area : world.areas()) writer.polygon(area.polygon, "free", kind);
  }
  for (const Area& solid : world.solids()) writer.polygon(solid.polygon, "obstacle");
  const std::vector<Wall>& walls = world.walls();
  for (std::size_t first = 0, last = 0; first < walls.size(); first = last) {
    while (last < walls.size() && walls[last].thickness == walls[first].thickness) ++last;
    writer.walls(walls, first, last);
  }
  if (world.start()) writer.point(*world.start(), "start");
  if (world.goal().point) writer.point(*world.goal().point, "goal");
  if (!world.goal().room.empty()) writer.room(world.goal().room);
  return writer.take();
}

}  // namespace taut
