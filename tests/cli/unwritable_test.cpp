// Every subcommand in an empty folder in which nobody may write: the exit code that belongs to its answer, its answer,
// and no other trace. A library that logs, dumps or ends the program by itself would show here.
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/program_test.h"
#include "support/sanitized.h"

namespace taut::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kRoom = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n";
constexpr const char* kSealed = "0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 4\nstart 1 2\ngoal 3 2\n";
constexpr const char* kSloped = "boundary 0 0 9 9\n1 2 7 5\n4 7 6 3 0.2\n7 1 8 4\nstart 1 1\ngoal 8 8\n";
constexpr const char* kBend = "o---o---o\n|     G |\no   o---o\n| S     |\no---o---o\n";
constexpr const char* kGrid = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";
constexpr const char* kScenarios = "version 1\n0\tgrid.map\t4\t3\t0\t0\t3\t2\t5\n";

/// One run: what is said on stderr is "" unless the subcommand itself has something to say there.
struct Row {
  const char* arguments;
  int code;
  const char* out;  ///< a part of it
  const char* err = "";
  const char* input = "";
};

constexpr Row kRows[] = {
    {"--version", 0, "taut "},
    {"help", 0, "Usage: taut"},
    {"solve @room", 0, "length 2.828427"},
    {"solve @sealed", 1, "this wall separates"},
    {"solve absent", 3, "", "no such file"},
    {"solve @room --svg new.svg", 3, "", "new.svg: "},
    {"solve @room --json new.json", 3, "", "new.json: "},
    {"solve @room --save new", 3, "", "new: "},
    {"solve @sloped --roadmap visibility", 0, "length "},
    {"solve @sloped --roadmap full", 0, "length "},
    {"solve @sloped --roadmap voronoi", 0, "length "},
    {"solve @sloped --roadmap prm", 0, "length "},
    {"solve @room --roadmap prm-fixed", 0, "length "},
    {"solve @room --roadmap cells", 0, "length "},
    {"solve @sloped --anytime", 0, "length "},
    {"solve @sloped --widest", 0, "radius"},
    {"solve @sloped --tradeoff", 0, "radius up to"},
    {"solve @sloped --clearance 0.1", 0, "length"},
    {"solve @sealed --widest", 1, "no path"},
    {"solve @sealed --clearance 0.1", 1, "no "},
    {"solve @sloped --robot disc:0.2", 0, "length"},
    {"solve @sloped --robot disc:0.2 --arcs", 0, "length"},
    {"solve @sealed --robot disc:0.2 --arcs", 1, "no path"},
    {"solve @sloped --robot square:0.2", 0, "length"},
    {"generate --size 3000 --max-memory 20M", 4, "", "out of memory"},
    {"solve @sloped --svg -", 0, "<svg"},
    {"view @sloped -o -", 0, "<html"},
    {"solve @sloped --json -", 0, "\"status\": \"found\""},
    {"check @room --path -", 0, "valid", "", "1 2\n2 3\n3 2\n"},
    {"check @room --path -", 1, "crosses", "", "1 2\n3 2\n"},
    {"solve @room --certificate -", 0, "taut certificate 1"},
    {"solve @room --certificate new", 3, "", "new: "},
    {"verify @room -", 3, "", "cannot be read", "{}"},
    {"audit @room -", 1, "not valid", "", "1 1\n9 9\n"},
    {"roadmap @sloped", 0, "vertices"},
    {"roadmap @sloped --kind voronoi", 0, "vertices"},
    {"compare @sloped --planners polyanya,full-visibility,prm,voronoi", 0, "yes"},
    {"compare @sealed --planners polyanya", 1, "no"},
    {"passage @sloped", 0, "radius"},
    {"passage @sealed", 1, "no path"},
    {"passage @sloped --robot disc:3", 1, "no disc"},
    {"reach @room --from 1,2 --robot disc:0.1", 0, "gets to"},
    {"generate --size 5 --seed 1", 0, "# taut generate"},
    {"generate --size 5 -o new", 3, "", "new: "},
    {"convert @room --as wkt", 0, "LINESTRING"},
    {"convert @room --as geojson", 0, "FeatureCollection"},
    {"convert @room new --as wkt", 3, "", "new: "},
    {"space @sloped -o - --as wkt", 0, "POLYGON"},
    {"space @sloped -o new.wkt", 3, "", "new.wkt: "},
    {"batch @sloped @queries", 0, "1 ", "1 query"},
    {"batch @sealed @queries", 1, "1 none", "1 query"},
    {"matrix @sloped -", 0, "0,", "2 points", "1 2\n3 2\n"},
    {"matrix @sealed -", 1, "0,inf", "1 pair without a path", "1 2\n3 2\n"},
    {"matrix @sloped - -o new.npy", 3, "", "new.npy: ", "1 2\n3 2\n"},
    {"grid solve @grid --start 0,0 --goal 2,3", 0, "cost"},
    {"grid compare @grid --start 0,0 --goal 2,3", 0, "jps"},
    {"grid heuristics @grid --goal 2,3", 0, "manhattan"},
    {"grid scen @grid @scen", 0, "1 as the file says"},
    {"grid generate --size 8x6 --seed 1", 0, "type octile"},
    {"diff @bend @bend", 0, ""},
    {"diff @bend @other", 1, ""},
    {"mouse run @bend", 0, "run"},
    {"mouse run @shut", 1, "", "no way from the start to the goal"},
    {"mouse compare @bend", 0, "explorer"},
    {"mouse check @bend", 1, "not legal: size 2 x 2"},
    {"mouse serve @bend", 0, "", "", "0 1\n90 1\nreset\n0 1\n90 1\n"},
    {"mouse speed @bend", 0, ""},
    {"chase @map", 0, "caught"},
    {"chase compare @map", 0, "exact"},
    {"chase generate --size 20x15 --duration 30 --seed 1", 0, "N"},
    {"chase plane @sloped --target @boat --stays", 0, "caught"},
    {"bug @sloped", 0, "length"},
    {"bug @sealed", 1, "no path, proven"},
    {"bug compare @sloped", 0, "tangent"},
    {"drive @roads", 0, "reached"},
    {"drive @boxed", 1, "no route"},
    {"drive @sloped --car length=0.4,width=0.2,radius=0.5", 0, "length"},
    {"drive @sealed --car length=0.4,width=0.2,radius=0.5", 1, "no drive"},
};

