// taut verify: does a certificate prove what it says?
#include <fmt/format.h>

#include <utility>
#include <vector>

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/input.h>
#include <taut/cli/run.h>
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

proof::Judgement judged(const std::string& world, const std::string& certificate, const std::string& name) {
  try {
    return proof::judge(world, certificate);
  } catch (const proof::BadInput& error) {
    std::string words = error.what();  // some are of the library that reads JSON
    if (const std::size_t begin = words.find("[json.exception."); begin != std::string::npos)
      words.erase(begin, words.find("] ", begin) + 2 - begin);
    throw InputError(name, 0, words);
  }
}

Json result_of(const proof::Judgement& said) {
  Json result{{"kind", said.kind}, {"proven", said.proven}, {"words", said.words}};
  if (!said.proven || (said.kind == "none" && said.bound == 0)) return result;
  if (said.kind == "shortest") result["length"] = static_cast<double>(said.length);
  if (said.kind == "widest") result["keeps"] = static_cast<double>(said.length);
  result["bound"] = static_cast<double>(said.bound);
  return result;
}

// Of many about one world: that all are proven, or the first that is not.
int end_of_many(const std::vector<std::string>& certificates, const std::string& world, const std::string& name,
                double moved, Run& run) {
  if (certificates.empty()) throw InputError(name, 0, "holds no certificates");
  std::size_t proven = 0;
  std::string fault;
  for (std::size_t i = 0; i < certificates.size(); ++i) {
    const proof::Judgement said = run.stage("verify", [&] { return judged(world, certificates[i], name); });
    proven += said.proven;
    if (!said.proven && fault.empty()) fault = fmt::format("certificate {}: {}", i + 1, said.words);
  }
  Json result{{"kind", "batch"}, {"certificates", certificates.size()}, {"proven", proven}, {"displacement", moved}};
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
  const std::string certificate = read_bytes(options.certificate);
  double moved = 0;  // by rounding, where the world is not judged as it was written
  const std::string world = run.stage("integers", [&] {
    if (const auto ends = disc_ends(certificate)) {
      const FreeSpace walled(walled_world(input.world, {(*ends)[1], (*ends)[0]}));
      if (!is_plain(walled.world())) moved = walled.report().displacement;
      return write_plain_integers(plain_world(walled));
    }
    if (is_plain(input.world, options.robot)) return write_plain_integers(input.world);
    const FreeSpace space(input.world, options.robot);
    moved = space.report().displacement;
    return write_plain_integers(plain_world(space));
  });
  const std::vector<std::string> all = certificates_in(certificate);
  if (all.size() != 1) return end_of_many(all, world, name, moved, run);
  const proof::Judgement said = run.stage("verify", [&] { return judged(world, all.front(), name); });
  Json result = result_of(said);
  result["displacement"] = moved;
  const std::string rounded = moved > 0 ? fmt::format(" (obstacles grown by rounding, {:.1g} at most)", moved) : "";
  return run.end({.outcome = said.proven ? Outcome::done : Outcome::invalid,
                  .reason = said.proven ? "" : said.words,
                  .result = std::move(result),
                  .line = name + (said.proven ? ": proven: " : ": not proven: ") + said.words + rounded + "\n",
                  .files = {{options.integers, world}}});
}

}  // namespace

Command verify_command(CommandLine& app) {
  return command<VerifyOptions>(app, "verify", "Check a certificate: does it prove what it says?", add_options, run);
}

}  // namespace taut::cli
