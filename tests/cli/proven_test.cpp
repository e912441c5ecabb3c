// Exit 1 always means proven, and `optimal` is said only of what is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/io/worlds/read_world.h>

#include "support/program_test.h"
#include "support/sanitized.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Edge = std::pair<Roadmap::Vertex, Roadmap::Vertex>;
using Edges = std::vector<Edge>;

Edges edges_of(const Roadmap& roadmap) {
  Edges edges;
  for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Roadmap::Vertex w : roadmap.neighbours(v))
      if (v < w) edges.emplace_back(v, w);
  return edges;
}

/// A roadmap that the program saved, changed, and saved again with the checksum that belongs to it.
class ForgedRoadmap : public ProgramTest {
 protected:
  void save(const std::string& kind) {
    kept_ = in_folder("kept");
    const Outcome run = run_taut("roadmap -q --kind " + kind + " --save " + kept_ + " " + world_);
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string bytes = contents(kept_);
    saved_ = read_roadmap_file(bytes, kept_, space_);
  }

  Outcome load(std::vector<Point> points, const Edges& edges) {
    const SavedRoadmap forged{saved_.kind, saved_.how, saved_.source, Roadmap(std::move(points), edges)};
    folder.file("kept", roadmap_file(forged, space_));
    return run_taut("solve " + world_ + " --load " + kept_);
  }

  void expect_refusal(const Outcome& run, int line, const std::string& says) {
    EXPECT_EQ(run.code, 3) << run.out << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, StartsWith("taut: " + kept_ + ":" + std::to_string(line) + ": "));
    EXPECT_THAT(run.err, HasSubstr(says));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }

  std::string world_ = data_file("maze_5x7.txt"), kept_;
  FreeSpace space_{read_world_file(world_)};
  SavedRoadmap saved_;
};

TEST_F(ForgedRoadmap, IsRefusedWithTheLineOfAnEdgeThatIsMissing) {
  for (const char* kind : {"visibility", "full", "visibility-brute", "cells", "cells8"}) {
    SCOPED_TRACE(kind);
    save(kind);
    const Edges edges = edges_of(saved_.roadmap);
    for (const std::size_t gone : {std::size_t{0}, edges.size() / 2, edges.size() - 1}) {
      Edges rest = edges;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(gone));
      expect_refusal(load(saved_.roadmap.points(), rest), saved_.line_of(edges[gone].first, true), "is missing");
    }
    expect_refusal(load(saved_.roadmap.points(), {}), saved_.line_of(edges[0].first, true), "is missing");
  }
}

TEST_F(ForgedRoadmap, IsRefusedWithTheLineOfAnEdgeThroughAWall) {
  for (const char* kind : {"visibility", "full", "cells", "cells8", "prm"}) {
    SCOPED_TRACE(kind);
    save(kind);
    Edges edges = edges_of(saved_.roadmap);
    const Roadmap& roadmap = saved_.roadmap;
    for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
      for (Roadmap::Vertex w = v + 1; w < roadmap.vertex_count(); ++w) {
        if (space_.sees(roadmap.point(v), roadmap.point(w))) continue;
        edges.emplace_back(v, w);
        expect_refusal(load(roadmap.points(), edges), saved_.line_of(v, true),
                       kind == std::string("prm") ? "leads through an obstacle" : "does not belong there");
        v = w = static_cast<Roadmap::Vertex>(roadmap.vertex_count());
      }
    ASSERT_GT(edges.size(), roadmap.edge_count());
  }
}

TEST_F(ForgedRoadmap, IsRefusedWithTheLineOfAVertexElsewhere) {
  for (const char* kind : {"visibility", "cells", "prm"}) {
    SCOPED_TRACE(kind);
    save(kind);
    std::vector<Point> points = saved_.roadmap.points();
    points[2] = {-1, -1};
    expect_refusal(load(points, edges_of(saved_.roadmap)), saved_.line_of(2, false), "vertex 2, (-1, -1), ");
  }
}

TEST_F(ForgedRoadmap, OfAPrmWithoutEdgesSaysThatNothingIsProven) {
  save("prm");
  const Outcome run = load(saved_.roadmap.points(), {});
  EXPECT_EQ(run.code, 4) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("no path in the roadmap prm, which does not prove that there is none"));
}

