// Certificates of discs' arcs: what is approved, and that nothing false is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/segment_distance.h>
#include <taut/io/results/arc_proof.h>
#include <taut/io/results/path_certificate_text.h>
#include <taut/search/arc_search.h>
#include <taut/search/disc_worlds.h>
#include <taut/search/path_audit.h>
#include <taut/verify/judge.h>

#include "support/random_world.h"

namespace taut {
namespace {

using nlohmann::json;
using test::any;
using testing::HasSubstr;

struct Query {
  World world;
  std::array<Point, 2> ends;
  double radius;

  ArcTexts texts() const { return arc_texts(world, radius, ends); }
  ArcSearchResult answer() const { return arc_search(TangentGraph(FreeSpace(world), radius), ends[0], ends[1]); }
};

std::optional<std::string> certificate_of(const Query& query) {
  const ArcSearchResult found = query.answer();
  if (found.status != DiscStatus::found) return std::nullopt;
  const auto certificate =
      ArcProver(disc_ground(query.world, query.ends[0], query.ends[1]), query.radius).certificate(found.path);
  if (!certificate) return std::nullopt;
  return certificate_text(*certificate, query.texts());
}

/// What cannot be read is not proven either.
ArcJudgement judged(const World& world, const std::string& certificate) {
  try {
    const ArcClaim claim = arc_claim(certificate).value();
    const auto judge = [](const std::string& text, const std::string& part) {
      const proof::Judgement said = proof::judge(text, part);
      return ArcJudgement{said.proven, said.words, double(said.length), double(said.bound), 0};
    };
    return judge_arcs(claim, arc_texts(world, claim.radius, claim.ends), judge);
  } catch (const proof::BadInput& error) {
    return {false, error.what(), 0, 0, 0};
  } catch (const InputError& error) {
    return {false, error.what(), 0, 0, 0};
  }
}

Query around_a_wall() {
  return {test::SmallWorld{{{{5, 0}, {5, 4}}}}.bounded(Boundary::limit), {Point{2, 1}, Point{8, 1}}, 1};
}

TEST(ArcCertificate, BoundsTheArcsFromBothSides) {
  const Query query = around_a_wall();
  const double length = query.answer().path.value();
  const ArcJudgement said = judged(query.world, *certificate_of(query));
  ASSERT_TRUE(said.proven) << said.words;
  EXPECT_LE(said.bound, length);
  EXPECT_GE(said.length, length);
  EXPECT_LT(said.length - said.bound, 2e-4 * length);
  EXPECT_EQ(said.keeps, 1);
  EXPECT_THAT(said.words, HasSubstr("no path of a disc of radius 1 is shorter than 10.2"));
  EXPECT_THAT(said.words, HasSubstr("one that keeps 1 is 10.2"));
}

TEST(ArcCertificate, IsOfADiscThatSticksOutOfALimit) {
  const Query query{test::SmallWorld{{{{5, 0}, {5, 8.5}}}}.bounded(Boundary::limit), {Point{2, 2}, Point{8, 2}}, 1};
  const ArcJudgement said = judged(query.world, *certificate_of(query));
  EXPECT_TRUE(said.proven) << said.words;
}

TEST(ArcCertificate, IsOfADiscThatTouchesBothSidesOfADoor) {
  const test::SmallWorld door{{{{5, 0}, {5, 4}}, {{5, 6}, {5, 10}}}};
  const Query query{door.bounded(Boundary::walled), {Point{2, 1}, Point{8, 2}}, 1};
  const ArcJudgement said = judged(query.world, *certificate_of(query));
  ASSERT_TRUE(said.proven) << said.words;
  EXPECT_NEAR(said.keeps, 1, 1e-6);
  EXPECT_LE(said.keeps, 1);
}

TEST(ArcCertificate, IsRefusedWhenItIsTamperedWith) {
  const Query query = around_a_wall();
  const json whole = json::parse(*certificate_of(query));
  const auto words = [&](const json& claim) { return judged(query.world, claim.dump()).words; };
  json smaller = whole, bent = whole, other = whole, raised = whole, nearer = whole, cut = whole;
  smaller["radius"] = 0.75;
  EXPECT_THAT(words(smaller), HasSubstr("of another world"));
  bent["bound"]["path"][5][1] = 0;
  EXPECT_THAT(words(bent), HasSubstr("the path"));
  other["keeps"]["path"].erase(5);
  EXPECT_THAT(words(other), testing::AnyOf(HasSubstr("too near"), HasSubstr("different paths")));
  raised["bound"]["reach"] = raised["bound"]["reach"].get<std::int64_t>() + (std::int64_t{1} << 40);
  EXPECT_THAT(words(raised), testing::AnyOf(HasSubstr("nothing stops the leg"), HasSubstr("out of range")));
  nearer["keeps"]["keeps"] = nearer["keeps"]["keeps"].get<std::int64_t>() / 2;
  EXPECT_THAT(words(nearer), HasSubstr("keeps only 0.5"));
  cut["keeps"].erase("chain");
  EXPECT_THAT(words(cut), HasSubstr("cannot be read"));
  cut.erase("keeps");
  EXPECT_THAT(words(cut), HasSubstr("two parts"));
}

TEST(ArcCertificate, IsRefusedWhenItsPartsAreAboutDifferentPaths) {
  Query query = around_a_wall();
  json claim = json::parse(*certificate_of(query));
  query.ends[0] = {2, 2};
  claim["keeps"] = json::parse(*certificate_of(query))["keeps"];
  EXPECT_THAT(judged(query.world, claim.dump()).words, HasSubstr("different paths"));
}

Query any_query() {
  const test::RandomWorld kinds[] = {{.side = 5, .walls = 4, .solids = 1},
                                     {.side = 6, .walls = 6, .solids = 1, .straight = true},
                                     {.side = 6, .walls = 0, .solids = 3}};
  const test::RandomWorld& kind = kinds[any(0, 2)];
  const Boundary boundary = std::array{Boundary::walled, Boundary::limit}[std::size_t(any(0, 1))];
  const auto place = [&] { return Point{any(0, 4 * kind.side) / 4.0, any(0, 4 * kind.side) / 4.0}; };
  return {test::any_world(kind).bounded(boundary), {place(), place()}, any(1, 8) / 8.0};
}

/// The legs outside of an arc that touches a limit leave the world.
bool touches_a_limit(const Query& query) {
  const Box box = query.world.box();
  const ArcPath path = query.answer().path;
  const std::vector<Point> points = sampled(path, path.radius / 1000);
  return query.world.boundary() == Boundary::limit && std::any_of(points.begin(), points.end(), [&](Point p) {
           return std::min({p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y}) < path.radius / 1000;
         });
}

RC_GTEST_PROP(ArcCertificate, IsApprovedForEveryAnswer, ()) {
  const Query query = any_query();
  const auto certificate = certificate_of(query);
  RC_PRE(certificate.has_value() && !touches_a_limit(query));
  const double length = query.answer().path.value();
  const ArcJudgement said = judged(query.world, *certificate);
  RC_LOG() << said.words << '\n';
  RC_ASSERT(said.proven);
  RC_ASSERT(said.bound <= length * (1 + 1e-12) && length <= said.length * (1 + 1e-12));
  RC_ASSERT(said.length - said.bound <= 0.003 * length);
  RC_ASSERT(said.keeps >= query.radius * (1 - 1e-6));
}

// What the bound rests on.
RC_GTEST_PROP(InnerWorld, HasNoCornerThatIsAsFarFromAllPiecesAsTheRadius, ()) {
  const Query query = any_query();
  const auto inner = inner_world(query.world, query.radius);
  RC_ASSERT(inner.has_value());
  std::vector<Segment> pieces;
  for (const Wall& wall : query.world.walls()) pieces.push_back({wall.a, wall.b});
  const auto add = [&](const std::vector<Area>& areas) {
    for (const Area& area : areas)
      for (std::size_t i = 0; i < area.polygon.outer.size(); ++i)
        pieces.push_back({area.polygon.outer[i], area.polygon.outer[(i + 1) % area.polygon.outer.size()]});
  };
  add(query.world.solids());
  if (query.world.boundary() == Boundary::walled) add(query.world.areas());
  const std::size_t given = query.world.solids().size();
  for (std::size_t i = given; i < inner->solids().size(); ++i) {
    const Ring& hull = inner->solids()[i].polygon.outer;
    RC_ASSERT(std::any_of(pieces.begin(), pieces.end(), [&](const Segment& piece) {
      return std::all_of(hull.begin(), hull.end(), [&](Point p) {
        return segment_distance({p, p}, piece) < query.radius;
      });
    }));
  }
}

/// What is wrong with the judge's approval; empty where it does not approve, or rightly.
std::string wrong_approval(const World& world, const json& certificate) {
  const ArcJudgement said = judged(world, certificate.dump());
  if (!said.proven) return {};
  const ArcTexts texts = arc_texts(world, certificate["radius"], {});
  const auto under = texts.bare.find("unit 1/");
  const double unit = under == std::string::npos ? 1 : std::stod(texts.bare.substr(under + 7));
  const double per_one = unit * certificate["keeps"]["scale"].get<double>();
  std::vector<Point> path;
  for (const json& p : certificate["keeps"]["path"])
    path.push_back({p[0].get<double>() / per_one, p[1].get<double>() / per_one});
  const double radius = certificate["radius"];
  // The planner asks for all of the radius.
  const PathAudit audit = PathAuditor(world, Footprint::disc(std::min(radius, said.keeps) * (1 - 1e-9))).audit(path);
  if (!audit.valid) return "its path is none: " + audit.reason;
  const Query asked{world, {path.front(), path.back()}, radius};
  const ArcSearchResult found = asked.answer();
  return found.status == DiscStatus::found && said.bound > found.path.value() * (1 + 1e-9) ? "a path is shorter" : "";
}

json tampered(json claim) {
  const auto one_of = [](json& rows) -> json& { return rows[std::size_t(any(0, int(rows.size()) - 1))]; };
  const auto moved = [](json& v, std::int64_t by) { v = v.get<std::int64_t>() + by; };
  json &bound = claim["bound"], &keeps = claim["keeps"];
  const auto unit = bound["scale"].get<std::int64_t>() * 100'000;
  switch (any(0, 7)) {
    case 0: claim["radius"] = claim["radius"].get<double>() - any(1, 3) / 16.0; break;
    case 1: moved(bound["reach"], std::int64_t{any(1, 1000)} << bound["fraction_bits"].get<int>()); break;
    case 2:
      moved(one_of(bound["potentials"])[2], std::int64_t{any(-1000, 1000)} << bound["fraction_bits"].get<int>());
      break;
    case 3: bound["potentials"].erase(std::size_t(any(0, int(bound["potentials"].size()) - 1))); break;
    case 4: {
      const auto i = std::size_t(any(0, int(bound["path"].size()) - 1));
      const auto scale = bound["scale"].get<std::int64_t>(), finer = keeps["scale"].get<std::int64_t>() / scale;
      const auto by = any(-100, 100) * (finer < std::int64_t{1} << 30 ? unit : scale);  // in range of both
      moved(bound["path"][i][0], by), moved(keeps["path"][i][0], by * finer);
      break;
    }
    case 5: {
      const auto i = std::size_t(any(0, int(bound["path"].size()) - 1));
      bound["path"].erase(i), keeps["path"].erase(i);
      break;
    }
    case 6: moved(keeps["keeps"], any(1, 1000) * unit); break;
    default: keeps["chain"] = json::array({one_of(keeps["path"])}); break;
  }
  return claim;
}

World changed(const World& world) {
  WorldParts parts = world.parts();
  if (parts.walls.empty()) return world;
  const auto i = std::size_t(any(0, int(parts.walls.size()) - 1));
  if (any(0, 1) == 0)
    parts.walls.erase(parts.walls.begin() + std::ptrdiff_t(i));
  else
    parts.walls.push_back({test::any_lattice_point(5), test::any_lattice_point(5), 0, 0});
  return World(parts);
}

/// The same claim about another world, or another radius.
json about(const World& world, json claim) {
  const ArcTexts texts = arc_texts(world, claim["radius"], {});
  ArcCertificate empty;
  empty.radius = 1;
  empty.bound.path = {{0, 0}};
  const json other = json::parse(certificate_text(empty, texts));
  for (const char* part : {"bound", "keeps"}) claim[part]["world"] = other[part]["world"];
  return claim;
}

// RC_PARAMS=max_success=3000 makes some 20 000.
TEST(ArcCertificate, ThatWasTamperedWithIsNeverApprovedWrongly) {
  int cases = 0;
  const bool sound = rc::check("tampered certificates of arcs", [&] {
    const Query query = any_query();
    const auto certificate = certificate_of(query);
    if (!certificate) return;
    for (int i = 0; i < 2; ++i) {
      json other = tampered(json::parse(*certificate));
      if (other["radius"].get<double>() > 0) other = about(query.world, other);
      RC_ASSERT(wrong_approval(query.world, other) == "");
      const World moved = changed(query.world);
      RC_ASSERT(wrong_approval(moved, about(moved, json::parse(*certificate))) == "");
      cases += 2;
    }
  });
  EXPECT_TRUE(sound);
  EXPECT_GE(cases, 100);
}

}  // namespace
}  // namespace taut
