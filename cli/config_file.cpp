#include <taut/cli/config_file.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include <taut/cli/command_line.h>
#include <taut/cli/settings.h>
#include <taut/cli/spelling.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

namespace {

constexpr std::string_view kConfig = "--config";

// Takes `--config FILE` or `--config=FILE` out of the words.
std::optional<std::string> taken_out(std::vector<std::string>& words) {
  std::optional<std::string> name;
  const auto take = [&](const std::string& file) {
    if (name) throw UsageError(fmt::format("--config: '{}' and '{}': one file is enough", *name, file));
    name = file;
  };
  for (auto word = words.begin(); word != words.end() && *word != "--";) {
    if (word->starts_with(std::string(kConfig) + "=")) {
      take(word->substr(kConfig.size() + 1));
      word = words.erase(word);
    } else if (*word == kConfig) {
      if (word + 1 == words.end()) throw UsageError("--config: which file?");
      take(word[1]);
      word = words.erase(word, word + 2);
    } else {
      ++word;
    }
  }
  return name;
}

// The subcommand that the words name, and its name as a section: `grid.solve`.
const CLI::App* chosen(const CLI::App& program, const std::vector<std::string>& words, std::string& section) {
  const CLI::App* at = &program;
  for (const std::string& word : words) {
    const auto named = at->get_subcommands([&](const CLI::App* sub) { return sub->get_name() == word; });
    if (named.empty()) continue;
    at = named.front();
    section += (section.empty() ? "" : ".") + word;
  }
  return at;
}

bool is_said(const std::vector<std::string>& words, const CLI::Option& option) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return option.check_name(word.substr(0, word.find('='))) && word.starts_with("-");
  });
}

// ---- does all this exist? -----------------------------------------------------------------------

using Names = std::set<std::string, std::less<>>;  // of options, without dashes

// By section, the names of its options; "" has them all.
std::map<std::string, Names> names_by_section(const DescribedCommand& program) {
  std::map<std::string, Names> sections;
  const auto visit = [&](const auto& self, const DescribedCommand& command, const std::string& section) -> void {
    sections.try_emplace(section);  // `grid` holds others, and has no option itself
    for (const DescribedOption& option : command.options)
      for (const std::string& name : option.names) {
        if (!name.starts_with("--") || name == "--help" || name == "--version" || name == kConfig) continue;
        sections[section].insert(name.substr(2));
        sections[""].insert(name.substr(2));
      }
    for (const DescribedCommand& below : command.below) {
      const std::string name = below.name.substr(below.name.rfind(' ') + 1);
      self(self, below, section.empty() ? name : fmt::format("{}.{}", section, name));
    }
  };
  visit(visit, program, "");
  return sections;
}

std::string place_of(const Setting& setting, const std::string& file) {
  return fmt::format("{}:{}", file, setting.line);
}

// `taut grid solve`
std::string full_name(std::string section) {
  std::replace(section.begin(), section.end(), '.', ' ');
  return "taut " + section;
}

void require_known(const std::vector<Setting>& settings, const std::map<std::string, Names>& sections,
                   const std::string& file) {
  for (const Setting& setting : settings) {
    const std::string place = place_of(setting, file);
    const auto section = sections.find(setting.section);
    if (section == sections.end()) {
      std::vector<std::string_view> names;
      names.reserve(sections.size());
      for (const auto& known : sections) names.push_back(known.first);
      throw UsageError(
          fmt::format("{}: [{}] is no subcommand{}", place, setting.section, meant(setting.section, names)));
    }
    if (section->second.contains(setting.name)) continue;
    const std::vector<std::string_view> names(section->second.begin(), section->second.end());
    const std::string who = setting.section.empty() ? "no subcommand has an" : full_name(setting.section) + " has no";
    throw UsageError(fmt::format("{}: {} option {}{}", place, who, setting.name, meant(setting.name, names)));
  }
}

// ---- as words -----------------------------------------------------------------------------------

class Added {
 public:
  Added(const CLI::App& program, std::vector<std::string> words, std::string file)
      : file_(std::move(file)), said_(std::move(words)), at_(chosen(program, said_, section_)) {}

  // What stands in the section first, for it overrules.
  Words of(const std::vector<Setting>& settings) && {
    for (const Setting& setting : settings)
      if (!section_.empty() && setting.section == section_) add(setting);
    for (const Setting& setting : settings)
      if (setting.section.empty() && !places_.contains("--" + setting.name)) add(setting);
    said_.insert(std::find(said_.begin(), said_.end(), "--"), added_.begin(), added_.end());
    return {std::move(said_), std::move(places_)};
  }

 private:
  void add(const Setting& setting) {
    const std::string name = "--" + setting.name, place = place_of(setting, file_);
    const CLI::Option* const option = at_->get_option_no_throw(name);
    if (option == nullptr || is_said(said_, *option)) return;
    places_.emplace(name, place);
    // A flag, or `--animate`, which may stand alone.
    if (option->get_expected_min() == 0 && setting.is_word &&
        (setting.values[0] == "true" || setting.values[0] == "false")) {
      if (setting.values[0] == "true") added_.push_back(name);
      return;
    }
    const std::string shown = fmt::format("{}", fmt::join(setting.values, ", "));
    if (option->get_expected_max() == 0)
      throw UsageError(fmt::format("{}: {} is true or false, not '{}'", place, setting.name, shown));
    if (setting.values.size() != 1 && option->get_expected_max() == 1)
      throw UsageError(fmt::format("{}: {} has one value, not [{}]", place, setting.name, shown));
    for (const std::string& value : setting.values) added_.push_back(fmt::format("{}={}", name, value));
  }

  std::string file_, section_;
  std::vector<std::string> said_, added_;
  const CLI::App* at_;
  Places places_;
};

}  // namespace

void add_config_option(CommandLine& app) {
  app.add_option_function(
         "--config", [](const std::string&) {},
         "Take options from here that are not given: `samples = 500`, a line each")
      .type_name("FILE");
}

Words with_config_file(const CLI::App& program, std::vector<std::string> words,
                       const std::function<DescribedCommand()>& all) {
  const std::optional<std::string> file = taken_out(words);
  if (!file) return {std::move(words), {}};
  const std::vector<Setting> settings = settings_of(read_bytes(*file), *file == "-" ? "<stdin>" : *file);
  require_known(settings, names_by_section(all()), *file);
  return Added(program, std::move(words), *file).of(settings);
}

std::string with_place(const std::string& complaint, const Places& places) {
  std::istringstream words(complaint);
  for (std::string word; words >> word;) {
    word.erase(word.find_last_not_of(":,;") + 1);
    const auto option = places.find(word);
    if (option != places.end()) return option->second + ": " + complaint;
  }
  return complaint;
}

}  // namespace taut::cli