class Proven : public ProgramTest {};

// A wall across the square, and in it a gap of 2.001 in a direction in which the polygon around a disc of radius 1 is
// 2.0024 wide.
constexpr const char* kGap =
    "boundary -9 -9 9 9\n"
    "0.803609 0.595997 16.064151 11.913986\n"
    "-0.803609 -0.595997 -16.064151 -11.913986\n"
    "start 3 -4\n"
    "goal -3 4\n";

TEST_F(Proven, NoneOfADiscIsNotSaidBecauseThePolygonAroundItDoesNotFit) {
  const Outcome exact = run_taut("solve - --arcs --robot disc:1", kGap), run = run_taut("solve - --robot disc:1", kGap);
  EXPECT_EQ(exact.code, 0) << exact.out << exact.err;
  EXPECT_EQ(run.code, 4) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("the polygon around the disc"));
  EXPECT_EQ(run_taut("solve - --robot disc:1.01", kGap).code, 1);
  EXPECT_EQ(run_taut("compare - --robot disc:1 --planners polyanya", kGap).code, 4);
  EXPECT_EQ(run_taut("bug - --robot disc:1", kGap).code, 4);
  const std::string query = folder.file("queries", "3 -4 -3 4\n"), world = folder.file("gap.txt", kGap);
  const Outcome batch = run_taut("batch --robot disc:1 " + world + " " + query);
  EXPECT_EQ(batch.code, 4);
  EXPECT_EQ(batch.out, "1 unproven\n");
  EXPECT_EQ(run_taut("batch --robot disc:1.01 " + world + " " + query).out, "1 none\n");
}

// Sealed, with the goal room's middle in a thick wall.
constexpr const char* kSealedRoom =
    "boundary 0 0 9 9\n"
    "3 0 3 9\n"
    "6 5 8 5 0.5\n"
    "start 1 1\n"
    "goal 6 4 8 6\n";

TEST_F(Proven, NoneIsSaidOfARoomWithTheWallsThatShutIt) {
  for (const char* kind : {"polyanya", "visibility", "full", "prm", "voronoi"}) {
    const Outcome run = run_taut(std::string("solve - --roadmap ") + kind, kSealedRoom);
    EXPECT_EQ(run.code, 1) << kind << run.out << run.err;
    EXPECT_THAT(run.out, HasSubstr("no path: this wall separates start and goal: (3, 0)-(3, 9)")) << kind;
  }
  const json answer = json::parse(run_taut("compare - --planners polyanya --json -", kSealedRoom).out)["result"];
  EXPECT_EQ(answer["proven_none"], true);
}

TEST_F(Proven, NoneOfARoomFullOfObstaclesIsSaidInWords) {
  const Outcome run = run_taut("solve -", "boundary 0 0 9 9\n6 5 8 5 4\nstart 1 1\ngoal 6 4 8 6\n");
  EXPECT_EQ(run.code, 1) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("no path: no place of the goal is free"));
}

TEST_F(Proven, PathsIntoARoomWithWallsInItPassTheCheck) {
  // The way from the entry to the room's middle is blocked; the path ends at the entry.
  const char* world = "boundary 0 0 9 9\n4 3 4 7\nstart 1 5\ngoal 3 3 8 7\n";
  for (const char* kind : {"polyanya", "visibility", "full"}) {
    const Outcome run = run_taut(std::string("solve - --roadmap ") + kind, world);
    EXPECT_EQ(run.code, 0) << kind << run.err;
    EXPECT_THAT(run.out, HasSubstr("length 2.000000, ")) << kind;
  }
  const Outcome inside = run_taut("solve - --from 3.5,5", world);
  EXPECT_THAT(inside.out, HasSubstr("length 0.000000")) << inside.err;
}

