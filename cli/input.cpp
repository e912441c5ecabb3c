#include <taut/cli/input.h>

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/cli/ranks.h>
#include <taut/cli/world/foreign.h>
#include <taut/geometry/errors.h>
#include <taut/io/results/snap_json.h>

namespace taut::cli {

ReadOptions reading_of(const std::string& file, ReadOptions read) {
  read.source = source_name(file);
  read.folder = file == "-" ? "" : std::filesystem::path(file).parent_path().string();
  return read;
}

World read_world_of(const std::string& file, const ReadOptions& options, ReadNotes& notes) {
  const std::string bytes = bytes_for_all(file);
  const ReadOptions read = reading_of(file, options);
  return read_own(bytes, read.source, {FileKind::world}, [&] { return read_world(bytes, read, &notes); });
}

void tell(const ReadNotes& notes, const std::string& name, Run& run) {
  for (const std::string& remark : notes.remarks) note(fmt::format("taut: {}: {}", name, remark));
  run.add_to_result("remarks", notes.remarks);
  run.add_to_result("snap", snap_json(notes.snap));
  run.add_to_result("near", near_json(notes.near));
}

Input read_input(const WorldOptions& options, Run& run, const QueryOptions& query) {
  ReadNotes notes;
  ReadOptions read = options.read;
  read.start = query.from;
  read.goal = query.to;
  World world = run.stage("read", [&] { return read_world_of(options.file, read, notes); });
  std::string name = world.source();
  tell(notes, name, run);
  return {std::move(world), notes, std::move(name), {}};
}

FreeSpace triangulated(FreeSpace space) {
  space.triangulation();
  return space;
}

void require_ends(const Input& input) {
  const Goal& goal = input.world.goal();
  const bool start = input.world.start().has_value(), end = goal.point || !goal.room.empty();
  if (start && end) return;
  throw InputError(input.name, 0,
                   start ? "says nothing about a goal; give --to X,Y"
                   : end ? "says nothing about a start; give --from X,Y"
                         : "says nothing about start and goal; give --from X,Y and --to X,Y");
}

}  // namespace taut::cli
