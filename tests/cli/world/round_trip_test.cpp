// What is printed reads back as itself: every path that the program writes passes `taut check --path`.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/program_test.h"

namespace taut::test {
namespace {

using testing::HasSubstr;

class RoundTrip : public ProgramTest {
 protected:
  /// Solves, and has each file that it wrote checked. Planners that cannot do with the world or give up are left out.
  void expect_accepted(const std::string& world, const std::string& words, const std::string& robot = "") {
    const std::string files =
        fmt::format(" --json {0}/p.json --geojson {0}/p.geojson --wkt {0}/p.wkt --csv {0}/p.csv --poses {0}/p.yaml",
                    folder.path().string());
    const Outcome solved = run_taut(words + " " + world + robot + files);
    if (solved.code == 3 || solved.code == 4) return;
    ASSERT_EQ(solved.code, 0) << world << " " << words << solved.err;
    ++solved_;
    for (const char* name : {"p.json", "p.geojson", "p.wkt", "p.csv", "p.yaml"}) {
      const Outcome checked = run_taut("check " + world + robot + " --path " + in_folder(name));
      EXPECT_EQ(checked.code, 0) << world << " " << words << " " << name << checked.out << checked.err;
    }
  }

  /// Mazes with walls turned by an angle, as computed numbers or with so many decimals.
  std::string turned(const std::string& name, double degrees, int decimals) {
    const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
    std::string out;
    const auto add = [&](double x, double y) {
      for (const double v : {c * x - s * y, s * x + c * y})
        out += decimals < 0 ? fmt::format("{} ", v) : fmt::format("{:.{}f} ", v, decimals);
    };
    for (const char* word : {"start", "goal"}) {
      out += word + std::string(" ");
      word[0] == 's' ? add(0.5, 0.5) : add(4.5, 6.5);
      out += "\n";
    }
    std::istringstream file(contents(data_file("maze_5x7.txt")));
    for (std::string line; std::getline(file, line);) {
      double v[4];
      if (std::sscanf(line.c_str(), "%lf %lf %lf %lf", v, v + 1, v + 2, v + 3) != 4) continue;
      add(v[0], v[1]);
      add(v[2], v[3]);
      out += "\n";
    }
    return folder.file(name, out);
  }

