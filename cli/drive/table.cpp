#include <taut/cli/drive/table.h>

#include <fmt/format.h>

#include <algorithm>

#include <taut/io/worlds/roadblock_map.h>

namespace taut::cli {

namespace {

std::size_t bits_width(const roadblocks::Course& course) { return std::max<std::size_t>(course.roadblocks.size(), 4); }

std::string heading(const roadblocks::Course& course) {
  return fmt::format("{:>6}  {:<{}}  {:<9}  {:>6}  {:>7}  {:>8}  {:>9}\n", "sample", "open", bits_width(course),
                     "outcome", "steps", "replans", "first ms", "replan ms");
}

std::string row(const RoadblockDrive& result, const roadblocks::Course& course) {
  return fmt::format("{:>6}  {:<{}}  {:<9}  {:>6}  {:>7}  {:>8.1f}  {:>9.1f}\n", result.sample.number,
                     bits_of(result.sample.open, course), bits_width(course), name(result.drive.outcome),
                     result.steps(), result.drive.replans, result.first_plan, result.slowest_replan);
}

std::string summed_up(const std::vector<RoadblockDrive>& results) {
  std::size_t reached = 0, steps = 0, worst = 0;
  for (const RoadblockDrive& result : results)
    if (result.reached()) ++reached, steps += result.steps(), worst = std::max(worst, result.steps());
  std::string text = fmt::format("reached {} of {} ({:.0f} %)", reached, results.size(),
                                 100.0 * static_cast<double>(reached) / static_cast<double>(results.size()));
  if (reached != 0)
    text +=
        fmt::format(", mean {:.1f} steps, worst {}", static_cast<double>(steps) / static_cast<double>(reached), worst);
  return text + "\n";
}

}  // namespace

std::string drive_table(const std::vector<RoadblockDrive>& drives, const roadblocks::Course& course, bool summary) {
  std::string table = heading(course);
  for (const RoadblockDrive& drive : drives) table += row(drive, course);
  return summary ? table + summed_up(drives) : table;
}

}  // namespace taut::cli
