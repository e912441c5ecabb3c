// The shape of the source tree: who may include whom, and what no part of the library does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

// geometry <- roadmaps <- search <- robots <- io <- web <- cli; io <- python; verify stands alone, and both ask it
const std::map<std::string, std::set<std::string>> kMayInclude{
    {"geometry", {"geometry"}},
    {"roadmaps", {"geometry", "roadmaps"}},
    {"search", {"geometry", "roadmaps", "search"}},
    {"robots", {"geometry", "roadmaps", "search", "robots"}},
    {"io", {"geometry", "roadmaps", "search", "robots", "io"}},
    {"web", {"geometry", "roadmaps", "search", "robots", "io", "web"}},
    {"cli", {"geometry", "roadmaps", "search", "robots", "io", "web", "cli", "verify"}},
    {"python", {"geometry", "roadmaps", "search", "robots", "io", "python", "verify"}},
    {"verify", {"verify"}},  // what judges shares nothing with what is judged
};

struct Line {
  std::string place;  // geometry/world.h:12
  std::string layer;
  std::string text;  // without // comments
};

std::vector<Line> lines_of(const fs::path& file, const std::string& layer) {
  std::vector<Line> lines;
  std::ifstream in(file);
  const std::string name = fs::relative(file, TAUT_SOURCE_DIR).generic_string();
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    const std::string place = name + ":" + std::to_string(++number);
    lines.push_back({place, layer, text.substr(0, text.find("//"))});
  }
  return lines;
}

/// Of all layers, and of one more folder when it is named.
std::vector<Line> sources(const std::string& more = {}) {
  std::vector<Line> all;
  std::set<std::string> layers;
  for (const auto& [layer, allowed] : kMayInclude) layers.insert(layer);
  if (!more.empty()) layers.insert(more);
  for (const std::string& layer : layers) {
    const fs::path folder = fs::path(TAUT_SOURCE_DIR) / layer;
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      const auto lines = lines_of(entry.path(), layer);
      all.insert(all.end(), lines.begin(), lines.end());
    }
  }
  return all;
}

// Places, as `file:line: text`, that match the pattern in one of the layers.
std::vector<std::string> matches(const std::string& pattern, const std::set<std::string>& layers) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (const Line& line : sources()) {
    if (layers.contains(line.layer) && std::regex_search(line.text, regex))
      found.push_back(line.place + ":" + line.text);
  }
  return found;
}

const std::set<std::string> kLibrary{"geometry", "roadmaps", "search", "robots", "io", "web", "verify"};
const std::set<std::string> kAll{"geometry", "roadmaps", "search", "robots", "io", "web", "cli", "python", "verify"};

TEST(Layers, IncludeOnlyDownwards) {
  const std::regex include(R"re(^\s*#\s*include\s*[<"]taut/([a-z]+)/)re");
  std::vector<std::string> upward;
  for (const Line& line : sources()) {
    std::smatch match;
    if (!std::regex_search(line.text, match, include)) continue;
    if (!kMayInclude.at(line.layer).contains(match[1])) upward.push_back(line.place + ": " + match[1].str());
  }
  EXPECT_THAT(upward, IsEmpty());
}

/// Does the file lie in the folder; of a test the one that it mirrors?
bool lies_in(const std::string& folder, const std::string& file) {
  return file.starts_with(folder + "/") || file.starts_with("tests/" + folder + "/");
}

TEST(Layers, KeepWhatIsInDetailToTheFolderItLiesIn) {
  const std::regex include(R"re(^\s*#\s*include\s*<taut/(.+)/detail/)re");
  std::vector<std::string> strangers;
  for (const Line& line : sources("tests")) {
    std::smatch match;
    if (line.place.starts_with("tests/support/") || !std::regex_search(line.text, match, include)) continue;
    if (!lies_in(match[1], line.place)) strangers.push_back(line.place + ": " + line.text);
  }
  EXPECT_THAT(strangers, IsEmpty()) << "a neighbour needs a public header, or a room of its own";
}