  int solved_ = 0;
};

TEST_F(RoundTrip, HoldsForAllPlannersOnTheMazesOfData) {
  for (const char* maze : {"maze_5x7.txt", "corridors_30x20.txt", "mouse_16.maz", "mouse_32.maze", "mouse_12.cells"}) {
    const std::string world = data_file(maze);
    for (const char* kind :
         {"polyanya", "visibility", "full", "visibility-brute", "cells", "cells8", "prm-fixed", "prm", "voronoi"})
      expect_accepted(world, std::string("solve --roadmap ") + kind);
    expect_accepted(world, "solve --widest");
    expect_accepted(world, "bug");
    expect_accepted(world, "bug --algorithm tangent --range 2");
  }
  EXPECT_GT(solved_, 40);
}

TEST_F(RoundTrip, HoldsInLargeMazes) {
  for (const char* maze : {"maze_45x45.txt", "maze_61x61_loops.txt", "half_open_60x60.txt"})
    expect_accepted(data_file(maze), "solve");
  EXPECT_EQ(solved_, 3);
}

TEST_F(RoundTrip, HoldsForListings) {
  for (const char* words : {"", " --roadmap voronoi", " --widest", " --robot disc:0.3 --arcs"}) {
    const std::string maze = data_file("maze_5x7.txt");
    const std::string listing = folder.file("path.txt", run_taut("solve -q --path " + maze + words).out);
    EXPECT_EQ(run_taut("check " + maze + " --path " + listing).code, 0) << words;
  }
}

TEST_F(RoundTrip, HoldsForRobots) {
  const std::string world = data_file("maze_5x7.txt");
  expect_accepted(world, "solve", " --robot disc:0.1");
  expect_accepted(world, "solve", " --robot square:0.07");
  expect_accepted(world, "solve --roadmap visibility", " --robot disc:0.3");
  expect_accepted(world, "solve --arcs", " --robot disc:0.3");
  expect_accepted(data_file("floor_plan.geojson"), "solve --arcs", " --robot disc:0.25");
  expect_accepted(data_file("maze_25x25.txt"), "solve --arcs", " --robot disc:0.4");
  EXPECT_EQ(solved_, 6);
}

TEST_F(RoundTrip, HoldsForSeveralPathsOfOneFile) {
  for (const char* world : {"maze_5x7.txt", "floor_plan.geojson", "half_open_60x60.txt"}) {
    expect_accepted(data_file(world), "solve --tradeoff");
    expect_accepted(data_file(world), "solve --clearance 0.1");
  }
  EXPECT_EQ(solved_, 6);
  const std::string world = folder.file("w.txt", "boundary 0 0 10 10\n0 5 8 5\n");
  const std::string both = folder.file("both.csv", "path,x,y\n1,1,1\n1,9,1\n2,1,1\n2,1,9\n");
  const Outcome checked = run_taut("check " + world + " --path " + both + " --json - -q");
  EXPECT_EQ(checked.code, 1);
  const auto result = nlohmann::json::parse(checked.out)["result"];
  EXPECT_EQ(result["paths"].size(), 2u);
  EXPECT_EQ(result["paths"][0]["valid"], true);
  EXPECT_EQ(result["path"], result["paths"][1]) << "the one that is not valid";
}

TEST_F(RoundTrip, OfLegsForADiscTheDiscCounts) {
  // A gap of twice the radius: the disc gets through, the polygon around it does not.
  const std::string world = folder.file("gap.txt", "boundary 0 0 10 10\n0 5 4.3 5\n5 5 10 5\n");
  const std::string legs = folder.file("legs.txt", "4.65 1\n4.65 9\n");
  EXPECT_EQ(run_taut("check " + world + " --robot disc:0.35 --path " + legs).code, 0);
  EXPECT_EQ(run_taut("check " + world + " --robot disc:0.3500001 --path " + legs).code, 1);
  const std::string near = folder.file("near.csv",
                                       "# legs between points of a curve, no farther than 0.01 from it\n"
                                       "x,y\n4.645,1\n4.645,9\n");
  const Outcome said = run_taut("check " + world + " --robot disc:0.35 --path " + near);
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr(", legs within 0.01 of the path"));
}

TEST_F(RoundTrip, CurvesMeasureWhatTheyClaim) {
  const std::string world = data_file("half_open_60x60.txt"), file = in_folder("widest.json");
  ASSERT_EQ(run_taut("solve " + world + " --widest -q --json " + file).code, 0);
  const auto claimed = nlohmann::json::parse(contents(file))["result"]["length"].get<double>();
  const Outcome checked = run_taut("check " + world + " --json - -q --path " + file);
  EXPECT_NEAR(nlohmann::json::parse(checked.out)["result"]["path"]["length"].get<double>(), claimed, 1e-9);
  std::string forged = contents(file);
  const std::string length = fmt::format("\"length\": {}", claimed);
  ASSERT_NE(forged.find(length), std::string::npos);
  forged.replace(forged.find(length), length.size(), fmt::format("\"length\": {}", claimed + 1e-6));
  EXPECT_EQ(run_taut("check " + world + " --path " + folder.file("forged.json", forged)).code, 1);
}

TEST_F(RoundTrip, HoldsForDecimalsAndTurnedWorlds) {
  for (const double angle : {7.0, 17.0, 33.3, 62.0})
    for (const int decimals : {-1, 2, 3})
      for (const char* kind : {"polyanya", "visibility", "prm", "voronoi"})
        expect_accepted(turned("turned.txt", angle, decimals), std::string("solve --roadmap ") + kind);
  EXPECT_GT(solved_, 40);
}

TEST_F(RoundTrip, OfADiscsArcsIsExactByItsBends) {
  const std::string maze = data_file("maze_5x7.txt"), file = in_folder("arcs.json");
  ASSERT_EQ(run_taut("solve " + maze + " --robot disc:0.3 --arcs --json " + file).code, 0);
  const Outcome checked = run_taut("check " + maze + " --path " + file);
  EXPECT_EQ(checked.code, 0) << checked.out;
  EXPECT_THAT(checked.out, HasSubstr("valid, length 10.370362"));
  // The same bends for a larger disc come too near to walls.
  std::string forged = contents(file);
  const std::string radius = "\"radius\": 0.3";
  ASSERT_NE(forged.find(radius), std::string::npos);
  forged.replace(forged.find(radius), radius.size(), "\"radius\": 0.31");
  EXPECT_EQ(run_taut("check " + maze + " --path " + folder.file("forged.json", forged)).code, 1);
}

TEST_F(RoundTrip, CornersAreTheSameForAllPlannersOfOnePath) {
  const std::string maze = data_file("corridors_30x20.txt");
  const std::string corners = "\"corners\": ";
  const auto of = [&](const std::string& words) {
    const std::string out = run_taut("solve " + maze + " --json - -q " + words).out;
    return std::atoi(out.c_str() + out.find(corners) + corners.size());
  };
  const int shortest = of("");
  EXPECT_GT(shortest, 0);
  EXPECT_EQ(of("--roadmap visibility"), shortest);
  EXPECT_EQ(of("--roadmap full"), shortest);
}

TEST_F(RoundTrip, ConvertedFilesCarryTheSameDecimals) {
  const std::string world = "boundary 0 0 10 10\nstart 0.1 0.7\ngoal 9.123456789 3.3000000000000003\n0.8 1.1 4 3.1\n";
  for (const char* format : {"segments", "geojson"}) {
    const std::string there = run_taut(std::string("convert - --as ") + format, world).out;
    EXPECT_EQ(run_taut("convert - --as segments", there).out, run_taut("convert - --as segments", world).out) << there;
  }
}

TEST_F(RoundTrip, DrivesAndChasesAreWrittenWithWhatElseIsKnown) {
  const std::string car = "drive " + data_file("floor_plan.geojson") + " --car length=0.4,width=0.2,radius=0.3";
  const Outcome drive = run_taut(car + " --csv - -q");
  EXPECT_EQ(drive.code, 0) << drive.err;
  EXPECT_THAT(drive.out, HasSubstr("x,y,heading,gear\n"));
  EXPECT_THAT(run_taut(car + " --wkt - -q").out, HasSubstr("CIRCULARSTRING ("));
  EXPECT_THAT(run_taut(car + " --poses - -q").out, HasSubstr("\nposes:\n- header:\n"));
  const std::string chase = "chase " + data_file("town_60x40.chase");
  EXPECT_THAT(run_taut(chase + " --csv - -q").out, testing::StartsWith("x,y,second\n"));
  EXPECT_THAT(run_taut(chase + " --geojson - -q").out, HasSubstr("\"second\": ["));
}

}  // namespace
}  // namespace taut::test
