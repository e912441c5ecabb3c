// What `taut drive` reports of drives among roadblocks: a table and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <taut/robots/roadblocks/drive.h>

namespace taut::cli {

/// One sample driven.
struct DriveResult {
  car::Sample sample;
  car::Drive drive;
  double first_plan = 0, slowest_replan = 0;  ///< milliseconds
  std::optional<bool> policy_exact{};         ///< of planners with a policy

  std::size_t steps() const { return drive.controls.size(); }
  bool reached() const { return drive.outcome == car::Outcome::reached; }
};

struct DriveReportOptions {
  std::string planner;
  std::uint64_t seed = 1;
  bool controls = false;  ///< in the JSON
  bool summary = false;   ///< below the table
};

std::string drive_json(const std::vector<DriveResult>& results, const car::Course& course,
                       const DriveReportOptions& options);
std::string drive_table(const std::vector<DriveResult>& results, const car::Course& course,
                        const DriveReportOptions& options);

}  // namespace taut::cli
