#include <taut/io/pictures/svg.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>

#include <taut/geometry/maze_generator.h>
#include <taut/io/pictures/detail/svg_path.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/shortest_path.h>

namespace taut {
namespace {

using testing::HasSubstr;
using testing::Not;

// 4 x 2, a wall from the bottom in the middle.
WorldParts room(double scale = 1) {
  WorldParts parts;
  parts.areas = {{{{{0, 0}, {4 * scale, 0}, {4 * scale, 2 * scale}, {0, 2 * scale}}, {}}, 0}};
  parts.walls = {{{2 * scale, 0}, {2 * scale, scale}, 0, 0}};
  return parts;
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  if (begin == std::string::npos) return {};
  return text.substr(begin + from.size(), text.find(to, begin + from.size()) - begin - from.size());
}

TEST(Svg, HasAGroupForEachThingThatIsThere) {
  const FreeSpace space{World(room())};
  const Path path = *shortest_path(space, {1, 0.5}, Point{3, 0.5});
  SvgPicture picture{"room.txt", {"length 3"}, nullptr, &path, {}, Point{1, 0.5}, {Point{3, 0.5}, {}}};
  const std::string text = svg(space, picture);
  for (const char* kind : {"free", "walls", "path", "start", "goal", "legend"})
    EXPECT_THAT(text, HasSubstr("<g class=\"" + std::string(kind) + "\">")) << kind;
  for (const char* kind : {"solid", "rooms", "roadmap", "separation"})
    EXPECT_THAT(text, Not(HasSubstr("<g class=\"" + std::string(kind) + "\">"))) << kind;
  EXPECT_THAT(text, HasSubstr("<title>room.txt</title>"));
}

TEST(Svg, PutsNorthUp) {
  const std::string text = svg(FreeSpace{World(room())});
  // From the bottom (24 + 480) up to the middle.
  EXPECT_EQ(between(text, "<g class=\"walls\"><path d=\"", "\""), "M504 504v-240");
}

TEST(Svg, IsTheSameAtEveryScaleThatIsAPowerOfTwo) {
  const auto drawing = [](double scale) {  // the scale bar below says how large it is
    const std::string all = svg(FreeSpace{World(room(scale))});
    return all.substr(0, all.find("<g class=\"legend\">"));
  };
  for (const double scale : {0x1p-200, 0x1p-10, 0x1p20, 0x1p200}) EXPECT_EQ(drawing(scale), drawing(1)) << scale;
}

TEST(Svg, HasAScaleBarOfARoundNumberOfUnits) {
  // 960 pixels are 4, 3 and 2048 units.
  EXPECT_THAT(svg(FreeSpace{World(room())}),
              testing::ContainsRegex("h120m0-4v8\"/><text class=\"key\"[^>]*>0.5 units<"));
  EXPECT_THAT(svg(FreeSpace{World(room(512))}), HasSubstr(">200 units<"));
  EXPECT_THAT(svg(FreeSpace{World(room(2.5))}), HasSubstr(">1 unit<"));
}

TEST(Svg, EscapesWhatIsNoText) {
  const std::string text =
      svg(FreeSpace{World(room())}, {"<a & \"b\">\x01\xff.txt", {"1 < 2"}, nullptr, nullptr, {}, {}, {}});
  EXPECT_THAT(text, HasSubstr("<title>&lt;a &amp; &quot;b&quot;&gt;\xEF\xBF\xBD.txt</title>"));
  EXPECT_THAT(text, HasSubstr("1 &lt; 2"));
}

TEST(Svg, DrawsThickWallsAsWideAsTheyAre) {
  WorldParts parts = room();
  parts.walls[0].thickness = 0.25;
  EXPECT_THAT(svg(FreeSpace{World(parts)}),
              HasSubstr("<path class=\"bar\" style=\"stroke-width:60\" d=\"M504 504v-240\"/>"));
}

TEST(Svg, TintsTheGoalRoom) {
  const std::string text = svg(FreeSpace{World(room())}, {"", {}, nullptr, nullptr, {}, {}, {{}, {{{3, 0}, {4, 2}}}}});
  EXPECT_EQ(between(text, "<g class=\"rooms\"><path d=\"", "\""), "M744 504h240v-480h-240z");
}

TEST(Svg, LeavesAHugeRoadmapOutAndSaysSo) {
  std::vector<Point> points(700, Point{1, 1});
  std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>> edges;
  for (Roadmap::Vertex u = 0; u < 700; ++u)
    for (Roadmap::Vertex v = u + 1; v < 700; ++v) edges.emplace_back(u, v);
  const Roadmap roadmap(points, edges);
  ASSERT_GT(roadmap.edge_count(), kSvgRoadmapEdges);
  const std::string text = svg(FreeSpace{World(room())}, {"", {}, &roadmap, nullptr, {}, {}, {}});
  EXPECT_THAT(text, HasSubstr("roadmap of 244650 edges not drawn"));
  EXPECT_LT(text.size(), 10000U);
}

TEST(Svg, StaysSmallForLargeMazes) {
  const auto maze = std::make_shared<const GridMaze>(generate_biased_maze(300, 300, 1));
  const std::string text = svg(FreeSpace{world_of(maze)});
  EXPECT_LT(text.size(), 600'000U);
}

TEST(SvgNumber, IsShort) {
  EXPECT_EQ(detail::svg_number(1), "1");
  EXPECT_EQ(detail::svg_number(-0.25), "-.25");
  EXPECT_EQ(detail::svg_number(1.0004), "1");
  EXPECT_EQ(detail::svg_number(-0.0001), "0");
  EXPECT_EQ(detail::svg_number(12.3456), "12.346");
}

}  // namespace
}  // namespace taut
