#include <taut/cli/path_files.h>

#include <utility>

#include <taut/io/results/pose_file.h>

namespace taut::cli {

void add_path_file_options(CommandLine& app, PathFiles& files) {
  app.add_option("--geojson", files.geojson, "Write the path as GeoJSON; arcs and curves as legs, with their tolerance")
      .type_name("FILE")
      .group("Output");
  app.add_option("--wkt", files.wkt, "Write the path as WKT; circular arcs are arcs there")
      .type_name("FILE")
      .group("Output");
  app.add_option("--csv", files.csv, "Write the path's points as CSV: x,y and what more there is of each")
      .type_name("FILE")
      .group("Output");
  app.add_option("--poses", files.poses, "Write the path as poses for ROS: nav_msgs/Path as YAML, yaw along the path")
      .type_name("FILE")
      .group("Output");
}

void promise(Run& run, const PathFiles& files) {
  for (const std::string& file : {files.geojson, files.wkt, files.csv, files.poses}) run.promise(file);
}

void add_path_files(std::vector<OutputFile>& out, const PathFiles& files, const std::vector<PathToWrite>& paths) {
  if (paths.empty()) return;
  if (!files.geojson.empty()) out.push_back({files.geojson, path_geojson(paths)});
  if (!files.wkt.empty()) out.push_back({files.wkt, path_wkt(paths)});
  if (!files.csv.empty()) out.push_back({files.csv, path_csv(paths)});
  if (!files.poses.empty()) out.push_back({files.poses, path_poses(paths)});
}

}  // namespace taut::cli
