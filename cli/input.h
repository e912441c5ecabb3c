// A world as the options ask for it.
#pragma once

#include <string>
#include <vector>

#include <taut/cli/options.h>
#include <taut/cli/run.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/world.h>
#include <taut/io/results/end_moves.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

/// A file, read.
struct Input {
  World world;
  ReadNotes notes;
  std::string name;              ///< of the file, for messages; `<stdin>`
  std::vector<EndMove> moves{};  ///< of ends that were no places for the robot (snap_ends.h)
};

/// With the name and the folder of `file`, which is - for standard input.
ReadOptions reading_of(const std::string& file, ReadOptions read);

/// read_world_file; a file that another subcommand reads is refused with that one's name.
World read_world_of(const std::string& file, const ReadOptions& read, ReadNotes& notes);

/// Reads FILE in a stage `read` and applies --wall-thickness, --from and --to; tells its notes. Throws InputError.
Input read_input(const WorldOptions& options, Run& run, const QueryOptions& query = {});

/// A line on stderr for each remark; in the result `remarks`, `snap` and `near` (snap_json.h).
void tell(const ReadNotes& notes, const std::string& name, Run& run);

/// Throws InputError, with the options that help, when the world has no start or no goal.
void require_ends(const Input& input);

/// The space with its triangles made, for whoever asks for them in any case: so their time is that of the stage.
FreeSpace triangulated(FreeSpace space);

}  // namespace taut::cli
