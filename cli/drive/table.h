// Drives among roadblocks as a table.
#pragma once

#include <string>
#include <vector>

#include <taut/io/results/drive_json.h>

namespace taut::cli {

/// A row a sample; with `summary` a line below that sums them up.
std::string drive_table(const std::vector<RoadblockDrive>& drives, const roadblocks::Course& course, bool summary);

}  // namespace taut::cli