class Unwritable : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (IsSkipped()) return;
    fs::permissions(folder.path(), fs::perms(0755));
    fs::copy_file(program().value(), folder / "taut");
    fs::create_directory(folder / "empty");
    folder.file("empty/.keep", "");
    fs::remove(folder / "empty/.keep");
    for (const auto& [name, bytes] : std::vector<std::pair<std::string, std::string>>{
             {"room", kRoom},
             {"sealed", kSealed},
             {"sloped", kSloped},
             {"bend", kBend},
             {"other", "o---o---o\n|     G |\no   o   o\n| S     |\no---o---o\n"},
             {"shut", "o---o---o\n|   | G |\no   o---o\n| S     |\no---o---o\n"},
             {"grid", kGrid},
             {"scen", kScenarios},
             {"queries", "1 2 3 2\n"},
             {"boat", "0 3 2\n"},
             {"map", run_taut("chase generate --size 20x15 --duration 60 --seed 1").out},
             {"roads", contents(data_file("car/lane.txt"))},
             {"boxed",
              "start 3 3\ngoal 12 3\ngrid 14 5\n##############\n#.....#......#\n#.....#......#\n#.....#......#\n"
              "##############\n"}})
      folder.file(name, bytes);
    fs::permissions(folder / "empty", fs::perms(0555));
  }

  void TearDown() override {
    if (fs::exists(folder / "empty")) fs::permissions(folder / "empty", fs::perms(0755));
  }

  /// As nobody where we are root, whom permissions do not stop. `@room` is the file room beside the empty folder.
  Outcome run(const std::string& arguments, const std::string& input) {
    std::istringstream words(arguments);
    std::string line = "cd " + in_folder("empty") + " && exec ";
    if (geteuid() == 0) line += "setpriv --reuid=65534 --regid=65534 --clear-groups ";
    line += in_folder("taut");
    for (std::string word; words >> word;) line += " " + (word[0] == '@' ? in_folder(word.substr(1)) : word);
    return run_script(line, input);
  }

  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder / "empty"), {}); }
};

TEST_F(Unwritable, FoldersStopNoSubcommandAndHoldNothingAfterwards) {
  for (const Row& row : kRows) {
    if (kSanitized && std::string_view(row.arguments).find("--max-memory") != std::string_view::npos) continue;
    SCOPED_TRACE(row.arguments);
    const Outcome outcome = run(row.arguments, row.input);
    EXPECT_EQ(outcome.code, row.code) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(row.out));
    if (*row.err == 0)
      EXPECT_EQ(outcome.err, "");
    else
      EXPECT_THAT(outcome.err, HasSubstr(row.err));
    EXPECT_LE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    ASSERT_EQ(files(), 0);
  }
}

/// `solve, check, roadmap` of "which of solve, check, roadmap?"
std::vector<std::string> choices(const std::string& err) {
  const std::size_t from = err.find("which of "), to = err.find("?; see");
  std::vector<std::string> names;
  if (from == std::string::npos || to == std::string::npos) return names;
  std::string list = err.substr(from + 9, to - from - 9);
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream words(list);
  for (std::string word; words >> word;) names.push_back(word);
  return names;
}

TEST_F(Unwritable, FoldersAreTriedWithEverySubcommandThereIs) {
  std::set<std::string> tried;
  for (const Row& row : kRows) {
    std::istringstream words(row.arguments);
    std::string first, second;
    words >> first >> second;
    tried.insert({first, first + " " + second});
  }
  const std::vector<std::string> all = choices(run_taut("").err);
  EXPECT_GE(all.size(), 13u);
  for (const std::string& name : all) {
    EXPECT_TRUE(tried.contains(name)) << name;
    for (const std::string& below : choices(run_taut(name).err))
      EXPECT_TRUE(tried.contains(name + " " + below)) << name << " " << below;
  }
}

}  // namespace
}  // namespace taut::test
