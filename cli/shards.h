// Work that is shared among machines: --shard, --part and --join.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/cli/command_line.h>
#include <taut/cli/run.h>

namespace taut::cli {

/// What stands on the command line.
struct ShardOptions {
  std::size_t shard = 0;  ///< of `shards`; 0: the work is not shared
  std::size_t shards = 0;
  std::string part;               ///< this shard's file
  std::vector<std::string> join;  ///< all shards' files
  bool ranks = false;             ///< --mpi: the ranks of mpirun share it
  double lost_after = 300;        ///< seconds
  std::string how;                ///< the options that results depend on, as they were given

  bool is_shared() const { return shard > 0 || !join.empty() || ranks; }
};

/// `--shard I/N`, `--part FILE`, `--join FILE...`, `--mpi`, `--lost-after S`. Both must outlive the parsing.
void add_shard_options(CommandLine& app, ShardOptions& options, CommonOptions& common);

/// Work in items, each done by anybody, anywhere: what it gives is bytes that depend on the item alone.
struct Items {
  std::string work;  ///< mark_of all that they depend on
  std::size_t count = 0;
  /// Called once, by who does items, before the first: what they share.
  std::function<void()> prepare = [] {};
  /// What a thread does items with.
  std::function<std::function<std::string(std::size_t)>()> begin;
};

/// Does the items of the shard that its file does not hold yet, by --jobs threads, and adds each as soon as it and all
/// before it are done: a shard that was stopped goes on after what is whole. Throws InputError when the file is of
/// another work, or somebody else's at the moment; WriteError.
Answer do_shard(const ShardOptions& options, const Items& items, Run& run);

/// Takes the bytes of all items, in order: done by the ranks (ranks.h), or out of the shards' files. Throws InputError,
/// in one line, for a shard that is missing, there twice, of another work, unfinished or damaged.
void take_all(const ShardOptions& options, const Items& items, const Run& run,
              const std::function<void(std::size_t, std::string_view)>& take);

}  // namespace taut::cli
