#include <taut/cli/input.h>

#include <filesystem>
#include <utility>

#include <taut/cli/messages.h>
#include <taut/cli/world/foreign.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

World read_world_of(const std::string& file, ReadOptions read, ReadNotes& notes) {
  const std::string bytes = read_bytes(file);
  read.source = source_name(file);
  read.folder = file == "-" ? "" : std::filesystem::path(file).parent_path().string();
  return read_own(bytes, read.source, {FileKind::world}, [&] { return read_world(bytes, read, &notes); });
}

Input read_input(const WorldOptions& options, const QueryOptions& query) {
  ReadNotes notes;
  ReadOptions read = options.read;
  read.start = query.from;
  read.goal = query.to;
  World world = read_world_of(options.file, read, notes);
  std::string name = world.source();
  const std::string from = "taut: " + name + ": ";
  for (const std::string& remark : notes.remarks) note(from + remark);
  return {std::move(world), notes, std::move(name), {}};
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
