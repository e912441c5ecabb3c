// Very small worlds: as in any other unit down to World::kSmallest, refused in one line below it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "support/program_test.h"

namespace taut::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Two rooms with two doors between them; every number but 0 is from 2 to 20 units.
std::string two_doors(const std::string& unit) {
  std::string in_unit;
  for (const char c : std::string("0 0 20 0\n20 0 20 20\n20 20 0 20\n0 20 0 0\n10 0 10 2\n10 3 10 16\n10 19 10 20\n"
                                  "start 5 5\ngoal 15 5\n")) {
    if (std::isspace(static_cast<unsigned char>(c)) && !in_unit.empty() && std::isdigit(in_unit.back()))
      in_unit += unit;
    in_unit += c;
  }
  return in_unit;
}

struct Mode {
  const char* name;
  std::string arguments;  ///< U stands for the unit
  const char* figure;     ///< a JSON pointer to a length

  std::string in(const std::string& unit) const {
    std::string text = arguments;
    if (const auto at = text.find('U'); at != std::string::npos) text.replace(at, 1, unit);
    return text;
  }
};

void PrintTo(const Mode& mode, std::ostream* out) { *out << mode.arguments; }

/// The answer, in an envelope or not.
json answer_of(const Outcome& run) {
  const json whole = json::parse(run.out, nullptr, false);
  return whole.is_object() && whole.contains("result") ? whole["result"] : whole;
}

class SmallestCoordinate : public ProgramTest, public testing::WithParamInterface<Mode> {};

TEST_P(SmallestCoordinate, IsReadLikeAnyOther) {
  const json::json_pointer figure(GetParam().figure);
  const json large = answer_of(run_taut(GetParam().in("e0") + " --json - -q", two_doors("e0")));
  const Outcome run = run_taut(GetParam().in("e-75") + " --json - -q", two_doors("e-75"));
  EXPECT_EQ(run.code, 0) << run.err;
  const double expected = large.at(figure).get<double>() * 1e-75;
  EXPECT_NEAR(answer_of(run).at(figure).get<double>(), expected, 1e-12 * expected);
}

TEST_P(SmallestCoordinate, IsTheLastThatIsRead) {
  for (const char* unit : {"e-77", "e-140", "e-200", "e-308", "e-322"}) {
    SCOPED_TRACE(unit);
    const Outcome run = run_taut(GetParam().in("e0") + " --max-seconds 20", two_doors(unit));
    EXPECT_EQ(run.code, 3);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr("is nearer to 0 than 1e-75: write the world in a smaller unit"));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SmallestCoordinate,
                         testing::Values(Mode{"Shortest", "solve -", "/length"},
                                         Mode{"Widest", "solve - --widest", "/radius"},
                                         Mode{"Tradeoff", "solve - --tradeoff", "/tradeoff/0/length"},
                                         Mode{"Clearance", "solve - --clearance 0", "/length"},
                                         Mode{"Voronoi", "solve - --roadmap voronoi", "/length"},
                                         Mode{"Arcs", "solve - --arcs --robot disc:1U", "/length"},
                                         Mode{"Disc", "solve - --robot disc:1U", "/length"},
                                         Mode{"Passage", "passage -", "/largest/radius"}),
                         [](const auto& mode) { return mode.param.name; });

}  // namespace
}  // namespace taut::test
