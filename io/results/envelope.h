// What every result of the program is wrapped in.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <taut/io/results/json.h>
#include <taut/search/stopwatch.h>

namespace taut {

/// How a run ended. The exit code says the same, coarser.
enum class Outcome : std::uint8_t {
  found,     ///< a path, a plan, a passage: exit 0
  done,      ///< what is no search came to its end: exit 0
  none,      ///< there is none, proven: exit 1
  differs,   ///< two things that were compared are not the same: exit 1
  invalid,   ///< what was to be checked does not hold: exit 1
  refused,   ///< the input is wrong: exit 3
  stopped,   ///< a limit or an interrupt came first: exit 4; what is finished is in the result
  unproven,  ///< none was found, which proves nothing, or found without the proof that was asked for: exit 4
};

/// `found`, `done`, ...
std::string_view name(Outcome outcome);
/// 0, 1, 3 or 4 as above.
int exit_code(Outcome outcome);

struct StageTime {
  std::string stage;
  Seconds seconds;
};

/// The envelope. `docs/schemas/envelope.schema.json` is its schema.
struct Envelope {
  std::string version;  ///< of the program
  std::string command;  ///< `solve`, `grid compare`
  std::string source;   ///< the input as named on the command line, `<stdin>`; several: joined by spaces; may be empty
  Outcome outcome = Outcome::done;
  std::string reason;             ///< why it is not found or done; else empty
  std::string stage;              ///< when stopped: in which stage
  std::vector<StageTime> stages;  ///< those that were finished, in order; of the same name: added up
  Seconds total;
  Json result;  ///< the subcommand's own; null when it came to nothing
};

/// One JSON object: `program`, `version`, `command`, `source`, `status`, `reason` (null where there is none; when
/// stopped it names the stage too), `seconds` {"total": {"cpu", "wall"}, STAGE: {"cpu", "wall"}, ...}, `result`. Keys
/// are stable within a major version. Laid out as json_text().
std::string envelope_text(const Envelope& envelope);

}  // namespace taut
