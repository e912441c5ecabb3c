#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <string>

#include <taut/geometry/free_space.h>
#include <taut/io/worlds/read_world.h>
#include <taut/io/worlds/ros_map.h>
#include <taut/search/shortest_path.h>

#include "support/program_test.h"
#include "support/refusal.h"

namespace taut::test {
namespace {

// 4 x 3 pixels, two black ones in the middle row.
const std::string kPlain = "P2\n# by hand\n4 3\n255\n254 254 254 254\n254 0 0 254\n254 254 254 254\n";

class RosMap : public ProgramTest {
 protected:
  std::string map(const std::string& more, const std::string& picture = kPlain) {
    folder.file("map.pgm", picture);
    return folder.file("map.yaml", "image: map.pgm\n" + more);
  }
};

TEST_F(RosMap, IsAWorldInMetresWithYUp) {
  const World world = read_world_file(map("resolution: 0.05\norigin: [-10.0, 2.5, 0.0]\nnegate: 0\n"));
  EXPECT_EQ(world.box(), (Box{{-10, 2.5}, {-9.8, 2.65}}));
  ASSERT_EQ(world.solids().size(), 1U);
  for (const Point p : world.solids()[0].polygon.outer) {
    EXPECT_TRUE(p.x == -9.95 || p.x == -9.85) << p.x;  // decimals, not sums of doubles
    EXPECT_TRUE(p.y == 2.55 || p.y == 2.6) << p.y;
  }
}

TEST_F(RosMap, IsPlannedIn) {
  const World world = read_world_file(map("resolution: 1.0\norigin: [0, 0, 0]\n"));
  const FreeSpace space(world);
  EXPECT_EQ(shortest_path(space, {0.5, 1.5}, {{Point{3.5, 1.5}}, {}})->length.decimals(9), "3.414213562");
}

// Of a map that is turned by `yaw` around its origin: from the middle of one pixel to that of another, in metres from
// the lower left corner.
std::optional<std::string> turned_length(const std::string& picture, double yaw, Point from, Point to,
                                         RosMapInfo info = {}) {
  info.resolution = 1;
  info.origin = {500000, 5400000};
  info.yaw = yaw;
  const World world = ros_world(occupancy(read_raster(picture, "map"), info, false), info, "map");
  const auto turned = [&](Point p) {
    return Point{info.origin.x + (std::cos(yaw) * p.x - std::sin(yaw) * p.y),
                 info.origin.y + (std::sin(yaw) * p.x + std::cos(yaw) * p.y)};
  };
  const auto path = shortest_path(FreeSpace(world), turned(from), {{turned(to)}, {}});
  return path ? std::optional(path->length.decimals(6)) : std::nullopt;
}

TEST(RosYaw, TurnsTheMapAndOpensNothing) {
  const std::string wall = "P2 4 3 255 254 0 254 254  254 0 254 254  254 0 254 254";
  const std::string corners = "P2 4 4 255  0 254 254 254  254 0 254 254  254 254 0 254  254 254 254 0";
  for (int degrees = 1; degrees < 360; degrees += 7) {
    const double yaw = degrees * 0.017453292519943295;
    EXPECT_EQ(turned_length(kPlain, yaw, {0.5, 1.5}, {3.5, 1.5}), "3.414214") << degrees;
    EXPECT_EQ(turned_length(wall, yaw, {0.5, 1.5}, {3.5, 1.5}), std::nullopt) << degrees;
    EXPECT_EQ(turned_length(corners, yaw, {0.5, 0.5}, {3.5, 3.5}), std::nullopt) << degrees;
    EXPECT_EQ(turned_length(corners, yaw, {1.5, 0.5}, {0.5, 1.5}), "1.414214") << degrees;
  }
}

TEST_F(RosMap, SaysThatItIsTurned) {
  const Outcome run = run_taut("solve " + map("resolution: 1\norigin: [1, 2, 0.5]\n") +
                               " --from 0.7196530,3.5560866 --to 3.3524007,4.9943632");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("3.414214"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find("turned by the map's yaw, 0.5; corners are off by at most 1e-14 m"), std::string::npos)
      << run.err;
}

TEST_F(RosMap, KnowsWhatNobodyKnows) {
  const std::string grey = "P2 2 1 255 205 254";
  const std::string file = map("resolution: 1\norigin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.196\n", grey);
  EXPECT_EQ(read_world_file(file).solids().size(), 1U);  // (255 - 205) / 255 = 0.19608 is not below 0.196
  EXPECT_EQ(read_world_file(map("resolution: 1\norigin: [0, 0, 0]\nfree_thresh: 0.1\n", grey)).solids().size(), 1U);
  ReadOptions free;
  free.unknown_is_free = true;
  EXPECT_EQ(read_world_file(map("resolution: 1\norigin: [0, 0, 0]\nfree_thresh: 0.1\n", grey), free).solids().size(),
            0U);
}

TEST(RosOccupancy, ReadsAllModes) {
  RosMapInfo info;
  const Raster raster{4, 1, {0, 100, 205, 254}, {255, 255, 255, 0}};
  const auto blocked = [&](bool unknown_is_free) { return occupancy(raster, info, unknown_is_free).blocked; };
  EXPECT_EQ(blocked(true), (std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_EQ(blocked(false), (std::vector<std::uint8_t>{1, 1, 1, 0}));
  info.negate = true;
  EXPECT_EQ(blocked(true), (std::vector<std::uint8_t>{0, 0, 1, 1}));
  info.negate = false;
  info.mode = RosMapInfo::Mode::scale;
  EXPECT_EQ(blocked(false), (std::vector<std::uint8_t>{1, 1, 1, 1}));  // the last is not opaque: unknown
  info.mode = RosMapInfo::Mode::raw;
  EXPECT_EQ(blocked(true), (std::vector<std::uint8_t>{0, 1, 0, 0}));
}

TEST_F(RosMap, NamesFileLineAndKeyOfWhatIsWrong) {
  const auto message = [&](const std::string& more, const std::string& picture = kPlain) {
    const std::string file = map(more, picture), text = refusal_of([&] { read_world_file(file); });
    return text.substr(text.find_last_of('/') + 1);
  };
  const std::string good = "resolution: 1\norigin: [0, 0, 0]\n";
  EXPECT_EQ(message("origin: [0, 0, 0]\n"), "map.yaml:1: a map without resolution");
  EXPECT_EQ(message("resolution: 0\norigin: [0, 0, 0]\n"), "map.yaml:2: resolution must be above 0");
  EXPECT_EQ(message("resolution: one\norigin: [0, 0, 0]\n"), "map.yaml:2: 'one' is not a number");
  EXPECT_EQ(message("resolution: 1\norigin: [0, 0, north]\n"), "map.yaml:3: 'north' is not a number");
  EXPECT_EQ(message(good + "mode: other\n"), "map.yaml:4: mode 'other' is not trinary, scale or raw");
  EXPECT_EQ(message(good + "free_thresh: 0.9\n"), "map.yaml:4: free_thresh is above occupied_thresh");
  EXPECT_EQ(message(good, "P5\n4 3\n255\nabc"), "map.pgm: the picture ends after 3 of 12 pixels");
  EXPECT_EQ(message(good, "GIF89a"), "map.pgm: is no picture that is read here (PNG, or a portable grey map P2, P5)");
  EXPECT_EQ(message(good + "a: [\n").substr(0, 26), "map.yaml:5: not valid YAML");
}

TEST_F(RosMap, OrAPictureAloneIsReadByTheProgram) {
  const std::string yaml = map("resolution: 1\norigin: [0, 0, 0]\n"), picture = (folder / "map.pgm").string();
  const std::string ends = " --from 0.5,1.5 --to 3.5,1.5";
  EXPECT_EQ(run_taut("solve " + yaml + ends).code, 0);
  EXPECT_EQ(run_taut("solve " + picture + ends + " --resolution 1").code, 0);
  const Outcome refused = run_taut("solve " + picture + ends);
  EXPECT_EQ(refused.code, 3);
  EXPECT_NE(refused.err.find("is a picture: how many metres is a pixel (--resolution)?"), std::string::npos);
}

}  // namespace
}  // namespace taut::test
