#include <taut/io/worlds/read_world.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/paths.h"
#include "support/refusal.h"

namespace taut {
namespace {

using std::string;

string message_of(const string& bytes, Format format) {
  return test::refusal_of([&] {
    ReadOptions options;
    options.format = format;
    read_world(bytes, options);
  });
}

string file_message(const string& path) {
  return test::refusal_of([&] { read_world_file(path); });
}

TEST(DetectFormat, LooksAtTheFirstLineThatSaysSomething) {
  EXPECT_EQ(detect_format("# walls\n\n0.5 0.5 7 .5\n"), Format::segments);
  EXPECT_EQ(detect_format("1,2,3,4"), Format::segments);
  EXPECT_EQ(detect_format("0 0 1 1 # one two\n"), Format::segments);
  EXPECT_EQ(detect_format("start 1 1\n0 0 1 1\n"), Format::segments);
  EXPECT_EQ(detect_format("\xEF\xBB\xBF"
                          "12\r\n1,5,"),
            Format::cell_values);
  EXPECT_EQ(detect_format("o---o---o\n"), Format::drawing);
  EXPECT_EQ(detect_format("/* minos */\n+   + . +\n"), Format::drawing);
  EXPECT_EQ(detect_format("0 0 1 0 1 1\n"), Format::num);
  EXPECT_EQ(detect_format("polygon z ((0 0"), Format::wkt);
  EXPECT_EQ(detect_format("SRID=4326;POINTZM(1 2 3 4)"), Format::wkt);
  EXPECT_EQ(detect_format(" {\"type\""), Format::geojson);
  EXPECT_EQ(detect_format(string(256, '\0')), Format::maz);
}

TEST(DetectFormat, TakesTextOfAMazSizeForText) {
  string text = "0 0 1 1 #";
  text.resize(256, 'x');
  EXPECT_EQ(detect_format(text), Format::segments);
}

TEST(Format, HasAWord) {
  for (Format f :
       {Format::segments, Format::cell_values, Format::drawing, Format::maz, Format::num, Format::wkt, Format::geojson})
    EXPECT_EQ(format_named(name(f)), f);
  EXPECT_FALSE(format_named("dwg"));
}

TEST(ReadWorld, PrefersTheFormatItIsTold) {
  EXPECT_EQ(message_of("1 2 3 4\n", Format::wkt), "line 1: a geometry is expected, not '1'");
  EXPECT_EQ(message_of("1 2 3 4\n", Format::maz), "a .maz file has 256 or 1024 bytes, not 8");
  EXPECT_EQ(message_of("", Format::geojson), "file is empty");
}

TEST(ReadWorld, ReadsStreams) {
  std::istringstream in("0 0 4 0\n0 0 0 4\n");
  EXPECT_EQ(read_world(in).walls().size(), 2U);
}

TEST(ReadWorld, TellsWhatItMet) {
  ReadNotes notes;
  read_world("o---o\n. S |\no---o\n", {}, &notes);
  EXPECT_EQ(notes.format, Format::drawing);
  EXPECT_EQ(notes.unknown_walls, 1U);
}

TEST(ReadWorldFile, NamesDirectoriesAndMissingFiles) {
  EXPECT_EQ(file_message("/"), "/: is a directory, not a file");
  EXPECT_EQ(file_message("no/such\x1b[2Jfile"), "no/such?[2Jfile: no such file");
}

TEST(ReadWorld, ReadsBrokenRingsOfOneMeaningWithARemark) {
  const std::vector<std::pair<const char*, const char*>> broken{
      {"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (0 1, 1 1, 1 2, 0 2, 0 1))", "line 1: hole 1 runs along the outer ring"},
      {"POLYGON ((0 0, 4 0, 2 2, 4 4, 0 4, 2 2, 0 0))", "line 1: ring touches itself at (2, 2)"},
      {"POLYGON ((0 0, 4 0, 4 4, 8 4, 4 4, 0 4, 0 0))", "line 1: ring has a spike at (8, 4)"},
      {"POLYGON ((0 0, 4 0, 4 0, 4 4, 0 0))", "line 1: ring repeats the point (4, 0)"},
  };
  for (const auto& [text, remark] : broken) {
    ReadNotes notes;
    read_world(text, {}, &notes);
    ASSERT_FALSE(notes.remarks.empty()) << text;
    EXPECT_EQ(notes.remarks[0].substr(0, string(remark).size()), remark);
  }
}

TEST(ReadWorld, ReadsRingsThatCrossOnlyWhenTold) {
  const ReadOptions repair{.crossings = Crossings::even_odd};
  const std::vector<std::pair<const char*, const char*>> doubtful{
      {"POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))",
       "line 1: ring crosses itself: side (0, 0)-(4, 4) and side (4, 0)-(0, 4): taken by the even-odd rule"},
      {"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (3 1, 6 1, 6 2, 3 2, 3 1))",
       "line 1: hole 1 crosses the outer ring: side (3, 2)-(6, 2) and side (4, 0)-(4, 4): taken as the outer ring "
       "without its holes"},
      {"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 1))", "line 1: ring is not closed: first (0, 0), last (0, 1): closed"}};
  for (const auto& [text, remark] : doubtful) {
    EXPECT_NE(message_of(text, Format::wkt).find(" (--repair"), string::npos);
    ReadNotes notes;
    read_world(text, repair, &notes);
    EXPECT_EQ(notes.remarks, std::vector<string>{remark});
  }
}

TEST(ReadWorld, ReadsTheOthersBesideOneBadRing) {
  string text, bad = "POLYGON ((0 2, 4 6, 4 2, 0 6, 0 2))\nPOLYGON ((7 7, 7 7))\nPOLYGON ((0 0, 0 9, 1 1))\n";
  for (int i = 0; i < 500; ++i) {
    const string x = std::to_string(i), x1 = std::to_string(i + 1);
    text.append("POLYGON ((").append(x).append(" 0, ").append(x1).append(" 0, ").append(x1).append(" 1, ");
    text.append(x).append(" 1, ").append(x).append(" 0))\n");
  }
  ReadNotes notes;
  EXPECT_EQ(read_world(text + bad, {.crossings = Crossings::even_odd}, &notes).areas().size(), 503U);
  EXPECT_EQ(notes.remarks.size(), 3U);
  EXPECT_THROW(read_world(text + bad), InputError);
}

TEST(ReadWorld, TakesPolygonsInPolygonsAsTheyAreMeant) {
  const string plan =
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))\nPOLYGON ((0 1, 8 1, 8 8, 0 8, 0 1))\nPOLYGON ((2 2, 3 2, 3 3, 2 2))";
  ReadNotes notes;
  EXPECT_EQ(read_world(plan, {}, &notes).areas().size(), 3U);
  EXPECT_EQ(
      notes.remarks,
      (std::vector<string>{"line 2: polygon lies wholly in that of line 1, which is free already, and changes nothing "
                           "(--polygons nested makes it a hole); 1 more like it"}));
  const World nested = read_world(plan, {.polygons = ReadOptions::Polygons::nested}, &notes);
  EXPECT_TRUE(notes.remarks.empty());
  ASSERT_EQ(nested.areas().size(), 2U);
  EXPECT_EQ(nested.areas()[0].polygon.outer, (Ring{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 8}, {8, 8}, {8, 1}, {0, 1}}));
  EXPECT_EQ(nested.areas()[1].polygon.outer, (Ring{{2, 2}, {3, 2}, {3, 3}}));
}

