#include <taut/cli/config_file.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include <taut/cli/command_line.h>
#include <taut/geometry/errors.h>
#include <taut/io/worlds/read_world.h>

namespace taut::cli {

namespace {

constexpr std::string_view kConfig = "--config";

// Takes `--config FILE` or `--config=FILE` out of the words.
std::optional<std::string> taken_out(std::vector<std::string>& words) {
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (word->starts_with(std::string(kConfig) + "=")) {
      const std::string name = word->substr(kConfig.size() + 1);
      words.erase(word);
      return name;
    }
    if (*word != kConfig) continue;
    if (word + 1 == words.end()) throw UsageError("--config: which file?");
    const std::string name = word[1];
    words.erase(word, word + 2);
    return name;
  }
  return std::nullopt;
}

// The subcommand that the words name, and its name: `grid`, `solve`.
const CLI::App* chosen(const CLI::App& program, const std::vector<std::string>& words, std::vector<std::string>& path) {
  const CLI::App* at = &program;
  for (const std::string& word : words) {
    const auto named = at->get_subcommands([&](const CLI::App* sub) { return sub->get_name() == word; });
    if (named.empty()) continue;
    at = named.front();
    path.push_back(word);
  }
  return at;
}

bool is_said(const std::vector<std::string>& words, const CLI::Option& option) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return option.check_name(word.substr(0, word.find('='))) && word.starts_with("-");
  });
}

class Settings {
 public:
  Settings(const CLI::App& program, std::string file, std::vector<std::string> words)
      : file_(std::move(file)), words_(std::move(words)), at_(chosen(program, words_, path_)) {}

  std::vector<std::string> added(const std::vector<CLI::ConfigItem>& items) {
    std::vector<std::string> all = words_;
    for (const CLI::ConfigItem& item : items)
      if (item.name != "++" && item.name != "--" && concerns(item)) add(item, all);
    return all;
  }

 private:
  bool concerns(const CLI::ConfigItem& item) const { return item.parents.empty() || item.parents == path_; }

  void add(const CLI::ConfigItem& item, std::vector<std::string>& all) const {
    const std::string name = "--" + item.name;
    const CLI::Option* const option = at_->get_option_no_throw(name);
    if (option == nullptr && item.parents.empty()) return;
    if (option == nullptr) throw UsageError(fmt::format("{}: {} has no option {}", file_, at_->get_name(), name));
    if (is_said(words_, *option)) return;
    if (option->get_expected_max() != 0) {
      all.push_back(name);
      all.insert(all.end(), item.inputs.begin(), item.inputs.end());
    } else if (const std::string value = item.inputs.empty() ? "true" : item.inputs.front(); value == "true") {
      all.push_back(name);
    } else if (value != "false") {
      throw UsageError(fmt::format("{}: {} is true or false, not '{}'", file_, item.name, value));
    }
  }

  std::string file_;
  std::vector<std::string> words_;
  std::vector<std::string> path_;
  const CLI::App* at_;
};

}  // namespace

void add_config_option(CommandLine& app) {
  app.add_option_function(
         "--config", [](const std::string&) {},
         "Take options from here that are not given: `samples = 500`, a line each")
      .type_name("FILE");
}

std::vector<std::string> with_config_file(const CLI::App& program, std::vector<std::string> words) {
  const std::optional<std::string> file = taken_out(words);
  if (!file) return words;
  std::istringstream text(read_bytes(*file));
  try {
    return Settings(program, *file, std::move(words)).added(CLI::ConfigTOML().from_config(text));
  } catch (const CLI::Error& error) {
    throw InputError(*file, 0, error.what());
  }
}

}  // namespace taut::cli
