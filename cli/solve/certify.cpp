#include <taut/cli/solve/certify.h>

#include <optional>

#include <taut/geometry/errors.h>
#include <taut/geometry/plain_world.h>
#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/path_certificate.h>
#include <taut/verify/judge.h>

namespace taut::cli {

void add_certificate_option(CommandLine& app, std::string& file) {
  app.add_option("--certificate", file,
                 "Write a proof of the answer, that no path is shorter or that there is none, for `taut verify`")
      .type_name("FILE")
      .group("Output");
}

void require_certifiable(const SolveOptions& options) {
  if (options.certificate.empty()) return;
  if (options.query.robot.kind() == Footprint::Kind::disc)
    throw UsageError("--certificate is for a point or a square, not for a disc");
  if (options.clearance || options.arcs || options.anytime.wanted || options.world.read.project)
    throw UsageError(
        "--certificate does not go with --clearance, --widest, --tradeoff, --arcs, --anytime and --project");
  if ((options.kind && !options.kind->optimal) || !optimal_everywhere(options.method()))
    throw UsageError(
        "--certificate is for the shortest path: with --roadmap polyanya or visibility, by astar or dijkstra");
}

Certified certified(const FreeSpace& space, const PlanResult& result, bool is_judged, Run& run) {
  const World& world = space.world();
  if (!result.goal.point)
    throw InputError(world.source(), 0,
                     "a certificate is for a goal that is a point, not for a room: name one by --to");
  const FreeSpace plain = is_plain(world, space.footprint()) ? space : FreeSpace(plain_world(space));
  const std::string text = write_plain_integers(plain.world());
  const auto certificate = run.stage("certificate", [&] {
    const VisibilityGraph graph(plain);
    return result.status == SearchStatus::found ? shortest_certificate(graph, result.path)
                                                : none_certificate(graph, *result.start, *result.goal.point);
  });
  if (!certificate) return {"", "no certificate: crossings of walls were rounded where paths bend", 0};
  Certified answer{certificate_text(*certificate, text), "", 0};
  if (!is_judged) return answer;
  const proof::Judgement said = run.stage("judge", [&] { return proof::judge(text, answer.text); });
  answer.words = said.words;
  answer.bound = said.bound;
  if (!said.proven) answer = {"", "the certificate proves nothing: " + said.words, 0};
  return answer;
}

}  // namespace taut::cli
