#include <taut/cli/world/check_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/cli/messages.h>
#include <taut/cli/world/geographic.h>
#include <taut/geometry/predicates.h>

namespace taut::cli {

namespace {

constexpr std::size_t kOpeningsNamed = 4;

const char* name_of(Boundary boundary) {
  return boundary == Boundary::walled ? "walled" : boundary == Boundary::limit ? "limit" : "open";
}

Json json_of(const Box& b) { return {b.min.x, b.min.y, b.max.x, b.max.y}; }

Json json_of(const Goal& goal) {
  if (goal.point) return {{"point", *goal.point}};
  if (goal.room.empty()) return nullptr;
  Json boxes = Json::array();
  for (const Box& box : goal.room) boxes.push_back(json_of(box));
  return {{"room", boxes}};
}

std::string text_of(const Goal& goal) {
  if (goal.point) return point_text(*goal.point);
  if (goal.room.empty()) return "not given";
  const Box& first = goal.room.front();
  const std::string box = point_text(first.min) + " to " + point_text(first.max);
  return goal.room.size() == 1 ? "the room " + box
                               : fmt::format("a room of {} boxes, the first {}", goal.room.size(), box);
}

std::string line_text(int line) { return line > 0 ? fmt::format(" (line {})", line) : ""; }

std::string text_of(const NearContact& c) {
  return fmt::format("{}{} is {:.3g} from {}-{}{}", point_text(c.end), line_text(c.line), c.distance,
                     point_text(c.wall.a), point_text(c.wall.b), line_text(c.wall_line));
}

}  // namespace

CheckReport::CheckReport(const Input& input, const FreeSpace& space)
    : input_(input), space_(space), lattice_(number_lattice(input.world)) {
  for (const Polygon& polygon : space.polygons()) {
    area_ += ring_area(polygon.outer) / 2;
    for (const Ring& hole : polygon.holes) area_ += ring_area(hole) / 2;
    holes_ += polygon.holes.size();
  }
  for (const Triangulation::Sector& sector : space.triangulation().sectors) {
    corners_ += !sector.full;
    reflex_corners_ += sector.reflex;
  }
}

void CheckReport::add_path(const ClaimedPath& path, const Verdict& verdict) { paths_.emplace_back(path, verdict); }

const CheckReport::Judged* CheckReport::invalid() const {
  const auto found = std::ranges::find_if(paths_, [](const Judged& path) { return !path.second.valid; });
  return found == paths_.end() ? nullptr : &*found;
}

namespace {

double value_of(const ClaimedPath& path) {
  return path.arcs ? path.arcs->value() : path.measured ? *path.measured : Length(path.points).value();
}

std::string length_of(const ClaimedPath& path) {
  return path.arcs || path.measured ? fmt::format("{:.6f}", value_of(path)) : length_text(Length(path.points));
}

}  // namespace

std::string CheckReport::text(const Judged& judged) {
  const auto& [path, verdict] = judged;
  if (!verdict.valid) return "not valid: " + verdict.reason;
  std::string out =
      fmt::format("valid, length {}, {}, clearance {}", length_of(path), count_text(path.points.size(), "point"),
                  std::isfinite(verdict.clearance) ? number_text(verdict.clearance) : "unlimited");
  if (path.tolerance > 0) out += fmt::format(", legs within {} of the path", number_text(path.tolerance));
  return out;
}

std::string CheckReport::text() const {
  const World& world = input_.world;
  const Shown shown(input_.notes);
  const Box box = shown(world.box());
  std::string out;
  const auto row = [&](const char* what, const std::string& text) { out += fmt::format("  {:<12}{}\n", what, text); };
  out += fmt::format("{}: valid, {}\n", input_.name, name(input_.notes.format));
  std::string walls = fmt::format("{}", world.walls().size());
  if (world.dropped_walls() > 0) walls += fmt::format(", {} of no length dropped", world.dropped_walls());
  if (input_.notes.unknown_walls > 0) walls += fmt::format(", {} unknown read as open", input_.notes.unknown_walls);
  row("walls", walls);
  if (!world.solids().empty()) row("obstacles", count_text(world.solids().size(), "polygon"));
  row("boundary", fmt::format("{}, {} to {}", name_of(world.boundary()), point_text(box.min), point_text(box.max)));
  row("numbers", lattice_ ? taut::text(*lattice_) : "computed, or too many digits for a lattice");
  const SnapReport& snap = input_.notes.snap;
  if (snap.joined > 0)
    row("joined", fmt::format("{}, moved by at most {:.3g}; nothing by more than {:.3g}",
                              count_text(snap.joined, "contact"), snap.displacement, snap.tolerance));
  for (const NearContact& c : input_.notes.near) row("near", text_of(c));
  if (world.boundary() == Boundary::limit)
    row("openings", world.openings().empty() ? "none"
                                             : fmt::format("{}: {}", world.openings().size(),
                                                           segments_text(shown(world.openings()), kOpeningsNamed)));
  row("start", world.start() ? point_text(shown(*world.start())) : "not given");
  row("goal", text_of(shown(world.goal())));
  row("free space", fmt::format("area {:.10g}, {}, {}, {}", area_, count_text(space_.component_count(), "component"),
                                count_text(space_.polygons().size(), "outer ring"), count_text(holes_, "hole")));
  row("corners", fmt::format("{}, {} reflex", corners_, reflex_corners_));
  for (const Judged& path : paths_) row("path", text(path));
  return out;
}

Json CheckReport::json(const Judged& judged) {
  const auto& [path, verdict] = judged;
  const bool finite = std::isfinite(verdict.clearance);
  Json json{{"valid", verdict.valid},
            {"reason", verdict.reason},
            {"leg", verdict.valid ? Json() : Json(verdict.leg)},
            {"length", value_of(path)},
            {"points", path.points.size()},
            {"clearance", verdict.valid && finite ? Json(verdict.clearance) : Json()}};
  if (path.tolerance > 0) json["tolerance"] = path.tolerance;
  return json;
}

Json CheckReport::json() const {
  const World& world = input_.world;
  const Shown shown(input_.notes);
  Json json{{"format", name(input_.notes.format)}};
  json["walls"] = world.walls().size();
  json["dropped_walls"] = world.dropped_walls();
  json["unknown_walls"] = input_.notes.unknown_walls;
  json["solids"] = world.solids().size();
  json["areas"] = world.areas().size();
  json["boundary"] = name_of(world.boundary());
  json["box"] = json_of(shown(world.box()));
  json["numbers"] = lattice_ ? Json(taut::text(*lattice_)) : Json(nullptr);
  json["openings"] = shown(world.openings());
  json["start"] = world.start() ? Json(shown(*world.start())) : Json();
  json["goal"] = json_of(shown(world.goal()));
  json["free_space"] = {{"area", area_},
                        {"components", space_.component_count()},
                        {"polygons", space_.polygons().size()},
                        {"holes", holes_},
                        {"corners", corners_},
                        {"reflex_corners", reflex_corners_},
                        {"triangles", space_.triangulation().triangles.size()},
                        {"displacement", space_.report().displacement}};
  if (shown) json["projection"] = shown.json();
  json["path"] = nullptr;
  if (!paths_.empty()) json["path"] = this->json(valid() ? paths_.front() : *invalid());
  if (paths_.size() > 1) {
    json["paths"] = Json::array();
    for (const Judged& path : paths_) json["paths"].push_back(this->json(path));
  }
  return json;
}

}  // namespace taut::cli