TEST(Layers, AreIncludedByTheirFullNameOnly) {
  EXPECT_THAT(matches(R"(^\s*#\s*include\s*")", kAll), IsEmpty()) << "write #include <taut/geometry/point.h>";
}

TEST(Layers, KeepEachLibraryInItsPlace) {
  EXPECT_THAT(matches(R"(#\s*include\s*<CLI/)", kLibrary), IsEmpty()) << "the command line is the program's";
  EXPECT_THAT(
      matches(R"(#\s*include\s*<(pybind11/|Python\.h))", {"geometry", "roadmaps", "search", "robots", "io", "cli"}),
      IsEmpty())
      << "the library knows no Python";
  EXPECT_THAT(matches(R"(#\s*include\s*<nlohmann/)", {"geometry", "roadmaps", "search"}), IsEmpty());
  EXPECT_THAT(matches(R"(#\s*include\s*<CGAL/)", {"io", "cli", "python"}), IsEmpty())
      << "CGAL stands behind geometry's gate";
  EXPECT_THAT(matches(R"(#\s*include\s*<boost/graph/)", {"geometry"}), IsEmpty()) << "geometry knows no graph";
}

// The program's thread that waits for signals is the only other one.
TEST(Layers, ShareLoopsInOneWay) {
  const auto elsewhere = [](std::vector<std::string> places) {
    std::erase_if(places, [](const std::string& place) {
      return place.starts_with("geometry/parallel.cpp:") || place.starts_with("geometry/detail/crew.cpp:") ||
             place.starts_with("cli/stop.cpp:");
    });
    return places;
  };
  EXPECT_THAT(elsewhere(matches(R"(#\s*include\s*<((oneapi/)?tbb/|tbb\.h|thread>|pthread\.h|future>|omp\.h))", kAll)),
              IsEmpty())
      << "taut/geometry/parallel.h shares loops";
  EXPECT_THAT(matches(R"(#\s*include\s*<(oneapi/)?tbb)", kAll),
              testing::Each(testing::StartsWith("geometry/detail/crew.cpp:")));
}

// So small that somebody can read all of it: lines that are code.
TEST(Layers, KeepTheJudgeOfCertificatesSmallAndFreeOfLibrariesThatPlan) {
  EXPECT_THAT(matches(R"(#\s*include\s*<(CGAL|gmp|boost/graph|boost/geometry|Eigen|oneapi|tbb))", {"verify"}),
              IsEmpty());
  std::size_t code = 0;
  for (const Line& line : sources()) {
    const bool blank = line.text.find_first_not_of(' ') == std::string::npos;
    if (line.layer == "verify" && !blank && !line.text.starts_with("#")) ++code;
  }
  EXPECT_LE(code, 400U);
}

TEST(Layers, NeverPrintOrExitBelowTheProgram) {
  EXPECT_THAT(
      matches(R"(\bstd::(cout|cerr|clog)\b|\b(printf|fprintf|puts|fputs|perror)\s*\(|\bfmt::print\b)", kLibrary),
      IsEmpty());
  EXPECT_THAT(matches(R"(\b(exit|_Exit|quick_exit|abort|terminate)\s*\()", kLibrary), IsEmpty());
}

// These give other values under another standard library, or in another run.
TEST(Layers, DrawNoRandomNumbersThatDifferBetweenMachines) {
  EXPECT_THAT(
      matches(R"(\bstd::[a-z_]+_distribution\b|\brandom_device\b|\bstd::(shuffle|sample)\s*\(|\bs?rand\s*\()", kAll),
      IsEmpty());
}

std::size_t columns_of(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](unsigned char byte) { return (byte & 0xc0) != 0x80; }));
}

// Code is laid out by ./dev format; this is for comments, and for files that want to be two.
TEST(Sizes, AreThoseOfAPageThatCanBeRead) {
  std::vector<std::string> wide, tall;
  for (const auto& [layer, allowed] : kMayInclude)
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(TAUT_SOURCE_DIR) / layer)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      const std::string name = fs::relative(entry.path(), TAUT_SOURCE_DIR).generic_string();
      std::ifstream in(entry.path());
      int number = 0;
      for (std::string line; std::getline(in, line);)
        if (++number; columns_of(line) > 120) wide.push_back(name + ":" + std::to_string(number));
      if (number > 300) tall.push_back(name + ": " + std::to_string(number) + " lines");
    }
  EXPECT_THAT(wide, IsEmpty()) << "120 columns at most";
  EXPECT_THAT(tall, IsEmpty()) << "300 lines at most";
}

// Tables and code cannot be broken; all else can.
TEST(Sizes, OfMarkdownFitAPage) {
  std::vector<std::string> wide;
  for (const auto& entry : fs::recursive_directory_iterator(TAUT_SOURCE_DIR)) {
    const std::string name = fs::relative(entry.path(), TAUT_SOURCE_DIR).generic_string();
    if (entry.path().extension() != ".md" || name.starts_with("build/")) continue;
    std::ifstream in(entry.path());
    int number = 0;
    bool code = false;
    for (std::string line; std::getline(in, line);) {
      ++number;
      if (line.starts_with("```")) code = !code;
      if (!code && line.find_first_not_of(' ') != line.find('|') && columns_of(line) > 120)
        wide.push_back(name + ":" + std::to_string(number));
    }
  }
  EXPECT_THAT(wide, IsEmpty()) << "120 columns at most, tables and code apart";
}

}  // namespace