// Every file of tests/corpus/bad with the one line it must give.
const std::vector<std::pair<const char*, const char*>> kBad{
    {"bad_wall.txt", ":2: column 5: '!' is no wall ('|', ' ' or '.')"},
    {"bent_drawing.txt", ":3: the row is longer than the 2 cells of the first row"},
    {"blank.txt", ": file is empty"},
    {"broken.geojson", ":2: not valid JSON: syntax error while parsing value - invalid literal; last read: '0], [na'"},
    {"comments.txt", ": file holds nothing but comments"},
    {"crossing_boundary.txt",
     ":1: ring crosses itself: side (0, 0)-(4, 4) and side (4, 0)-(0, 4) (--repair: taken by the even-odd rule)"},
    {"curve.wkt", ":1: geometry 'CIRCULARSTRING' is not supported: write its curves as legs (ST_CurveToLine)"},
    {"cut_off.wkt", ":2: a number is expected, not the end of the file"},
    {"deep.geojson", ":1: JSON is nested more than 64 deep"},
    {"deep.wkt", ":1: geometry collections are nested more than 32 deep"},
    {"disagree.num", ":2: cell (0,0) says open to the right, cell (1,0) says wall"},
    {"disagree_right.csv", ":6: cell (3,6) says open to the right, cell (4,6) says wall"},
    {"disagree_up.csv", ":4: cell (2,3) says wall upwards, cell (2,4) says open"},
    {"empty.txt", ": file is empty"},
    {"escape.txt", ":2: 'x????2Jx' is not a number"},
    {"extra_column.csv", ":6: more than 4 columns"},
    {"five.num", ":2: only 5 of the six numbers X Y N E S W"},
    {"flat_boundary.txt", ":1: boundary box from (0, 0) to (4, 0) has no area: the lower left corner comes first"},
    {"flat_ring.wkt", ":1: no polygon of the floor plan has an area"},
    {"hole_crossing.wkt",
     ":1: hole 1 crosses the outer ring: side (3, 2)-(6, 2) and side (4, 0)-(4, 4) (--repair: taken as the outer ring "
     "without its holes)"},
    {"hole_in_hole.wkt",
     ":1: hole 2 at (3, 3) does not lie apart from hole 1 (--repair: taken as the outer ring without its holes)"},
    {"hole_outside.wkt",
     ":1: hole 1 at (5, 5) does not lie inside its outer ring (--repair: taken as the outer ring without its holes)"},
    {"huge.geojson", ":3: 1e+308 is beyond the largest coordinate, 1e+75"},
    {"huge.txt", ":2: '1e308' is beyond the largest coordinate, 1e+75"},
    {"inf.txt", ":2: '-inf' is not a finite number"},
    {"large_size.csv", ":1: maze size '258' is not a whole number between 2 and 256"},
    {"long_column.csv", ":4: column 2 has more than 4 values"},
    {"lost_comma.txt", ":2: there is nothing before a comma"},
    {"lost_post.txt", ":3: column 5: 'x' is no post ('o' or '+')"},
    {"lost_row.txt", ":5: a row of posts is expected, not 'x---o---o'"},
    {"mark.txt", ":2: column 7: 'E' in cell (1,0) is neither S nor G"},
    {"missing.num", ": cell (1,0) is missing"},
    {"missing_column.csv", ":4: file ends after 3 of 4 columns"},
    {"nan.txt", ":2: 'nan' is not a finite number"},
    {"no_type.geojson", ":1: a GeoJSON object is expected"},
    {"noise.bin", ": binary data of 777 bytes; the only binary format, .maz, has 256 or 1024"},
    {"noise256.maz",
     ": binary data of 256 bytes, but no .maz maze: cell (0,0) says open upwards, cell (0,1) says wall"},
    {"only_points.txt", ": all walls have length zero, and there are no areas"},
    {"open_border.csv", ":2: cell (0,2) is open to the left, but the border is closed"},
    {"overflow.geojson", ":2: not valid JSON: number overflow parsing '1e999'"},
    {"overflow.txt", ":1: '1e999' is out of the range of numbers"},
    {"position.geojson", ":1: a number is expected"},
    {"prose.txt", ":1: no known format begins with 'Once upon a time'"},
    {"self_crossing.geojson",
     ":2: ring crosses itself: side (0, 0)-(4, 4) and side (4, 0)-(0, 4) (--repair: taken by the even-odd rule)"},
    {"self_crossing.wkt",
     ":2: ring crosses itself: side (0, 0)-(4, 4) and side (4, 0)-(0, 4) (--repair: taken by the even-odd rule)"},
    {"short_column.csv", ":4: column 2 has 3 values instead of 4"},
    {"six_numbers.txt", ":2: more than five numbers; a wall is x1 y1 x2 y2 [thickness]"},
    {"thin.txt", ":1: wall thickness -0.5 is negative"},
    {"three_numbers.txt", ":2: only 3 numbers; a wall is x1 y1 x2 y2 [thickness]"},
    {"torn_drawing.txt", ":4: this row does not belong to the drawing above"},
    {"twice.num", ":2: cell (0,0) was already given in line 1"},
    {"two.num", ":1: W '2' is not a whole number between 0 and 1"},
    {"two_starts.txt", ":3: a second start; the first is in line 1"},
    {"two_starts_drawing.txt", ":2: a second start, in cell (1,0); the first is in cell (0,0)"},
    {"type.geojson", ":1: GeoJSON type 'Topology' is not supported"},
    {"unclosed_ring.geojson", ":3: ring is not closed: first (0, 0), last (0, 1) (--repair closes it)"},
    {"unclosed_ring.wkt", ":1: ring is not closed: first (0, 0), last (0, 1) (--repair closes it)"},
    {"unknown_word.txt", ":2: 'finish' is neither a number nor start, goal or boundary"},
    {"utf16.txt", ": text in UTF-16; save it as UTF-8"},
    {"value_16.csv", ":3: value of cell (1,2) '16' is not a whole number between 0 and 15"},
    {"word.csv", ":3: value of cell (1,1) 'x' is not a whole number between 0 and 15"},
};

