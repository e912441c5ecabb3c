// What the queries of `taut batch` are asked about, and who asks.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <taut/cli/input.h>
#include <taut/cli/run.h>
#include <taut/cli/solve/batch_options.h>
#include <taut/cli/solve/query_asker.h>
#include <taut/cli/solve/search_stages.h>
#include <taut/cli/solve/wall_lines.h>

namespace taut::cli {

class BatchGround {
 public:
  using Take = std::function<void(const QueryLine&, const QueryAnswer&)>;

  /// Builds what is searched on, in stages of the run. What it is made of must outlive it.
  BatchGround(const BatchOptions& options, const Input& input, Run& run);

  /// Answers in order, `take`n as soon as each and all before it are there. After each the stages may want to go on to
  /// the next one: the rest is asked again.
  void answer(std::span<const QueryLine> block, const Take& take);

  /// Adds a wall or takes one away: later queries are asked one by one, in the world as it is then. A note says where
  /// an index becomes stale. Throws InputError of that line.
  void change(const WallLine& wall, const std::string& source, int line);

  std::shared_ptr<QueryAsker> lend(std::size_t stage);
  bool is_settled() const { return !stages_ || stages_->is_settled(); }
  std::size_t stage_of(std::size_t number) const { return stages_ ? stages_->stage_of(number) : 0; }
  const FreeSpace& space() const { return space_; }
  const std::optional<Index>& index() const { return index_; }
  const Shown& shown() const { return shown_; }
  Seconds prepared() { return std::exchange(prepared_, {}); }  ///< since the last call

 private:
  bool wants_nearest(const Run& run) const;

  const BatchOptions& options_;
  const Shown shown_;
  const FreeSpace space_;
  const EndsOnWalls walls_;
  SharedNoPath no_path_;
  const QueryGround ground_;
  const std::optional<Index> index_;
  std::optional<SearchStages> stages_;  // without an index
  std::array<QueryAskers, 3> askers_;
  std::unique_ptr<QueryAsker> changed_;  // of a world that is no longer what was read
  Seconds prepared_;
};

}  // namespace taut::cli
