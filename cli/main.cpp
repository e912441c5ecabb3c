// The program `taut`: parses the command line, runs a subcommand, turns what is thrown into a line and an exit code.
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <exception>
#include <iterator>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <taut/cli/command.h>
#include <taut/cli/command_line.h>
#include <taut/cli/config_file.h>
#include <taut/cli/messages.h>
#include <taut/cli/output.h>
#include <taut/cli/ranks.h>
#include <taut/cli/run.h>
#include <taut/cli/stop.h>
#include <taut/cli/version.h>
#include <taut/geometry/errors.h>

namespace taut::cli {

namespace {

constexpr const char* kFooter =
    "Results go to standard output, everything else to stderr. Exit codes: 0 found, 1 there is no path (proven), 2 "
    "wrong usage,\n"
    "3 wrong input, 4 stopped by a limit or an interrupt, 70 a defect of the program.\n\n"
    "  taut generate --size 45x45 --seed 1 | taut solve - --svg maze.svg\n";

// The subcommand that was chosen, as far down as the words go.
const CLI::App& chosen(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : chosen(*parsed.front());
}

// `taut grid solve`
std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name() : full_name(*app.get_parent()) + " " + app.get_name();
}

// `solve, check, roadmap`
std::string choices(const CLI::App& app) {
  std::string names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names += (names.empty() ? "" : ", ") + sub->get_name();
  return names;
}

// CLI11's words, except where there is no subcommand to blame.
std::string reason(const CLI::App& at, const CLI::ParseError& error) {
  if (at.get_require_subcommand_min() == 0) return error.what();
  const std::vector<std::string> rest = at.remaining();
  return rest.empty() ? fmt::format("which of {}?", choices(at))
                      : fmt::format("there is no subcommand or option '{}'", rest.front());
}

int wrong_usage(const CLI::App& at, const std::string& why) {
  complain(fmt::format("{}; see `{} --help`", why, full_name(at)));
  return kUsage;
}

// `taut chase --online compare MAP`: what stands before `compare` would be without effect.
void refuse_stray_options(const CLI::App& at) {
  const CLI::App* const parent = at.get_parent();
  if (parent == nullptr) return;
  for (const CLI::Option* option : parent->get_options())
    if (option->count() > 0)
      throw UsageError(option->get_name() + " stands before `" + at.get_name() + "`, which knows nothing of it");
  refuse_stray_options(*parent);
}

int parse(CLI::App& app, int argc, char** argv) {
  try {
    std::vector<std::string> words = with_config_file(app, {argv + 1, argv + argc});
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    app.parse(std::move(words));
    refuse_stray_options(chosen(app));
    return -1;
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
    return kFound;
  } catch (const CLI::CallForAllHelp&) {
    print(app.help("", CLI::AppFormatMode::All));
    return kFound;
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return kFound;
  } catch (const CLI::ParseError& error) {
    return wrong_usage(chosen(app), reason(chosen(app), error));
  } catch (const UsageError& error) {
    return wrong_usage(chosen(app), error.what());
  }
}

using Commands = std::vector<Command>;

// One subcommand, or a group, like `grid`, that brings several.
struct Adder {
  std::string_view name;
  Command (*one)(CommandLine& app);
  Commands (*several)(CommandLine& app);
};

// In the order of --help.
constexpr Adder kAdders[] = {{"solve", solve_command, nullptr},       {"check", check_command, nullptr},
                             {"verify", verify_command, nullptr},     {"audit", audit_command, nullptr},
                             {"roadmap", roadmap_command, nullptr},   {"compare", compare_command, nullptr},
                             {"passage", passage_command, nullptr},   {"reach", reach_command, nullptr},
                             {"generate", generate_command, nullptr}, {"convert", convert_command, nullptr},
                             {"space", space_command, nullptr},       {"batch", batch_command, nullptr},
                             {"matrix", matrix_command, nullptr},     {"grid", nullptr, grid_commands},
                             {"diff", diff_command, nullptr},         {"mouse", nullptr, mouse_commands},
                             {"chase", nullptr, chase_commands},      {"bug", nullptr, bug_commands},
                             {"drive", drive_command, nullptr}};

// All of them; only the first word's where that names one, none where it needs none: the others' hundreds of options
// take longer than many an answer.
Commands commands_for(std::string_view first_word, CommandLine& app) {
  const bool is_one =
      std::any_of(std::begin(kAdders), std::end(kAdders), [&](const Adder& adder) { return adder.name == first_word; });
  Commands commands;
  if (first_word == "--version" || first_word == "-V") return commands;
  for (const Adder& adder : kAdders) {
    if (is_one && adder.name != first_word) continue;
    if (adder.one != nullptr) commands.push_back(adder.one(app));
    if (adder.several != nullptr)
      for (Command& command : adder.several(app)) commands.push_back(std::move(command));
  }
  return commands;
}

// `taut grid solve --version`, too. Not in every --help: it is in the program's.
void add_version_flag(CLI::App& app) {
  app.set_version_flag("--version,-V", version_text(), "Print the version and exit, what it is made of below it")
      ->group(app.get_parent() == nullptr ? "Options" : "");
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) add_version_flag(*sub);
}

