#include <taut/cli/command.h>

namespace taut::cli {

CommandLine command_group(CommandLine& app, const char* name, const char* description) {
  CommandLine group = app.add_subcommand(name, description);
  group.require_subcommand();
  return group;
}

}  // namespace taut::cli
