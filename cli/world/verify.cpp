// taut verify: does a certificate prove what it says?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/run.h>
#include <taut/cli/solve/certify.h>
#include <taut/geometry/errors.h>
#include <taut/geometry/free_space.h>
#include <taut/geometry/plain_world.h>
#include <taut/geometry/walled_world.h>
#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/verify/judge.h>

namespace taut::cli {

namespace {

struct VerifyOptions {
  WorldOptions world;
  CommonOptions common;
  std::string certificate;
  Footprint robot;
  std::string integers;
};

void add_options(CommandLine& app, VerifyOptions& options) {
  add_world_options(app, options.world);
  add_robot_option(app, options.robot);
  app.add_option("CERTIFICATE", options.certificate, "What `taut solve --certificate` wrote; - is standard input")
      .required();
  app.add_option("--integers", options.integers, "Write the text of the world that is judged, for other judges")
      .type_name("FILE")
      .group("Output");
  app.callback([&options] {
    if (options.robot.kind() == Footprint::Kind::disc)
      throw UsageError("a disc's certificate says how large it is; leave out --robot");
    if (options.certificate == "-" && options.world.file == "-")
      throw UsageError("FILE and CERTIFICATE cannot both be standard input");
  });
  app.example("taut verify maze.txt maze.proof");
}

// The worlds that certificates are about, made of the one that was given.
class Worlds {
 public:
  Worlds(const World& world, const Footprint& robot) : world_(world), robot_(robot) {}

  /// Of a certificate of any kind but arcs.
  const std::string& text_for(const std::string& certificate) {
    const auto ends = disc_ends(certificate);
    if (text_.empty() || ends != ends_) text_ = ends ? walled(*ends) : plain();
    ends_ = ends;
    return text_;
  }

  const ArcTexts& texts_for(const ArcClaim& claim) {
    if (!arcs_ || claim.radius != radius_ || !is_plain(world_))
      arcs_ = arc_texts(world_, claim.radius, {claim.ends[0], claim.ends[1]});
    radius_ = claim.radius;
    moved_ = std::max(moved_, arcs_->displacement);
    return *arcs_;
  }

  double moved() const { return moved_; }  ///< by rounding, where the world is not judged as it was written

 private:
  std::string walled(const std::array<Point, 2>& ends) {
    const FreeSpace space(walled_world(world_, {ends[1], ends[0]}));
    if (!is_plain(space.world())) moved_ = std::max(moved_, space.report().displacement);
    return write_plain_integers(plain_world(space));
  }

  std::string plain() {
    if (is_plain(world_, robot_)) return write_plain_integers(world_);
    const FreeSpace space(world_, robot_);
    moved_ = std::max(moved_, space.report().displacement);
    return write_plain_integers(plain_world(space));
  }

  const World& world_;
  const Footprint& robot_;
  std::string text_;
  std::optional<std::array<Point, 2>> ends_;
  std::optional<ArcTexts> arcs_;
  double radius_ = 0, moved_ = 0;
};

struct Said {
  bool proven = false;
  std::string words;
  Json result;
  const std::string* world = nullptr;  // its text
};

Json result_of(const proof::Judgement& said) {
  Json result{{"kind", said.kind}, {"proven", said.proven}, {"words", said.words}};
  if (!said.proven || (said.kind == "none" && said.bound == 0)) return result;
  if (said.kind == "shortest") result["length"] = static_cast<double>(said.length);
  if (said.kind == "widest") result["keeps"] = static_cast<double>(said.length);
  result["bound"] = static_cast<double>(said.bound);
  return result;
}

Json result_of(const ArcJudgement& said) {
  Json result{{"kind", "arcs"}, {"proven", said.proven}, {"words", said.words}};
  if (!said.proven) return result;
  result["length"] = said.length;
  result["keeps"] = said.keeps;
  result["bound"] = said.bound;
  return result;
}

/// Without the mark of the library that reads JSON.
std::string plain_words(std::string words) {
  if (const std::size_t begin = words.find("[json.exception."); begin != std::string::npos)
    words.erase(begin, words.find("] ", begin) + 2 - begin);
  return words;
}

Said judged(Worlds& worlds, const std::string& certificate, const std::string& name, Run& run) {
  try {
    if (const auto claim = arc_claim(certificate, name)) {
      const ArcTexts* texts = nullptr;
      run.stage("integers", [&] { texts = &worlds.texts_for(*claim); });
      const ArcJudgement said = run.stage("verify", [&] { return judged_arcs(*claim, *texts, name); });
      return {said.proven, said.words, result_of(said), &texts->inner};
    }
    const std::string* world = nullptr;
    run.stage("integers", [&] { world = &worlds.text_for(certificate); });
    const proof::Judgement said = run.stage("verify", [&] { return proof::judge(*world, certificate); });
    return {said.proven, said.words, result_of(said), world};
  } catch (const proof::BadInput& error) {
    throw InputError(name, 0, plain_words(error.what()));
  }
}

// Of many about one world: that all are proven, or the first that is not.
int end_of_many(const std::vector<std::string>& certificates, Worlds& worlds, const std::string& name, Run& run) {
  if (certificates.empty()) throw InputError(name, 0, "holds no certificates");
  std::size_t proven = 0;
  std::string fault;
  for (std::size_t i = 0; i < certificates.size(); ++i) {
    const Said said = judged(worlds, certificates[i], name, run);
    proven += said.proven;
    if (!said.proven && fault.empty()) fault = fmt::format("certificate {}: {}", i + 1, said.words);
  }
  Json result{
      {"kind", "batch"}, {"certificates", certificates.size()}, {"proven", proven}, {"displacement", worlds.moved()}};
  return run.end({.outcome = fault.empty() ? Outcome::done : Outcome::invalid,
                  .reason = fault,
                  .result = std::move(result),
                  .line = fmt::format("{}: {} of {} proven{}\n", name, proven, certificates.size(),
                                      fault.empty() ? "" : "; " + fault)});
}

int run(const VerifyOptions& options, Run& run) {
  run.source(options.world.file);
  run.promise(options.integers);
  const Input input = read_input(options.world, run);
  const std::string name = options.certificate == "-" ? "<stdin>" : options.certificate;
  Worlds worlds(input.world, options.robot);
  const std::vector<std::string> all = certificates_in(read_bytes(options.certificate));
  if (all.size() != 1) return end_of_many(all, worlds, name, run);
  Said said = judged(worlds, all.front(), name, run);
  const double moved = worlds.moved();
  said.result["displacement"] = moved;
  const std::string rounded = moved > 0 ? fmt::format(" (obstacles grown by rounding, {:.1g} at most)", moved) : "";
  return run.end({.outcome = said.proven ? Outcome::done : Outcome::invalid,
                  .reason = said.proven ? "" : said.words,
                  .result = std::move(said.result),
                  .line = name + (said.proven ? ": proven: " : ": not proven: ") + said.words + rounded + "\n",
                  .files = {{options.integers, *said.world}}});
}

}  // namespace

Command verify_command(CommandLine& app) {
  return command<VerifyOptions>(app, "verify", "Check a certificate: does it prove what it says?", add_options, run);
}

}  // namespace taut::cli
