#include <taut/cli/solve/batch_ground.h>

#include <fmt/format.h>

#include <atomic>
#include <utility>
#include <vector>

#include <taut/cli/jobs.h>
#include <taut/cli/messages.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/parallel.h>

namespace taut::cli {

BatchGround::BatchGround(const BatchOptions& options, const Input& input, Run& run)
    : options_(options),
      shown_(input.notes),
      space_(run.stage("space", [&] { return triangulated(FreeSpace(input.world, options.query.robot)); })),
      walls_(input, options.world.read.snap, space_),
      no_path_(space_),
      ground_{space_,
              walls_,
              shown_,
              options.query.snap_ends,
              wants_nearest(run),
              options.path || !options.certificate.empty()},
      index_(index_of(options.index, space_, run)),
      askers_{QueryAskers{ground_, no_path_}, QueryAskers{ground_, no_path_}, QueryAskers{ground_, no_path_}} {
  if (!index_) stages_.emplace(run.stage("mesh", [&] { return Polyanya(space_); }), options.common.limits.jobs);
}

/// Whoever joins shards may want it though this one does not.
bool BatchGround::wants_nearest(const Run& run) const {
  return options_.query.snap_ends || options_.json_lines || run.wants_json() || options_.shards.is_shared();
}

std::shared_ptr<QueryAsker> BatchGround::lend(std::size_t stage) {
  return index_ ? askers_[0].lend(*index_) : askers_[stage].lend((*stages_)[stage]);
}

void BatchGround::answer(std::span<const QueryLine> block, const Take& take) {
  for (; changed_ && !block.empty(); block = block.subspan(1)) take(block.front(), changed_->ask(block.front()));
  while (!block.empty()) {
    std::vector<QueryAnswer> answers(block.size());
    std::size_t done = 0;
    std::atomic<bool> is_due{false};
    Parallel how{options_.common.limits.jobs, [&] { return is_due.load(); }, {}};
    how.finished = [&](std::size_t over) {
      for (; done < over && !is_due; ++done) {
        is_due = stages_ && stages_->weigh(answers[done]);
        take(block[done], answers[done]);
      }
    };
    each_in_parallel(block.size(), how, [&] {
      return [&, asker = lend(stages_ ? stages_->stage() : 0)](std::size_t i) { answers[i] = asker->ask(block[i]); };
    });
    block = block.subspan(done);
    if (is_due) prepared_ += stages_->go_on();
  }
}

void BatchGround::change(const WallLine& wall, const std::string& source, int line) {
  if (!changed_)
    changed_ = std::make_unique<QueryAsker>(ground_, no_path_,
                                            QueryFinder(index_ ? ChangingWorld(*index_) : ChangingWorld(space_)));
  ChangingWorld& world = *changed_->changing();
  const bool had_index = world.has_index();
  const Segment at{ground_.plane(wall.wall.a), ground_.plane(wall.wall.b)};
  if (wall.adds)
    world.add({at.a, at.b, 0, line});
  else if (!world.remove(at))
    throw InputError(source, line, "no wall stands there from the one end to the other");
  if (had_index && !world.has_index())
    note(fmt::format("{}:{}: the index is stale from here on: a wall that it knows is taken away", source, line));
}

}  // namespace taut::cli