// `taut help`, `taut help grid solve`; with `--as man` as manual page, with `--as bash` what that shell completes.
int help(CommandLine& line, std::vector<std::string> words) {
  std::string as;
  if (const auto option = std::find(words.begin(), words.end(), "--as"); option != words.end()) {
    if (option + 1 == words.end()) return wrong_usage(line.app(), "--as: which of man, bash, zsh, fish?");
    as = option[1];
    words.erase(option, option + 2);
  }
  const CLI::App* at = &line.app();
  DescribedCommand described = line.described();
  for (const std::string& word : words) {
    const auto named = at->get_subcommands([&](const CLI::App* sub) { return sub->get_name() == word; });
    if (named.empty()) return wrong_usage(*at, fmt::format("there is no subcommand '{}'", word));
    at = named.front();
    const auto is_it = [&](const DescribedCommand& below) { return below.name == described.name + " " + word; };
    described = DescribedCommand(*std::find_if(described.below.begin(), described.below.end(), is_it));
  }
  if (as == "man")
    print(manual_page(described, TAUT_VERSION));
  else if (is_shell(as) && words.empty())
    print(completion_script(described, as));
  else if (!as.empty())
    return wrong_usage(line.app(), fmt::format("--as: '{}' is none of man, bash, zsh, fish", as));
  else
    print(at->help(at->get_parent() == nullptr ? "" : full_name(*at->get_parent())));
  return kFound;
}

int run(const Command& command) {
  try {
    if (command.common->ranks) join_ranks(*command.common);
  } catch (const UsageError& error) {
    return wrong_usage(command.line->app(), error.what());
  }
  Run run(command.line->full_name().substr(std::string_view("taut ").size()), *command.common);
  start_watch(command.common->limits);
  try {
    return command.run(run);
  } catch (const InputError& error) {
    complain(error.what());
    return run.refuse(error.what());
  } catch (const UsageError& error) {  // what only the work itself could find out
    return wrong_usage(command.line->app(), error.what());
  }
}

// Large vectors that come and go get the same pages again: on worlds of a million walls a tenth of the time is spent on
// fresh ones. What is no longer needed goes back when the program ends.
void keep_pages() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 25);  // the largest that is allowed; what is larger would leave holes
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, 1 << 24);
#endif
}

int run(int argc, char** argv) {
  keep_pages();
  CLI::App app("Exact motion planning in the plane: shortest paths, or the walls that leave none.", "taut");
  app.set_help_flag("--help,-h", "Print this help and exit");
  app.require_subcommand(1);
  CommandLine line(app);
  const Commands commands = commands_for(argc > 1 ? argv[1] : "", line);
  app.add_subcommand("help",
                     "Print the help of a subcommand: taut help grid solve; --as man, bash, zsh or fish: for these");
  app.footer(kFooter);
  add_version_flag(app);
  if (argc > 1 && std::string_view(argv[1]) == "help") return help(line, {argv + 2, argv + argc});
  if (const int code = parse(app, argc, argv); code >= 0) return code;
  for (const Command& command : commands)
    if (command.line->is_chosen()) return run(command);
  return kUsage;
}

[[noreturn]] void refused(const std::system_error& error) noexcept {
  stop(error.code() == std::errc::resource_unavailable_try_again ? "no further thread can be started" : error.what());
}

// A std::system_error is the operating system's refusal: no further thread, no file handle.
int guarded(int argc, char** argv) noexcept {
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    complain(error.what());
    return kInput;
  } catch (const WriteError& error) {
    complain(error.what());
    return kStopped;
  } catch (const std::bad_alloc&) {
    stop("out of memory");
  } catch (const std::system_error& error) {
    refused(error);
  } catch (const std::exception& error) {
    complain(std::string("internal error: ").append(error.what()));
    return kInternal;
  } catch (...) {
    complain("internal error");
    return kInternal;
  }
}

// Where an exception cannot be thrown further, as in a callback of a C library.
[[noreturn]] void end_badly() noexcept {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    stop("out of memory");
  } catch (const std::system_error& error) {
    refused(error);
  } catch (const std::exception& error) {
    complain(error.what());
  } catch (...) {
  }
  complain("internal error: ended in a place that cannot fail");
  ::_exit(kInternal);
}

}  // namespace

}  // namespace taut::cli

int main(int argc, char** argv) {
  std::set_terminate(taut::cli::end_badly);
  const int code = taut::cli::guarded(argc, argv);
  taut::cli::leave_ranks(code);
  return code;
}
