#include <taut/io/results/envelope.h>

#include <array>
#include <cmath>

namespace taut {

namespace {

struct Ending {
  std::string_view name;
  int exit_code;
};

constexpr std::array<Ending, 8> kEndings{{{"found", 0},
                                          {"done", 0},
                                          {"none", 1},
                                          {"differs", 1},
                                          {"invalid", 1},
                                          {"refused", 3},
                                          {"stopped", 4},
                                          {"unproven", 4}}};

const Ending& ending(Outcome outcome) { return kEndings[static_cast<std::size_t>(outcome)]; }

double in_microseconds(double seconds) { return std::round(seconds * 1e6) / 1e6; }

Json json_of(const Seconds& seconds) {
  return {{"cpu", in_microseconds(seconds.cpu)}, {"wall", in_microseconds(seconds.wall)}};
}

Json reason_of(const Envelope& envelope) {
  if (envelope.reason.empty()) return nullptr;
  return envelope.stage.empty() ? envelope.reason : envelope.reason + " (in stage `" + envelope.stage + "`)";
}

Json seconds_of(const Envelope& envelope) {
  Json json{{"total", json_of(envelope.total)}};
  for (const StageTime& stage : envelope.stages) json[stage.stage] = json_of(stage.seconds);
  return json;
}

}  // namespace

std::string_view name(Outcome outcome) { return ending(outcome).name; }

int exit_code(Outcome outcome) { return ending(outcome).exit_code; }

std::string envelope_text(const Envelope& envelope) {
  return json_text({{"program", "taut"},
                    {"version", envelope.version},
                    {"command", envelope.command},
                    {"source", envelope.source},
                    {"status", name(envelope.outcome)},
                    {"reason", reason_of(envelope)},
                    {"seconds", seconds_of(envelope)},
                    {"result", envelope.result}});
}

}  // namespace taut