TEST(BadCorpus, GivesOneClearLineAFile) {
  const string folder = string(TAUT_CORPUS_DIR) + "/bad/";
  for (const auto& [file, message] : kBad) EXPECT_EQ(file_message(folder + file), folder + file + message);
}

TEST(BadCorpus, IsListedCompletely) {
  std::set<string> listed;
  for (const auto& [file, message] : kBad) listed.insert(file);
  for (const auto& entry : std::filesystem::directory_iterator(string(TAUT_CORPUS_DIR) + "/bad"))
    EXPECT_TRUE(listed.contains(entry.path().filename().string())) << entry.path();
}

// No input, however torn, does anything but read or throw an InputError.
TEST(BadCorpus, StaysCalmWhenFilesAreCutOrDamaged) {
  for (const auto& entry : std::filesystem::directory_iterator(string(TAUT_CORPUS_DIR) + "/bad")) {
    const string bytes = read_bytes(entry.path().string());
    for (std::size_t i = 0; i < bytes.size(); i += 1 + bytes.size() / 50) {
      string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ 0x15);
      for (const string& input : {bytes.substr(0, i), damaged}) {
        try {
          read_world(input);
        } catch (const InputError& error) {
          EXPECT_EQ(string(error.what()).find('\n'), string::npos);
        }
      }
    }
  }
}

TEST(MazeFiles, AllReadWithStartGoalAndOpenings) {
  const auto expect_maze = [](const std::filesystem::path& file) {
    SCOPED_TRACE(file);
    const World world = read_world_file(file.string());
    EXPECT_TRUE(world.start());
    EXPECT_TRUE(world.goal().point || !world.goal().room.empty());
    const bool is_open = !world.grid() && file.filename().string().starts_with("maze_");
    if (world.grid() || is_open) EXPECT_EQ(world.openings().size(), is_open ? 2U : 0U);
  };
  const auto own = test::own_mazes();
  EXPECT_GE(own.size(), 11U);
  for (const auto& file : own) expect_maze(file);
  for (const char* folder : {"micromouse", "prm"})
    for (const auto& file : test::shared_files(folder)) expect_maze(file);
}

}  // namespace
}  // namespace taut
