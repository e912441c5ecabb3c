// Comparisons as rows, quartiles, CSV and a page.
#include <taut/io/results/report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace taut {
namespace {

using testing::HasSubstr;
using testing::Not;

Json contest() {
  Json runs = Json::array();
  for (const double length : {4.0, 1.0, 2.0, 3.0, 5.0})
    runs.push_back({{"seed", length}, {"length", length}, {"solved", true}});
  runs.push_back({{"seed", 6}, {"length", nullptr}, {"solved", false}});
  return {{"ratio", 1},
          {"planners", Json::array({{{"name", "a<b"}, {"roadmap", "prm"}, {"all_runs", runs}},
                                    {{"name", "one"}, {"length", 7.5}, {"points", Json::array({1, 2})}}})}};
}

TEST(Report, HasARowForEachInnermostItemWithTheTextInFront) {
  const Json rows = report_rows(contest());
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(json_line(rows.items()->front()), R"({"name": "a<b", "seed": 4.0, "length": 4.0, "solved": true})");
  EXPECT_EQ(json_line(rows.items()->back()), R"({"name": "one", "length": 7.5})");
}

TEST(Report, HasQuartilesOfWhatIsThereAndRatesOfTruths) {
  const Json summary = report_summary(report_rows(contest()), "name");
  ASSERT_EQ(summary.size(), 4U);
  EXPECT_THAT(
      json_line((*summary.items())[1]),
      HasSubstr(R"("length", "rows": 5, "mean": 3.0, "least": 1.0, "lower": 2.0, "median": 3.0, "upper": 4.0)"));
  EXPECT_THAT(json_line((*summary.items())[2]), HasSubstr(R"("solved", "rows": 6, "mean": 0.8333)"));
}

TEST(Report, IsCsvWithAColumnForEachMember) {
  EXPECT_EQ(report_csv(Json::array({{{"a", "x, \"y\""}, {"b", true}}, {{"b", nullptr}, {"c", 0.5}}})),
            "a,b,c\n\"x, \"\"y\"\"\",1,\n,,0.5\n");
}

TEST(Report, IsAPageThatTakesNoNameForMarkup) {
  const std::string page = report_html("<title>", report_rows(contest()), "name");
  EXPECT_THAT(page, HasSubstr("<h1>&lt;title&gt;</h1>"));
  EXPECT_THAT(page, HasSubstr(">a&lt;b</text>"));
  EXPECT_THAT(page, Not(HasSubstr("a<b")));
  EXPECT_THAT(page, Not(HasSubstr("nan")));
  EXPECT_THAT(page, Not(HasSubstr("http")));
}

TEST(Report, HasNoBoxPlotOfWhatIsAlwaysTheSame) {
  const Json rows = Json::array({{{"name", "a"}, {"same", 1}, {"cost", 2}}, {{"name", "b"}, {"same", 1}, {"cost", 3}}});
  const std::string page = report_html("", rows, "name");
  EXPECT_THAT(page, HasSubstr("Box plots of cost"));
  EXPECT_THAT(page, Not(HasSubstr("Box plots of same")));
}

}  // namespace
}  // namespace taut
