#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include <taut/geometry/errors.h>
#include <taut/io/results/roadmap_export.h>
#include <taut/io/saved/roadmap_file.h>
#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/shortest_path.h>

#include "support/refusal.h"

namespace taut {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\n1 0.1 1 1\nstart 1 2\ngoal 3 2\n";
// The same walls in another order, one turned round, other ends and a comment.
constexpr const char* kShuffled =
    "# room\n1 1 1 0.1\n4 0 4 4\n0 0 4 0\n2 0 2 3\n4 4 0 4\n0 4 0 0\nstart 3 1\ngoal 1 3\n";

World world(const std::string& text, const std::string& source = "room.txt") {
  return read_world(text, ReadOptions{.source = source});
}

std::string saved(const FreeSpace& space) {
  return roadmap_file({"visibility", "how it was made", "", VisibilityGraph(space).roadmap()}, space);
}

std::string refusal(const std::string& bytes, const FreeSpace& space) {
  return test::refusal_of([&] { read_roadmap_file(bytes, "kept.roadmap", space); });
}

TEST(RoadmapFile, ReadsBackTheSameRoadmap) {
  const FreeSpace space(world(kRoom));
  const SavedRoadmap again = read_roadmap_file(saved(space), "kept.roadmap", space);
  EXPECT_EQ(again.kind, "visibility");
  EXPECT_EQ(again.how, "how it was made");
  EXPECT_EQ(again.source, "room.txt");
  EXPECT_EQ(again.roadmap, VisibilityGraph(space).roadmap());
}

TEST(RoadmapFile, KeepsEveryDouble) {
  std::mt19937_64 draws(7);
  std::vector<Point> points;
  const auto draw = [&] { return std::ldexp(static_cast<double>(draws()), static_cast<int>(draws() % 200) - 160); };
  for (int i = 0; i < 1000; ++i) {
    const double x = draw(), y = -draw();
    points.push_back({x, y});
  }
  const Roadmap roadmap(points, std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>>{{0, 999}, {3, 4}, {3, 998}});
  const FreeSpace space(world(kRoom));
  EXPECT_EQ(read_roadmap_file(roadmap_file({"any", "", "", roadmap}, space), "f", space).roadmap, roadmap);
}

TEST(RoadmapFile, AnswersQueriesAsTheGraphItCameFrom) {
  const FreeSpace space(world(kRoom));
  const VisibilityGraph built(space);
  const VisibilityGraph loaded(space, VisibilityKind::reduced, read_roadmap_file(saved(space), "f", space).roadmap);
  EXPECT_EQ(loaded.visible_from({1, 2}), built.visible_from({1, 2}));
  EXPECT_EQ(shortest_path(loaded, {0.5, 0.5}, Goal{Point{3, 1}, {}}).path.points,
            shortest_path(built, {0.5, 0.5}, Goal{Point{3, 1}, {}}).path.points);
  EXPECT_THROW(VisibilityGraph(space, VisibilityKind::full, built.roadmap()), InputError);
}

TEST(RoadmapFile, FitsTheSameWallsInAnotherFile) {
  EXPECT_EQ(fingerprint(world(kRoom)), fingerprint(world(kShuffled)));
  const FreeSpace space(world(kRoom)), shuffled(world(kShuffled));
  const VisibilityGraph loaded(shuffled, VisibilityKind::reduced,
                               read_roadmap_file(saved(space), "f", shuffled).roadmap);
  EXPECT_EQ(loaded.roadmap(), VisibilityGraph(shuffled).roadmap());
}

TEST(RoadmapFile, HasAFingerprintThatNeverChanges) {
  EXPECT_EQ(fingerprint(world(kRoom)), "6e077ec7b6c3c2448dd3de7e863a283f");
}

TEST(RoadmapFile, NamesBothWhenTheMazeIsAnother) {
  const FreeSpace room(world(kRoom)), other(world(std::string(kRoom) + "3 3 3 3.5\n", "other.txt"));
  EXPECT_EQ(refusal(saved(room), other), "kept.roadmap: was built of room.txt (fingerprint " +
                                             fingerprint(room.world()) + "), not of other.txt (fingerprint " +
                                             fingerprint(other.world()) + ")");
  const FreeSpace thick(world(kRoom).with_wall_thickness(0.1));
  EXPECT_THAT(refusal(saved(room), thick), HasSubstr("was built of room.txt"));
}

TEST(RoadmapFile, RefusesAnotherRobot) {
  const World room = world(kRoom);
  EXPECT_EQ(refusal(saved(FreeSpace(room)), FreeSpace(room, Footprint::disc(0.2))),
            "kept.roadmap: was built for the robot `point`, not for `disc 0.2`");
}

TEST(RoadmapFile, RefusesWhatIsNoWholeFileOfThisVersion) {
  const FreeSpace space(world(kRoom));
  const std::string good = saved(space);
  EXPECT_EQ(refusal("", space), "kept.roadmap: is no saved roadmap");
  EXPECT_EQ(refusal(kRoom, space), "kept.roadmap: is no saved roadmap");
  std::string newer = good;
  newer.replace(newer.find("roadmap 1"), 9, "roadmap 2");
  EXPECT_EQ(refusal(newer, space), "kept.roadmap: is a saved roadmap of version 2; this program reads version 1");
  std::string changed = good;
  changed.replace(changed.find("vertices"), 1, "V");
  EXPECT_EQ(refusal(changed, space), "kept.roadmap: is damaged: its checksum is not that of its content");
}

TEST(RoadmapFile, RefusesEveryPieceOfItself) {
  const FreeSpace space(world(kRoom));
  const std::string good = saved(space);
  for (std::size_t n = 0; n < good.size(); ++n) {
    const std::string why = refusal(good.substr(0, n), space);
    EXPECT_THAT(why, StartsWith("kept.roadmap: is ")) << n;
    EXPECT_EQ(why.find('\n'), std::string::npos);
  }
}

TEST(RoadmapExport, WritesGraphmlWithPlacesAndLengths) {
  const Roadmap roadmap({{0, 0.1}, {3, 0.30000000000000004}},
                        std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>>{{0, 1}});
  const std::string text = roadmap_graphml(roadmap);
  EXPECT_THAT(text, HasSubstr("edgedefault=\"undirected\""));
  EXPECT_THAT(text, HasSubstr("attr.name=\"length\" attr.type=\"double\""));
  EXPECT_THAT(text, HasSubstr("source=\"n0\" target=\"n1\""));
  EXPECT_THAT(text, HasSubstr(">0.30000000000000004<"));
}

TEST(RoadmapExport, WritesGeojsonWithAPointAVertexAndALineAnEdge) {
  const Roadmap roadmap({{0, 0}, {3, 4}}, std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>>{{0, 1}});
  EXPECT_EQ(roadmap_geojson(roadmap),
            R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"vertex": 0}, "geometry": {"type": "Point", "coordinates": [0, 0]}},
{"type": "Feature", "properties": {"vertex": 1}, "geometry": {"type": "Point", "coordinates": [3, 4]}},
{"type": "Feature", "properties": {"from": 0, "to": 1, "length": 5}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [3, 4]]}}
]}
)");
}

}  // namespace
}  // namespace taut
