#include <taut/cli/program.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include <taut/cli/config_file.h>
#include <taut/cli/spelling.h>
#include <taut/cli/version.h>

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

std::vector<std::string_view> names_below(const CLI::App& app) {
  std::vector<std::string_view> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

// Words that nobody wants: of an option, what may have been meant.
std::string stray(const CLI::App& at, const std::vector<std::string>& words) {
  const auto option = std::find_if(words.begin(), words.end(), [](const auto& word) { return word.starts_with("-"); });
  if (option == words.end()) return fmt::format("'{}' is a word too many", words.front());
  const std::string name = option->substr(0, option->find('='));
  std::vector<std::string> names;
  for (const CLI::Option* known : at.get_options())
    if (!known->get_group().empty())
      for (const std::string& one : known->get_lnames()) names.push_back("--" + one);
  const bool is_long = name.starts_with("--");
  return fmt::format("there is no option {}{}", name, is_long ? meant(name, {names.begin(), names.end()}) : "");
}

// `--seed: 1 required N missing`, `--json: At Most 1 required but received 2`: a number of values that cannot be.
std::string with_count(const std::string& words) {
  static constexpr std::string_view kMissing = ": 1 required ", kMany = ": At Most 1 required but received ";
  if (const std::size_t colon = words.find(kMany); colon != std::string::npos)
    return fmt::format("{} is given {} times", words.substr(0, colon), words.substr(colon + kMany.size()));
  const std::size_t colon = words.find(kMissing), end = words.rfind(" missing"), value = colon + kMissing.size();
  if (colon == std::string::npos || end == std::string::npos) return words;
  return fmt::format("{} needs a value, {}", words.substr(0, colon), words.substr(value, end - value));
}

// CLI11's words, except where there is a better one, or a name to blame.
std::string reason(const CLI::App& at, const CLI::ParseError& error) {
  const std::vector<std::string> rest = at.remaining();
  if (at.get_require_subcommand_min() > 0) {
    std::vector<std::string_view> names = names_below(at);
    if (rest.empty()) return fmt::format("which of {}?", fmt::join(names, ", "));
    names.insert(names.end(), {"--help", "--version"});
    return fmt::format("there is no subcommand or option '{}'{}", rest.front(), meant(rest.front(), names));
  }
  const bool is_option = std::any_of(rest.begin(), rest.end(), [](const auto& word) { return word.starts_with("-"); });
  if (is_option || (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !rest.empty())) return stray(at, rest);
  return with_count(error.what());
}

UsageError wrong(const CLI::App& at, const std::string& why) {
  return UsageError(fmt::format("{}; see `{} --help`", why, full_name(at)));
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

using Commands = std::vector<Command>;

// One subcommand, or a group, like `grid`, that brings several.
struct Adder {
  std::string_view name;
  Command (*one)(CommandLine& app);
  Commands (*several)(CommandLine& app);
};

// In the order of --help.
constexpr Adder kAdders[] = {{"solve", solve_command, nullptr},     {"view", view_command, nullptr},
                             {"check", check_command, nullptr},     {"verify", verify_command, nullptr},
                             {"audit", audit_command, nullptr},     {"roadmap", roadmap_command, nullptr},
                             {"compare", compare_command, nullptr}, {"passage", passage_command, nullptr},
                             {"reach", reach_command, nullptr},     {"generate", generate_command, nullptr},
                             {"convert", convert_command, nullptr}, {"space", space_command, nullptr},
                             {"batch", batch_command, nullptr},     {"matrix", matrix_command, nullptr},
                             {"grid", nullptr, grid_commands},      {"diff", diff_command, nullptr},
                             {"mouse", nullptr, mouse_commands},    {"chase", nullptr, chase_commands},
                             {"bug", nullptr, bug_commands},        {"drive", drive_command, nullptr}};

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

// All of them, described, for which a program of their own is made.
DescribedCommand all_commands() {
  CLI::App app("", "taut");
  CommandLine line(app);
  const Commands commands = commands_for("", line);
  return line.described();
}

// What is to be printed; nothing where a subcommand is to be run. Sets where options stand that a file brought.
std::optional<std::string> read_words(CLI::App& app, std::vector<std::string> said, Places& places) {
  try {
    auto [words, from_file] = with_config_file(app, std::move(said), all_commands);
    places = std::move(from_file);
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    app.parse(std::move(words));
    refuse_stray_options(chosen(app));
    return std::nullopt;
  } catch (const CLI::CallForVersion& version) {
    return std::string(version.what()) + "\n";
  } catch (const CLI::CallForAllHelp&) {
    return app.help("", CLI::AppFormatMode::All);
  } catch (const CLI::CallForHelp&) {
    return app.help();
  } catch (const CLI::ParseError& error) {
    throw wrong(chosen(app), with_place(reason(chosen(app), error), places));
  } catch (const UsageError& error) {
    throw wrong(chosen(app), with_place(error.what(), places));
  }
}

// `taut grid solve --version`, too. Not in every --help: it is in the program's.
void add_version_flag(CLI::App& app) {
  app.set_version_flag("--version,-V", version_text(), "Print the version and exit, what it is made of below it")
      ->group(app.get_parent() == nullptr ? "Options" : "");
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) add_version_flag(*sub);
}

// What stands after `help` is for help() to read.
void describe_help(CommandLine& app) {
  CommandLine line = app.add_subcommand("help", "Print the help of a subcommand: taut help grid solve");
  const auto nothing = [](const std::string&) {};
  line.add_each_function("SUBCOMMAND", nothing, "Of which; default: of the program").type_name("");
  line.add_option_function("--as", nothing, "Print what these read instead, see below").type_name("KIND");
  line.explain("Kinds of --as", {{"man", "a page of the manual: taut help solve --as man | man -l -"},
                                 {"bash", "completions, to be sourced"},
                                 {"zsh", "likewise, as _taut in a folder of fpath"},
                                 {"fish", "likewise, as taut.fish in ~/.config/fish/completions"}});
}

// `taut help`, `taut help grid solve`; with `--as man` as manual page, with `--as bash` what that shell completes.
std::string help(const CommandLine& line, std::vector<std::string> words) {
  std::string as;
  if (const auto option = std::find(words.begin(), words.end(), "--as"); option != words.end()) {
    if (option + 1 == words.end()) throw wrong(line.app(), "--as: which of man, bash, zsh, fish?");
    as = option[1];
    words.erase(option, option + 2);
  }
  std::erase_if(words, [](const std::string& word) { return word == "--help" || word == "-h"; });
  const CLI::App* at = &line.app();
  DescribedCommand described = line.described();
  for (const std::string& word : words) {
    const auto named = at->get_subcommands([&](const CLI::App* sub) { return sub->get_name() == word; });
    if (named.empty())
      throw wrong(*at, fmt::format("there is no subcommand '{}'{}", word, meant(word, names_below(*at))));
    at = named.front();
    const auto is_it = [&](const DescribedCommand& below) { return below.name == described.name + " " + word; };
    described = DescribedCommand(*std::find_if(described.below.begin(), described.below.end(), is_it));
  }
  if (as == "man") return manual_page(described, TAUT_VERSION);
  if (is_shell(as) && words.empty()) return completion_script(described, as);
  if (is_shell(as)) throw wrong(line.app(), fmt::format("--as {} is for all subcommands, not one", as));
  if (!as.empty()) throw wrong(line.app(), fmt::format("--as: '{}' is none of man, bash, zsh, fish", as));
  return at->help(at->get_parent() == nullptr ? "" : full_name(*at->get_parent()));
}

}  // namespace

