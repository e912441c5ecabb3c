// Certificates of small worlds, and what is true of them whatever they say.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/search/path_certificate.h>
#include <taut/search/polyanya.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>
#include <taut/verify/judge.h>

namespace taut::test {

inline bool is_place(const FreeSpace& space, Point p) { return space.locate(p).kind != Location::Kind::outside; }

/// Of the answer to a query, found or none; nothing where rounding leaves none. Precondition: both are places.
inline std::optional<std::string> certificate_of(const FreeSpace& space, Point from, const Goal& to) {
  const VisibilityGraph graph(space);
  const auto path = shortest_path(space, from, to);
  const auto certificate = path ? shortest_certificate(graph, *path, to) : none_certificate(graph, from, to);
  if (!certificate) return std::nullopt;
  return certificate_text(*certificate, write_integers(space.world()));
}

/// The same claim about another world.
inline std::string about(const World& world, nlohmann::json certificate) {
  PathCertificate empty;
  empty.path = {{0, 0}};
  certificate["world"] = nlohmann::json::parse(certificate_text(empty, write_integers(world)))["world"];
  return certificate.dump();
}

/// What is wrong with the judge's approval; empty where it does not approve, or rightly. In a world of integers.
inline std::string wrong_approval(const FreeSpace& space, const std::string& certificate) {
  proof::Judgement said;
  try {
    said = proof::judge(write_integers(space.world()), certificate);
  } catch (const proof::BadInput&) {
    return {};
  }
  if (!said.proven) return {};
  const auto json = nlohmann::json::parse(certificate);
  const double scale = json["scale"].get<double>();
  const auto point = [&](const nlohmann::json& p) {
    return Point{p[0].get<double>() / scale, p[1].get<double>() / scale};
  };
  std::vector<Point> points;
  for (const auto& p : json["path"]) points.push_back(point(p));
  const Point from = points.front(), p = point(json["goal"].front()), q = point(json["goal"].back());
  const Box room{{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}};
  if (!is_place(space, from)) return said.kind == "none" ? "" : "the start is no place";
  if (p == q && !is_place(space, p)) return said.kind == "none" ? "" : "the goal is no place";
  const Goal to = p == q ? Goal{p, {}} : Goal{std::nullopt, {room}};
  // Where a crossing was rounded the planner may see a wall beside the room's corner that it passes through.
  if (!to.point && space.report().displacement > 0) return {};
  const auto shortest = shortest_path(space, from, to);
  if (said.kind == "none") return shortest ? "there is a path" : "";
  // At a crossing of sloped walls with a room's border a path may end in a place that is no pair of doubles.
  const bool is_exact = std::has_single_bit(json["scale"].get<std::uint64_t>());
  const Verdict verdict = verify(Path{points, Length(points)}, space, from, to);
  // Who gets into the room beside what stands in it need not see its middle from there.
  const bool enters = verdict.reason.find("on the rim of the goal room") != std::string::npos;
  if (is_exact && !verdict.valid && !enters) return "its path is none: " + verdict.reason;
  if (!to.point && !shortest) return {};  // likewise
  // The bound that is told is rounded.
  const bool is_bound = shortest && said.bound <= shortest->length.interval().hi * (1 + 0x1p-52L);
  return is_bound ? "" : "a path is shorter than " + std::to_string(said.bound);
}

}  // namespace taut::test
