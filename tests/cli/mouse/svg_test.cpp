// The pictures of taut mouse run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/program_test.h"
#include "support/text.h"

namespace taut::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class MousePictures : public ProgramTest {};

TEST_F(MousePictures, ShowWhatWasSeenAndBothRoutes) {
  const Outcome run = run_taut("mouse run --quick --svg - " + data_file("mouse_12.cells"));
  EXPECT_THAT(run.out, StartsWith("<svg xmlns="));
  EXPECT_THAT(run.out, EndsWith("</svg>\n"));
  for (const char* group : {"sight", "rooms", "goal", "start", "seen", "unseen", "posts", "run1", "run2"})
    EXPECT_THAT(run.out, HasSubstr("<g class=\"" + std::string(group) + "\">"));
  EXPECT_THAT(run.out, Not(HasSubstr("class=\"flood\"")));
  const Outcome flood = run_taut("mouse run --quick --flood --svg - " + data_file("mouse_12.cells"));
  EXPECT_THAT(flood.out, HasSubstr("class=\"flood\""));
}

TEST_F(MousePictures, MarkStartAndGoal) {
  for (const char* command : {"mouse run --quick --svg - ", "mouse speed --svg - "}) {
    const std::string picture = run_taut(command + data_file("mouse_16.maz")).out;
    EXPECT_EQ(picture, run_taut(command + data_file("mouse_16.maz")).out);
    EXPECT_EQ(count(picture, "<g class=\"start\"><circle"), 2U) << "in the maze and in the legend";
    EXPECT_EQ(count(picture, "<g class=\"goal\"><path"), 2U);
  }
}

TEST_F(MousePictures, PlayByThemselves) {
  const Outcome run = run_taut("mouse run --quick --animate - " + data_file("mouse_12.cells"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("<animateTransform attributeName=\"transform\" type=\"translate\""));
  EXPECT_THAT(run.out, HasSubstr("type=\"rotate\""));
  EXPECT_THAT(run.out, HasSubstr("run 2 \xC2\xB7 step 1<"));
  EXPECT_EQ(run_taut("mouse run --quick --animate - " + data_file("mouse_12.cells")).out, run.out);
}

TEST_F(MousePictures, ChangeTheirNumbersAsTheMapGrows) {
  const std::string film = run_taut("mouse run --quick --flood --animate - " + data_file("mouse_12.cells")).out;
  const std::string still = run_taut("mouse run --quick --flood --svg - " + data_file("mouse_12.cells")).out;
  const auto numbers = [](const std::string& picture) {
    const std::size_t from = picture.find("<g class=\"flood\">");
    return picture.substr(from, picture.find("</g>", from) - from);
  };
  EXPECT_EQ(count(numbers(still), "<text"), 144U);
  EXPECT_EQ(count(numbers(film), "class=\"appears\""), 144U) << "those of the end";
  EXPECT_GT(count(numbers(film), "class=\"moving\""), 10U) << "those that changed";
}

TEST_F(MousePictures, StandSideBySideBeforeDuringAndAfterExploring) {
  const Outcome run = run_taut("mouse run --quick --explorer prove --values - " + data_file("mouse_12.cells"));
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* when : {"before the first step", "at the goal", "at the end of run 1"})
    EXPECT_THAT(run.out, HasSubstr(when));
  EXPECT_EQ(count(run.out, "<g class=\"flood\"><text"), 3U);
}

// Every list of key times rises from 0 to at most 1 and has as many entries as its values.
TEST_F(MousePictures, KeepTheirKeyTimesInOrder) {
  const std::string film = run_taut("mouse run --quick --explorer dfs --animate - " + data_file("mouse_16.maz")).out;
  std::size_t lists = 0;
  for (std::size_t at = 0; (at = film.find("values=\"", at)) != std::string::npos; ++lists) {
    const std::size_t values_from = at + 8, values_to = film.find('"', values_from);
    const std::size_t keys_from = film.find("keyTimes=\"", values_to) + 10, keys_to = film.find('"', keys_from);
    const std::string keys = film.substr(keys_from, keys_to - keys_from);
    EXPECT_EQ(count(keys, ";"), count(film.substr(values_from, values_to - values_from), ";"));
    double last = 0;
    for (std::size_t from = 0; from <= keys.size();) {
      const double key = std::stod(keys.substr(from));
      EXPECT_GE(key, last);
      EXPECT_LE(key, 1.0);
      last = key;
      from = std::min(keys.find(';', from), keys.size()) + 1;
    }
    at = keys_to;
  }
  EXPECT_GT(lists, 100U);
}

}  // namespace
}  // namespace taut::test
