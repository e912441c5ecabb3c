// --geojson, --wkt, --csv, --poses: the path in the files of other trades.
#pragma once

#include <string>
#include <vector>

#include <taut/cli/command_line.h>
#include <taut/cli/run.h>
#include <taut/io/results/path_file.h>

namespace taut::cli {

/// Files for the path; an empty name is none, `-` standard output.
struct PathFiles {
  std::string geojson;
  std::string wkt;
  std::string csv;
  std::string poses;

  bool wanted() const { return !geojson.empty() || !wkt.empty() || !csv.empty() || !poses.empty(); }
};

void add_path_file_options(CommandLine& app, PathFiles& files);
void promise(Run& run, const PathFiles& files);

/// What was asked for, to be written; without a path nothing: files of an earlier run are left as they were.
void add_path_files(std::vector<OutputFile>& out, const PathFiles& files, const std::vector<PathToWrite>& paths);

}  // namespace taut::cli
