// --index and its kin: a world prepared for queries of microseconds.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <taut/cli/command_line.h>
#include <taut/cli/run.h>
#include <taut/search/index.h>

namespace taut::cli {

struct IndexOptions {
  bool build = false;
  std::size_t memory = Index::kMemory;
  std::string save;
  std::string load;

  bool wanted() const { return build || !load.empty(); }
};

/// --index, --index-memory, --save-index, --load-index. --save-index implies --index.
void add_index_options(CommandLine& app, IndexOptions& options);

/// Built or loaded, in a stage of its own; nothing when none is wanted. Throws InputError.
std::optional<Index> index_of(const IndexOptions& options, const FreeSpace& space, Run& run);

/// Adds what --save-index keeps, what to say of the stage, and the result's `index`.
void add_index(const IndexOptions& options, const Index& index, Answer& answer);

}  // namespace taut::cli
