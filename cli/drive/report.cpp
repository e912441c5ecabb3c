#include <taut/cli/drive/report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace taut::cli {

namespace {

nlohmann::ordered_json json_of(const DriveResult& result, const car::Course& course,
                               const DriveReportOptions& options) {
  nlohmann::ordered_json json{{"sample", result.sample.number},
                              {"planner", options.planner},
                              {"seed", options.seed},
                              {"open", car::bits_of(result.sample.open, course)},
                              {"reached", result.reached()},
                              {"outcome", car::name(result.drive.outcome)},
                              {"steps", result.steps()},
                              {"collisions", result.drive.outcome == car::Outcome::collision ? 1 : 0},
                              {"replans", result.drive.replans},
                              {"first_plan_ms", result.first_plan},
                              {"slowest_replan_ms", result.slowest_replan}};
  if (result.policy_exact) json["policy_exact"] = *result.policy_exact;
  if (options.controls) json["controls"] = result.drive.controls;
  return json;
}

std::size_t bits_width(const car::Course& course) { return std::max<std::size_t>(course.roadblocks.size(), 4); }

std::string heading(const car::Course& course) {
  return fmt::format("{:>6}  {:<{}}  {:<9}  {:>6}  {:>7}  {:>8}  {:>9}\n", "sample", "open", bits_width(course),
                     "outcome", "steps", "replans", "first ms", "replan ms");
}

std::string row(const DriveResult& result, const car::Course& course) {
  return fmt::format("{:>6}  {:<{}}  {:<9}  {:>6}  {:>7}  {:>8.1f}  {:>9.1f}\n", result.sample.number,
                     car::bits_of(result.sample.open, course), bits_width(course), car::name(result.drive.outcome),
                     result.steps(), result.drive.replans, result.first_plan, result.slowest_replan);
}

std::string summary(const std::vector<DriveResult>& results) {
  std::size_t reached = 0, steps = 0, worst = 0;
  for (const DriveResult& result : results)
    if (result.reached()) ++reached, steps += result.steps(), worst = std::max(worst, result.steps());
  std::string text = fmt::format("reached {} of {} ({:.0f} %)", reached, results.size(),
                                 100.0 * static_cast<double>(reached) / static_cast<double>(results.size()));
  if (reached != 0)
    text +=
        fmt::format(", mean {:.1f} steps, worst {}", static_cast<double>(steps) / static_cast<double>(reached), worst);
  return text + "\n";
}

}  // namespace

std::string drive_json(const std::vector<DriveResult>& results, const car::Course& course,
                       const DriveReportOptions& options) {
  auto json = nlohmann::ordered_json::array();
  for (const DriveResult& result : results) json.push_back(json_of(result, course, options));
  return json.dump(2) + "\n";
}

std::string drive_table(const std::vector<DriveResult>& results, const car::Course& course,
                        const DriveReportOptions& options) {
  std::string table = heading(course);
  for (const DriveResult& result : results) table += row(result, course);
  return options.summary ? table + summary(results) : table;
}

}  // namespace taut::cli
