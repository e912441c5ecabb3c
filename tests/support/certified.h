// Certificates of small worlds, and what is true of them whatever they say.
#pragma once

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
inline std::optional<std::string> certificate_of(const FreeSpace& space, Point from, Point to) {
  const VisibilityGraph graph(space);
  const auto path = shortest_path(space, from, to);
  const auto certificate = path ? shortest_certificate(graph, *path) : none_certificate(graph, from, to);
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
  std::vector<Point> points;
  for (const auto& p : json["path"]) points.push_back({p[0].get<double>() / scale, p[1].get<double>() / scale});
  const Point from = points.front(), to = points.back();
  if (!is_place(space, from) || !is_place(space, to)) return said.kind == "none" ? "" : "an end is no place";
  const auto shortest = shortest_path(space, from, to);
  if (said.kind == "none") return shortest ? "there is a path" : "";
  const Verdict verdict = verify(Path{points, Length(points)}, space, from, Goal{to, {}});
  if (!verdict.valid) return "its path is none: " + verdict.reason;
  return said.bound <= shortest->length.interval().hi ? "" : "a path is shorter";
}

}  // namespace taut::test