struct Program::Impl {
  void add_commands(std::string_view first_word);

  CLI::App app{"Exact motion planning in the plane: shortest paths, or the walls that leave none.", "taut"};
  CommandLine line{app};
  std::vector<Command> commands;
};

void Program::Impl::add_commands(std::string_view first_word) {
  commands = commands_for(first_word, line);
  describe_help(line);
  add_version_flag(app);
}

Program::Program() : impl_(std::make_unique<Impl>()) {
  CLI::App& app = impl_->app;
  app.set_help_flag("--help,-h", "Print this help and exit");
  app.require_subcommand(1);
  app.footer(kFooter);
}

Program::~Program() = default;

Asked Program::parse(std::vector<std::string> words) {
  impl_->add_commands(words.empty() ? "" : words.front());
  if (!words.empty() && words.front() == "help") return {nullptr, help(impl_->line, {words.begin() + 1, words.end()})};
  Places places;
  if (auto text = read_words(impl_->app, std::move(words), places)) return {nullptr, *std::move(text)};
  for (Command& command : impl_->commands) {
    if (!command.line->is_chosen()) continue;
    command.places = std::move(places);
    return {&command};
  }
  throw wrong(impl_->app, "which subcommand?");
}

UsageError wrong_usage(const Command& command, const std::string& why) {
  return wrong(command.line->app(), with_place(why, command.places));
}

}  // namespace taut::cli
