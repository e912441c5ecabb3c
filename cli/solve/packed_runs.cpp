#include <taut/cli/solve/packed_runs.h>

#include <utility>

#include <taut/io/saved/packed.h>

namespace taut::cli {

namespace {

void pack(const Seconds& seconds, Packer& packer) { packer.put(seconds.cpu).put(seconds.wall); }

void pack(const PlannerRun& run, Packer& packer) {
  packer.put(std::uint64_t{run.solved}).put(std::uint64_t{run.verified});
  packer.put(std::uint64_t{run.clearance.has_value()}).put(run.clearance.value_or(0));
  for (const std::size_t count : {run.vertices, run.edges, run.expanded, run.path.points.size()})
    packer.put(std::uint64_t{count});
  for (const Point p : run.path.points) packer.put(p);
  pack(run.build, packer);
  pack(run.query, packer);
}

Seconds unpacked_seconds(Unpacker& unpacker) {
  const double cpu = unpacker.real();
  return {cpu, unpacker.real()};
}

PlannerRun unpacked_run(Unpacker& unpacker) {
  PlannerRun run;
  run.solved = unpacker.number() != 0;
  run.verified = unpacker.number() != 0;
  const bool is_clear = unpacker.number() != 0;
  const double clearance = unpacker.real();
  if (is_clear) run.clearance = clearance;
  run.vertices = unpacker.number();
  run.edges = unpacker.number();
  run.expanded = unpacker.number();
  for (std::uint64_t left = unpacker.number(); left > 0; --left) run.path.points.push_back(unpacker.point());
  if (run.solved) run.path.length = Length(run.path.points);
  run.build = unpacked_seconds(unpacker);
  run.query = unpacked_seconds(unpacker);
  return run;
}

}  // namespace

std::string packed_runs(const PlannerRuns& runs) {
  Packer packer;
  packer.put(std::uint64_t{runs.optimal}).put(runs.unfit).put(std::uint64_t{runs.runs.size()});
  for (const PlannerRun& run : runs.runs) pack(run, packer);
  return std::move(packer).bytes();
}

PlannerRuns unpacked_runs(const Planner& planner, std::string_view bytes, const std::string& name) {
  Unpacker unpacker(bytes, name);
  PlannerRuns runs{&planner, unpacker.number() != 0, {}, unpacker.text()};
  for (std::uint64_t left = unpacker.number(); left > 0; --left) runs.runs.push_back(unpacked_run(unpacker));
  return runs;
}

}  // namespace taut::cli
