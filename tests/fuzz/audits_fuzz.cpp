// Audits of anybody's plans: paths of several robots, and fleets with times. What is valid is one, is not shorter than the
// shortest path, and robots collide two by two as they do all together.
#include <array>
#include <set>

#include <taut/geometry/free_space.h>
#include <taut/io/worlds/read_fleet.h>
#include <taut/io/worlds/read_path.h>
#include <taut/io/worlds/read_world.h>
#include <taut/robots/fleet/fleet.h>
#include <taut/search/path_audit.h>
#include <taut/search/verify.h>

#include "fuzz/fuzzed.h"

namespace {

using namespace taut;

constexpr const char* kRoom =
    "boundary 0 0 8 8\n4 0 4 5\n2 2 2 8\n5 6 8 6\nsolid 5 1 7 1 7 3 5 3\nstart 1 4\ngoal 7 5\n";

const std::array<PathAuditor, 3>& auditors() {
  static const World world = read_world(kRoom);
  static const std::array<PathAuditor, 3> all{PathAuditor(world, Footprint::point()),
                                              PathAuditor(world, Footprint::disc(0.25)),
                                              PathAuditor(world, Footprint::square(0.25))};
  return all;
}

void audit(const std::vector<Point>& points, const PathAuditor& auditor, bool is_point) {
  const PathAudit said = auditor.audit(points);
  fuzz::require(said.valid == auditor.check(points).valid, "check and audit differ");
  fuzz::require(said.valid == said.reason.empty(), "a reason for what is valid, or none for what is not");
  if (said.contact) fuzz::require(said.contact->leg <= points.size(), "a leg that there is none of");
  if (!said.valid) return;
  fuzz::require(said.clearance >= 0, "a clearance below 0");
  const auto shortest = auditor.shortest(points.front(), points.back());
  fuzz::require(shortest.has_value(), "a valid path where there is none");
  fuzz::require(said.length.interval().hi >= shortest->enclosure.lo, "shorter than the shortest");
  if (!is_point) return;
  const Verdict verdict =
      verify(Path{points, Length(points)}, auditor.space(), points.front(), Goal{points.back(), {}});
  fuzz::require(verdict.valid, "verify refuses what the audit takes: " + verdict.reason);
}

void audit_paths(const std::string& text, std::size_t robot) {
  for (const ClaimedPath& path : read_paths(text, "plans", Breaks::blank_lines))
    if (!path.points.empty() && path.points.size() < 50) audit(path.points, auditors()[robot], robot == 0);
}

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

void audit_fleet(const std::string& text, fleet::Ends ends) {
  const std::vector<fleet::Robot> robots = read_fleet(text, 0.5, "fleet");
  Pairs together, alone;
  for (const fleet::Collision& c : fleet::collisions(robots, ends)) together.insert({c.first, c.second});
  if (robots.size() > 8) return;
  for (std::size_t i = 0; i < robots.size(); ++i)
    for (std::size_t j = i + 1; j < robots.size(); ++j)
      if (const std::array two{robots[i], robots[j]}; !fleet::collisions(two, ends).empty()) alone.insert({i, j});
  fuzz::require(together == alone, "robots collide otherwise two by two:\n" + text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::size_t what = data[0] % 5U;
  fuzz::read([&] {
    if (what < 3)
      audit_paths(text, what);
    else
      audit_fleet(text, what == 3 ? fleet::Ends::stay : fleet::Ends::vanish);
  });
  return 0;
}
