// Certificates of discs: what is approved, and that nothing false is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/roadmaps/voronoi.h>
#include <taut/search/clearance_search.h>
#include <taut/search/disc_certificate.h>
#include <taut/search/path_audit.h>
#include <taut/verify/judge.h>

#include "support/random_world.h"

namespace taut {
namespace {

using nlohmann::json;
using test::any;

struct Query {
  World world;
  Point start, goal;

  FreeSpace space() const { return FreeSpace(world); }
  std::string text() const { return write_integers(world); }
};

std::optional<std::string> widest_of(const Query& query) {
  const FreeSpace space = query.space();
  const Gates gates(space);
  const auto widest = widest_passage(gates, query.start, query.goal);
  if (!widest || !(widest->radius > 0)) return std::nullopt;
  const auto way = ClearanceSearch(VoronoiRoadmap(space), query.start, query.goal).widest();
  if (!way) return std::nullopt;
  const auto certificate = widest_certificate(gates, *widest, query.start, query.goal, way->curves);
  if (!certificate) return std::nullopt;
  return certificate_text(*certificate, query.text(), {query.start, query.goal});
}

std::optional<std::string> narrow_of(const Query& query, double radius) {
  const Gates gates(query.space());
  const DiscPassage passage = disc_passage(gates, query.start, query.goal, radius);
  if (passage.status != DiscStatus::none) return std::nullopt;
  const auto certificate = narrow_certificate(gates, passage, query.start, query.goal, radius);
  if (!certificate) return std::nullopt;
  return certificate_text(*certificate, query.text(), {query.start, query.goal});
}

Query slit() {
  return {test::SmallWorld{{{{2, 0}, {2, 1.8}}, {{2, 2.2}, {2, 4}}}, {}, test::box_ring(0, 0, 4, 4)}.bounded(
              Boundary::walled),
          {1, 1},
          {3, 3}};
}

TEST(DiscCertificate, ProvesTheWidestToADigit) {
  const auto certificate = widest_of(slit());
  ASSERT_TRUE(certificate);
  const proof::Judgement said = proof::judge(slit().text(), *certificate);
  EXPECT_TRUE(said.proven) << said.words;
  EXPECT_EQ(said.kind, "widest");
  EXPECT_DOUBLE_EQ(static_cast<double>(said.bound), 0.2);
  EXPECT_NEAR(static_cast<double>(said.length), 0.2, 1e-9);
  EXPECT_LE(said.length, 0.2L);
}

TEST(DiscCertificate, ProvesTheWidestBesideACorner) {  // where the way is a parabola
  const Query bend{
      test::SmallWorld{{{{2, 0}, {2, 3}}}, {}, test::box_ring(0, 0, 4, 4)}.bounded(Boundary::walled), {1, 1}, {3, 1}};
  const auto certificate = widest_of(bend);
  ASSERT_TRUE(certificate);
  const proof::Judgement said = proof::judge(bend.text(), *certificate);
  EXPECT_TRUE(said.proven) << said.words;
  EXPECT_DOUBLE_EQ(static_cast<double>(said.bound), 0.5);
  EXPECT_NEAR(static_cast<double>(said.length), 0.5, 1e-8);
}

TEST(DiscCertificate, ProvesThatADiscDoesNotGetThrough) {
  EXPECT_FALSE(narrow_of(slit(), 0.2)) << "which passes";
  const auto certificate = narrow_of(slit(), 0.2001);
  ASSERT_TRUE(certificate);
  const proof::Judgement said = proof::judge(slit().text(), *certificate);
  EXPECT_TRUE(said.proven) << said.words;
  EXPECT_EQ(said.words, "no disc of radius 0.2001 gets through");
}

TEST(DiscCertificate, IsRefusedWhenTheChainIsCutOrAGateIsWidened) {
  json certificate = json::parse(*widest_of(slit()));
  const auto words = [](const json& claim) { return proof::judge(slit().text(), claim.dump()).words; };
  json cut = certificate, wide = certificate, raised = certificate, elsewhere = certificate;
  cut["chain"].erase(cut["chain"].size() / 2);
  EXPECT_THAT(words(cut), testing::HasSubstr("the chain is open from"));
  wide["width"] = wide["width"].get<std::int64_t>() - 1;
  EXPECT_THAT(words(wide), testing::HasSubstr("the chain is open from (2, "));
  raised["keeps"] = raised["width"].get<std::int64_t>() / 2 + 1;
  EXPECT_THAT(words(raised), testing::HasSubstr("comes too near"));
  for (json& p : elsewhere["chain"]) p = elsewhere["chain"][0];
  EXPECT_THAT(words(elsewhere), testing::HasSubstr("separates nothing"));
  certificate["width"] = -certificate["width"].get<std::int64_t>();
  EXPECT_THROW(proof::judge(slit().text(), certificate.dump()), proof::BadInput);
}

Query any_query(int& side) {
  const test::RandomWorld kinds[] = {{.side = 5, .walls = 6, .solids = 1},
                                     {.side = 6, .walls = 12, .solids = 2, .straight = true},
                                     {.side = 6, .walls = 0, .solids = 6}};
  const test::RandomWorld& kind = kinds[any(0, 2)];
  side = kind.side;
  const auto place = [&] { return Point{any(0, 4 * side) / 4.0, any(0, 4 * side) / 4.0}; };
  return {test::any_world(kind).bounded(Boundary::walled), place(), place()};
}

bool has_places(const Query& query) {
  const FreeSpace space = query.space();
  return space.locate(query.start).kind != Location::Kind::outside &&
         space.locate(query.goal).kind != Location::Kind::outside;
}

RC_GTEST_PROP(DiscCertificate, IsApprovedForEveryAnswer, ()) {
  int side = 0;
  const Query query = any_query(side);
  RC_PRE(has_places(query));
  if (const auto certificate = widest_of(query)) {
    const proof::Judgement said = proof::judge(query.text(), *certificate);
    if (query.space().report().displacement == 0) RC_ASSERT(said.words == (said.proven ? said.words : ""));
    const auto widest = widest_passage(query.space(), query.start, query.goal);
    if (said.proven) RC_ASSERT(said.bound >= widest->radius && said.bound <= widest->radius * (1 + 1e-9));
    if (said.proven) RC_ASSERT(said.length >= widest->radius * (1 - 1e-6));
  }
  if (const auto certificate = narrow_of(query, any(1, 8) / 8.0))
    if (query.space().report().displacement == 0) RC_ASSERT(proof::judge(query.text(), *certificate).proven);
}

/// What is wrong with the judge's approval; empty where it does not approve, or rightly.
std::string wrong_approval(const Query& query, const json& claim) {
  proof::Judgement said;
  try {
    said = proof::judge(query.text(), claim.dump());
  } catch (const proof::BadInput&) {
    return {};
  }
  if (!said.proven) return {};
  const double scale = claim["scale"].get<double>(), bound = static_cast<double>(said.bound);
  std::vector<Point> path;
  for (const json& p : claim["path"]) path.push_back({p[0].get<double>() / scale, p[1].get<double>() / scale});
  const Query asked{query.world, path.front(), path.back()};
  if (!has_places(asked)) return said.kind == "none" ? "" : "an end is no place";
  if (said.kind == "none")
    return disc_passage(query.space(), asked.start, asked.goal, bound * (1 + 1e-12)).status == DiscStatus::found
               ? "it gets through"
               : "";
  const auto widest = widest_passage(query.space(), asked.start, asked.goal);
  if (!widest || widest->radius > bound * (1 + 1e-12)) return "a wider disc gets through";
  const double keeps = static_cast<double>(said.length) * (1 - 1e-9);
  if (keeps <= 0) return {};
  return PathAuditor(query.world, Footprint::disc(keeps)).audit(path).valid ? "" : "its path is none";
}

json tampered(json claim, int side) {
  const auto one_of = [](json& rows) -> json& { return rows[static_cast<std::size_t>(any(0, int(rows.size()) - 1))]; };
  const auto scale = claim["scale"].get<std::int64_t>();
  const auto moved = [&](json& p) { p[static_cast<std::size_t>(any(0, 1))] = any(0, 4 * side) * (scale / 4); };
  switch (any(0, 6)) {
    case 0: claim["chain"].erase(static_cast<std::size_t>(any(0, int(claim["chain"].size()) - 1))); break;
    case 1: moved(one_of(claim["chain"])); break;
    case 2: claim["width"] = claim["width"].get<std::int64_t>() - any(1, 3) * scale / 4; break;
    case 3: moved(one_of(claim["path"])); break;
    case 4:
      if (claim.contains("keeps")) claim["keeps"] = claim["keeps"].get<std::int64_t>() + any(1, 3) * scale / 16;
      break;
    case 5: claim["chain"] = json::array({one_of(claim["chain"])}); break;
    default: claim["path"].erase(static_cast<std::size_t>(any(0, int(claim["path"].size()) - 1))); break;
  }
  return claim;
}

Query changed(Query query, int side) {
  WorldParts parts = query.world.parts();
  if (parts.walls.empty()) return query;
  const auto i = static_cast<std::size_t>(any(0, int(parts.walls.size()) - 1));
  if (any(0, 1) == 0)
    parts.walls.erase(parts.walls.begin() + static_cast<std::ptrdiff_t>(i));
  else
    parts.walls[i].b = test::any_lattice_point(side);
  return {World(parts), query.start, query.goal};
}

json about(const Query& query, json claim) {
  const DiscCertificate empty;
  claim["world"] = json::parse(certificate_text(empty, query.text(), {}))["world"];
  return claim;
}

// RC_PARAMS=max_success=3000 makes some 20 000.
TEST(DiscCertificate, ThatWasTamperedWithIsNeverApprovedWrongly) {
  int cases = 0;
  const bool sound = rc::check("tampered certificates of discs", [&] {
    int side = 0;
    const Query query = any_query(side);
    if (!has_places(query)) return;
    const auto certificate = any(0, 1) ? widest_of(query) : narrow_of(query, any(1, 8) / 8.0);
    if (!certificate) return;
    for (int i = 0; i < 5; ++i) {
      const json other = tampered(json::parse(*certificate), side);
      RC_LOG() << query.text() << other << '\n';
      RC_ASSERT(wrong_approval(query, other) == "");
      const Query moved = changed(query, side);
      RC_LOG() << moved.text() << '\n';
      RC_ASSERT(wrong_approval(moved, about(moved, json::parse(*certificate))) == "");
      cases += 2;
    }
  });
  EXPECT_TRUE(sound);
  EXPECT_GE(cases, 100);
}

}  // namespace
}  // namespace taut