TEST_F(Proven, PathsIntoARoomThatReachesBeyondTheBoundaryEndWithinIt) {
  const char* world = "boundary 0 0 3 3\nstart 0.5 0.5\ngoal 2 2 3 5\n";
  for (const char* kind : {"polyanya", "visibility", "full"}) {
    const Outcome run = run_taut(std::string("solve - --json - --roadmap ") + kind, world);
    ASSERT_EQ(run.code, 0) << kind << run.err;
    const json answer = json::parse(run.out)["result"];
    EXPECT_DOUBLE_EQ(answer["length"].get<double>(), 2.1213203435596424) << kind;
    EXPECT_EQ(answer["verified"], true);
    EXPECT_EQ(answer["goal"], json::parse(R"({"room": [[2, 2, 3, 3]]})"));
  }
  const Outcome compared = run_taut("compare -", world);
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_THAT(compared.out, Not(HasSubstr("NO")));
  const Outcome outside = run_taut("solve -", "boundary 0 0 3 3\nstart 0.5 0.5\ngoal 2 4 3 5\n");
  EXPECT_EQ(outside.code, 3) << outside.out;
  EXPECT_THAT(outside.err, HasSubstr("the goal room (2, 4) to (3, 5) lies outside the world"));
}

/// The square from (0, 0) to (3, 3), with a goal room 1 wide on its right side.
std::string geojson_with_room(double low, double high) {
  const auto feature = [](const char* role, const char* kind, const json& at) {
    return json{
        {"type", "Feature"}, {"properties", {{"role", role}}}, {"geometry", {{"type", kind}, {"coordinates", at}}}};
  };
  const auto box = [](double x0, double y0, double x1, double y1) {
    return json{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}}};
  };
  const json features{feature("free", "Polygon", box(0, 0, 3, 3)), feature("start", "Point", {0.5, 0.5}),
                      feature("goal", "Polygon", box(2, low, 3, high))};
  return json{{"type", "FeatureCollection"}, {"features", features}}.dump();
}

TEST_F(Proven, RoomsOfOtherFormatsAreCutAsWell) {
  const Outcome run = run_taut("solve -", geojson_with_room(2, 5));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("length 2.121320, "));
  const Outcome outside = run_taut("solve -", geojson_with_room(4, 5));
  EXPECT_EQ(outside.code, 3) << outside.out;
  EXPECT_THAT(outside.err, HasSubstr("lies outside the world"));
}

/// Whatever planners answer, a path that does not pass the check is a defect and says so.
TEST_F(Proven, ComparisonsNeverEndWellWithAPathThatFailsItsCheck) {
  for (const char* world :
       {"boundary 0 0 3 3\nstart 0.5 0.5\ngoal 2 2 3 5\n", "boundary 0 0 9 9\n4 3 4 7\nstart 1 5\ngoal 3 3 8 7\n",
        "boundary 0 0 9 9\n6 5 8 5 0.5\nstart 1 1\ngoal 6 4 8 6\n",
        "boundary 0 0 2 2\n1 0 1 2\nstart 1 1\ngoal 0 0 2 2\n"}) {
    const Outcome run = run_taut("compare -", world);
    EXPECT_EQ(run.code, run.out.find("NO\n") == std::string::npos ? 0 : 70) << world << run.out << run.err;
    EXPECT_EQ(run.code, 0) << world << run.out << run.err;
  }
}

// What the operating system refuses is a limit, not a defect.
TEST_F(Proven, ThreadsThatCannotBeHadAreALimit) {
  if (kSanitized) GTEST_SKIP() << "memory cannot be limited";
  const std::string map = folder.file("map", run_taut("chase generate --size 150x120 --duration 300 --seed 3").out);
  int stopped = 0;
  for (int kilobytes = 30000; kilobytes <= 60000; kilobytes += 1000) {
    const std::string limited = "ulimit -v " + std::to_string(kilobytes) + "; \"$taut\" ";
    if (run_script(limited + "--version").code != 0) continue;  // not even that
    const Outcome run = run_script(limited + "chase -q --jobs 2 " + map);
    EXPECT_TRUE(run.code == 4 || run.code == 0) << kilobytes << ": " << run.code << run.err;
    stopped += run.code == 4;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), run.code == 4) << run.err;
  }
  EXPECT_GT(stopped, 0);
}

TEST_F(Proven, MemoryIsLimitedBelowALimitThatIsThereAlready) {
  if (kSanitized) GTEST_SKIP() << "memory cannot be limited";
  const Outcome run = run_script("ulimit -v 400000; exec \"$taut\" solve - --max-memory 2G", kSealedRoom);
  EXPECT_EQ(run.code, 1) << run.err;
}

}  // namespace
}  // namespace taut::test
