#include <taut/cli/solve/certify.h>

#include <array>
#include <optional>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/geometry/plain_world.h>
#include <taut/geometry/walled_world.h>
#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/arc_certificate.h>
#include <taut/search/disc_worlds.h>
#include <taut/search/path_certificate.h>
#include <taut/verify/judge.h>

namespace taut::cli {

void add_certificate_option(CommandLine& app, std::string& file) {
  app.add_option("--certificate", file,
                 "Write a proof of the answer for `taut verify`: that no path is shorter, or none shorter than that; "
                 "that there is none; that no wider disc gets through")
      .type_name("FILE")
      .group("Output");
}

void require_certifiable(const SolveOptions& options) {
  if (options.certificate.empty()) return;
  const bool widest = options.clearance && options.clearance->kind == ClearanceQuery::Kind::widest;
  if ((options.clearance && !widest) || options.anytime.wanted || options.world.read.project)
    throw UsageError("--certificate does not go with --clearance, --tradeoff, --anytime and --project");
}

namespace {

Certified judged(std::string text, const std::string& world, bool is_judged, Run& run) {
  Certified answer{std::move(text), "", 0};
  if (!is_judged) return answer;
  const proof::Judgement said = run.stage("judge", [&] { return proof::judge(world, answer.text); });
  answer.words = said.words;
  answer.bound = static_cast<double>(said.bound);
  if (!said.proven) answer = {"", "the certificate proves nothing: " + said.words, 0};
  return answer;
}

Certified of_disc(const std::optional<DiscCertificate>& certificate, const Gates& gates, Point start, Point goal,
                  bool is_judged, Run& run) {
  if (!certificate) return {"", "no certificate: crossings of walls were rounded where the chain of walls is", 0};
  const std::string text = write_plain_integers(plain_world(gates.space()));
  return judged(certificate_text(*certificate, text, {start, goal}), text, is_judged, run);
}

}  // namespace

Certified certified(const FreeSpace& space, const PlanResult& result, bool is_judged, Run& run) {
  const World& world = space.world();
  if (!is_certifiable(result.goal))
    throw InputError(world.source(), 0,
                     "a certificate is for a goal that is a point or a rectangle, not for other rooms: name one by "
                     "--to");
  const FreeSpace plain = is_plain(world, space.footprint()) ? space : FreeSpace(plain_world(space));
  const std::string text = write_plain_integers(plain.world());
  const auto certificate = run.stage("certificate", [&] {
    const VisibilityGraph graph(plain);
    return result.status == SearchStatus::found ? shortest_certificate(graph, result.path, result.goal)
                                                : none_certificate(graph, *result.start, result.goal);
  });
  if (!certificate) return {"", "no certificate: crossings of walls were rounded where paths bend", 0};
  return judged(certificate_text(*certificate, text), text, is_judged, run);
}

Certified certified(const ClearanceAnswer& answer, const Gates& gates, bool is_judged, Run& run) {
  if (!answer.limit || answer.found.empty()) return {"", "no certificate: there is no widest disc", 0};
  const auto certificate = run.stage("certificate", [&] {
    return widest_certificate(gates, *answer.limit, answer.start, answer.goal, answer.found.front().path.curves);
  });
  return of_disc(certificate, gates, answer.start, answer.goal, is_judged, run);
}

Certified certified_narrow(const World& world, Point start, Point goal, double radius, bool is_judged, Run& run) {
  const Gates gates = run.stage("gates", [&] { return Gates(FreeSpace(walled_world(world, {start, goal}))); });
  const DiscPassage passage = disc_passage(gates, start, goal, radius);
  if (passage.status != DiscStatus::none)
    return {"", "no certificate: no chain of walls and gates keeps the disc itself from the goal", 0};
  const auto certificate =
      run.stage("certificate", [&] { return narrow_certificate(gates, passage, start, goal, radius); });
  return of_disc(certificate, gates, start, goal, is_judged, run);
}

ArcJudgement judged_arcs(const ArcClaim& claim, const ArcTexts& texts, const std::string& source) try {
  return judge_arcs(claim, texts, [](const std::string& world, const std::string& certificate) {
    const proof::Judgement said = proof::judge(world, certificate);
    return ArcJudgement{said.proven, said.words, static_cast<double>(said.length), static_cast<double>(said.bound), 0};
  });
} catch (const proof::BadInput& error) {
  throw InputError(source, 0, error.what());
}

Certified certified(const ArcPath& path, const World& world, bool is_judged, Run& run) {
  const std::array ends{path.start, path.goal};
  const auto certificate = run.stage(
      "certificate", [&] { return ArcProver(disc_ground(world, ends[0], ends[1]), path.radius).certificate(path); });
  if (!certificate)
    return {"", "no certificate: the disc sticks out of the world's limits, or its radius is too fine for the numbers",
            0};
  const ArcTexts texts = arc_texts(world, path.radius, ends);
  Certified answer{certificate_text(*certificate, texts), "", 0};
  if (!is_judged) return answer;
  const ArcJudgement said = run.stage("judge", [&] { return judged_arcs(arc_claim(answer.text).value(), texts); });
  if (!said.proven) return {"", "the certificate proves nothing: " + said.words, 0};
  answer.words = said.words;
  answer.bound = said.bound;
  return answer;
}

}  // namespace taut::cli
