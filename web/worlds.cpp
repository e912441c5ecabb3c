// Worlds that come and go.
#include <algorithm>
#include <array>
#include <utility>

#include <taut/io/worlds/write_world.h>
#include <taut/web/detail/answers.h>

namespace taut::web {

namespace {

constexpr std::array kWritten{Format::geojson,  Format::segments, Format::wkt,    Format::drawing,
                              Format::maz,      Format::num,      Format::blocks, Format::cell_values,
                              Format::movingai, Format::integers};

Format format_of(const std::string& word) {
  if (const auto format = format_named(word)) return *format;
  throw InputError("", 0, "there is no format '" + word + "'");
}

ReadOptions options_of(const Request& request) {
  ReadOptions options;
  options.source = request.text("name").value_or("");
  if (const auto word = request.text("format")) options.format = format_of(*word);
  const std::string polygons = request.text("polygons").value_or("free");
  if (polygons == "obstacles") options.polygons = ReadOptions::Polygons::obstacles;
  if (polygons == "nested") options.polygons = ReadOptions::Polygons::nested;
  if (request.text("crossings") == "even-odd") options.crossings = Crossings::even_odd;
  options.unknown_is_free = request.text("unknown") == "free";
  options.wall_thickness = request.number("wall_thickness");
  options.resolution = request.number("resolution");
  if (const auto size = request.number("cell_size"); size && *size > 0) options.cell_size = *size;
  return options;
}

Json flat(const Ring& ring) { return web::flat(std::span<const Point>(ring)); }

Json rings(const std::vector<Area>& areas) {
  Json list = Json::array();
  for (const Area& area : areas) {
    Json polygon = Json::array();
    polygon.push_back(flat(area.polygon.outer));
    for (const Ring& hole : area.polygon.holes) polygon.push_back(flat(hole));
    list.push_back(std::move(polygon));
  }
  return list;
}

Json flat(const std::vector<Wall>& walls) {
  Flat out;
  for (const Wall& wall : walls) out << wall.a << wall.b << wall.thickness;
  return out.json();
}

Json flat(const Box& box) { return Json(std::vector<double>{box.min.x, box.min.y, box.max.x, box.max.y}); }

Json room_of(const Goal& goal) {
  Json room = Json::array();
  for (const Box& box : goal.room) room.push_back(flat(box));
  return room;
}

World with_ends_of(const Ground& ground, const Request& request) {
  return ground.world().with_ends(request.point("start"), request.point("goal"));
}

bool is_text(Format format) { return format != Format::maz; }

}  // namespace

World loaded_world(const Request& request, ReadNotes& notes) {
  if (const auto bytes = request.text("bytes")) return read_world(*bytes, options_of(request), &notes);
  return read_world(from_base64(request.text("base64").value_or("")), options_of(request), &notes);
}

World edited_world(const World& world, const Request& request) {
  const auto numbers = request.numbers("walls");
  if (!numbers || numbers->size() % 5 != 0) throw InputError("", 0, "walls are five numbers each");
  WorldParts parts = world.parts();
  parts.grid = nullptr;
  parts.walls.clear();
  for (auto n = numbers->begin(); n != numbers->end(); n += 5)
    parts.walls.push_back({{n[0], n[1]}, {n[2], n[3]}, n[4]});
  return World(std::move(parts));
}

Json world_answer(const Ground& ground) {
  const World& world = ground.world();
  const ReadNotes& notes = ground.notes();
  static constexpr const char* kBoundaries[]{"walled", "limit", "open"};
  const Ends ends = ends_to_begin_with(ground);
  return {{"name", world.source()},
          {"format", name(notes.format)},
          {"boundary", kBoundaries[static_cast<int>(world.boundary())]},
          {"walls", flat(world.walls())},
          {"solids", rings(world.solids())},
          {"areas", rings(world.areas())},
          {"openings", web::flat(std::span<const Segment>(world.openings()))},
          {"box", flat(world.box())},
          {"y_down", world.y_down()},
          {"start", world.start()},
          {"goal", world.goal().point},
          {"room", room_of(world.goal())},
          {"ends", {{"start", ends.start}, {"goal", ends.goal.point}}},
          {"remarks", notes.remarks}};
}

Json save_answer(const Ground& ground, const Request& request) {
  const Format format = format_of(request.text("as").value_or("geojson"));
  const std::string bytes = write_world(with_ends_of(ground, request), format);
  if (is_text(format)) return {{"text", bytes}};
  return {{"base64", to_base64(bytes)}};
}

Json formats_answer(const Ground& ground) {
  Json words = Json::array();
  for (const Format format : kWritten) try {
      write_world(ground.world(), format);
      words.push_back(name(format));
    } catch (const InputError&) {  // what it cannot hold is not offered
    }
  return {{"formats", std::move(words)}};
}

}  // namespace taut::web
