// What `taut batch` was asked.
#pragma once

#include <string>

#include <taut/cli/options.h>
#include <taut/cli/shards.h>
#include <taut/cli/solve/index_option.h>

namespace taut::cli {

struct BatchOptions {
  WorldOptions world;
  QueryOptions query;
  CommonOptions common;
  IndexOptions index;
  std::string queries;
  bool json_lines = false;
  bool path = false;
  bool widest = false;  ///< the largest disc instead of the path
  bool arcs = false;    ///< a disc's path; each line has its radius
  std::string certificate;
  ShardOptions shards;
};

}  // namespace taut::cli
