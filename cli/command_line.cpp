#include <taut/cli/command_line.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>
#include <type_traits>

namespace taut::cli {

namespace {

// `--quiet,-q`: the long one; of `MAP` that.
std::string chief_name(const std::string& names) {
  for (std::size_t from = 0; from < names.size();) {
    const std::size_t comma = std::min(names.find(',', from), names.size());
    if (names.compare(from, 2, "--") == 0) return names.substr(from, comma - from);
    from = comma + 1;
  }
  return names.substr(0, names.find(','));
}

template <typename Number>
Number whole_number(const std::string& text) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw UsageError("'" + text + "' is not a whole number" + (std::is_unsigned_v<Number> ? " of 0 or more" : ""));
  return value;
}

// A name that every line begins with once, though several hands may have put it there.
std::string with_name(const std::string& name, const std::string& words) {
  return words.starts_with("--") || words.starts_with(name) ? words : name + ": " + words;
}

CommandLine::Take named(const std::string& names, CommandLine::Take take) {
  return [take = std::move(take), name = chief_name(names)](const std::string& text) {
    try {
      take(text);
    } catch (const UsageError& error) {
      throw UsageError(with_name(name, error.what()));
    }
  };
}

std::string in_words(double number) {
  const auto whole = static_cast<long long>(number);
  return static_cast<double>(whole) == number ? std::to_string(whole) : std::to_string(number);
}

// `--quiet`, then `-q`.
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names.empty() ? std::vector{option.get_name()} : names;
}

// Is `Samplers of --sampler:` or `Samplers:` the line above what `--sampler` (or `--samplers`) takes?
bool is_title_of(const std::string& option, std::string line) {
  if (line.ends_with(" of " + option + ":")) return true;
  if (line.empty() || line.back() != ':') return false;
  line.pop_back();
  line.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(line.front())));
  return line == option.substr(std::min<std::size_t>(2, option.size())) ||
         line == option.substr(std::min<std::size_t>(2, option.size())) + "s";
}

// The names that an option takes, a line each below such a title, with what they mean.
std::vector<std::pair<std::string, std::string>> choices_of(const std::string& option, const std::string& footer) {
  std::vector<std::pair<std::string, std::string>> choices;
  bool is_below = false;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ")) {
      is_below = is_title_of(option, line);
      continue;
    }
    const std::size_t gap = std::min(line.find("  ", 2), line.size()), words = line.find_first_not_of(' ', gap);
    const std::string name = line.substr(2, gap - 2);
    if (is_below && name.find(':') == std::string::npos)
      choices.emplace_back(name, words < line.size() ? line.substr(words) : "");
  }
  return choices;
}

DescribedOption described(const CLI::Option& option, const std::string& footer) {
  DescribedOption result{names_of(option), option.get_type_name(), option.get_description(), option.get_group()};
  result.is_operand = option.get_positional();
  result.is_required = option.get_required();
  if (option.get_expected_max() == 0) result.value.clear();  // a flag
  if (!result.is_operand) result.choices = choices_of(result.names.front(), footer);
  return result;
}

DescribedCommand described(const CLI::App& app, const std::string& above) {
  DescribedCommand result;
  result.name = above.empty() ? app.get_name() : above + " " + app.get_name();
  result.what = app.get_description();
  result.footer = app.get_footer();
  result.usage = result.name + " [OPTIONS]";
  for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return !o->get_group().empty(); })) {
    result.options.push_back(described(*option, result.footer));
    if (const DescribedOption& last = result.options.back(); last.is_operand)
      result.usage += last.is_required ? " " + last.names.front() : " [" + last.names.front() + "]";
  }
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    result.below.push_back(described(*sub, result.name));
  if (!result.below.empty()) result.usage += app.get_require_subcommand_min() > 0 ? " SUBCOMMAND" : " [SUBCOMMAND]";
  return result;
}

}  // namespace

Option::Option(CLI::App& app, CLI::Option& option) : app_(&app), option_(&option) {
  if (option.get_positional() || option.get_expected_max() == 0) return;
  const auto check = [&app, name = option.get_name()](std::string& text) -> std::string {
    if (text.starts_with("--") && app.get_option_no_throw(text) != nullptr)
      throw UsageError(name + " needs a value, and " + text + " is an option; a file of that name is ./" + text);
    return {};
  };
  option.check(CLI::Validator(check, ""));
}

Option Option::type_name(const char* name) const {
  option_->type_name(name);
  return *this;
}

Option Option::group(const std::string& name) const {
  option_->group(name);
  return *this;
}

Option Option::required(bool is) const {
  option_->required(is);
  return *this;
}

Option Option::excludes(const char* other) const {
  option_->excludes(app_->get_option(other));
  return *this;
}

Option Option::values(int least, int most) const {
  option_->expected(least, most);
  return *this;
}

Option Option::range(double least, double most) const {
  const std::string name = option_->get_name();
  const auto check = [least, most, name](std::string& text) -> std::string {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size() && !(value >= least && value <= most))
      throw UsageError(name + ": '" + text + "' is not from " + in_words(least) + " to " + in_words(most));
    return {};  // what is no number at all is for the option itself to say
  };
  option_->check(CLI::Validator(check, ""));
  return *this;
}

Option CommandLine::add_option_function(const std::string& names, Take take, const std::string& what) {
  return {*app_, *app_->add_option_function<std::string>(names, named(names, std::move(take)), what)};
}

Option CommandLine::add_each_function(const std::string& names, Take take, const std::string& what) {
  const auto each = [take = named(names, std::move(take))](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) take(text);
  };
  return {*app_, *app_->add_option_function<std::vector<std::string>>(names, each, what)};
}

Option CommandLine::add_option(const std::string& names, std::string& value, const std::string& what) {
  return Option(*app_, *app_->add_option(names, value, what)->type_name(""));
}

Option CommandLine::add_option(const std::string& names, std::vector<std::string>& values, const std::string& what) {
  return Option(*app_, *app_->add_option(names, values, what)->type_name(""));
}

Option CommandLine::add_option(const std::string& names, int& value, const std::string& what) {
  return add_option_function(
      names, [&value](const std::string& text) { value = whole_number<int>(text); }, what);
}

Option CommandLine::add_option(const std::string& names, std::optional<int>& value, const std::string& what) {
  return add_option_function(
      names, [&value](const std::string& text) { value = whole_number<int>(text); }, what);
}

Option CommandLine::add_option(const std::string& names, std::size_t& value, const std::string& what) {
  return add_option_function(
      names, [&value](const std::string& text) { value = whole_number<std::size_t>(text); }, what);
}

Option CommandLine::add_flag(const std::string& names, bool& value, const std::string& what) {
  return Option(*app_, *app_->add_flag(names, value, what));
}

Option CommandLine::add_flag_callback(const std::string& names, std::function<void()> work, const std::string& what) {
  return Option(*app_, *app_->add_flag_callback(names, std::move(work), what));
}

void CommandLine::renamed(const std::string& old_name, const std::string& new_name) {
  const auto refuse = [old_name, new_name](const std::string& value) {
    throw UsageError(old_name + " is " + new_name + " here; did you mean `" + new_name + " " + value + "`?");
  };
  add_option_function(old_name, refuse, "").group("");
}

void CommandLine::callback(std::function<void()> work) {
  checks_.push_back(std::move(work));
  app_->callback([this] {
    for (const auto& check : checks_) check();
  });
}

void CommandLine::footer(const std::string& text) {
  paragraphs_ += text + "\n";
  app_->footer(paragraphs_ + examples_);
}

void CommandLine::example(const std::string& line) {
  examples_ += (examples_.empty() ? "Example:\n  " : "  ") + line + "\n";
  app_->footer(paragraphs_ + examples_);
}

void CommandLine::explain(const std::string& title, const std::vector<Choice>& choices) {
  std::size_t widest = 0;
  for (const Choice& choice : choices) widest = std::max(widest, choice.first.size());
  std::string text = title + ":\n";
  for (const auto& [name, what] : choices)
    text.append("  ").append(name).append(widest + 2 - name.size(), ' ').append(what).append("\n");
  footer(text);
}

std::size_t CommandLine::count(const std::string& name) const { return app_->count(name); }

bool CommandLine::has_subcommand() const { return !app_->get_subcommands().empty(); }

void CommandLine::optional_subcommand() { app_->require_subcommand(0, 1); }

void CommandLine::require_subcommand() { app_->require_subcommand(1); }

CommandLine CommandLine::add_subcommand(const char* name, const char* description) {
  return CommandLine(*app_->add_subcommand(name, description));
}

bool CommandLine::is_chosen() const { return app_->parsed(); }

std::string CommandLine::given_except(const std::vector<std::string>& names) const {
  std::vector<std::string> all;
  for (const CLI::Option* option : app_->get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || option->get_positional() || std::count(names.begin(), names.end(), name) > 0) continue;
    std::string text = name;
    for (const std::string& value : option->results()) text += " " + value;
    all.push_back(text + ";");
  }
  std::sort(all.begin(), all.end());
  std::string text;
  for (const std::string& one : all) text += one;
  return text;
}

DescribedCommand CommandLine::described() const { return cli::described(*app_, ""); }

std::string CommandLine::full_name() const {
  std::string name = app_->get_name();
  for (const CLI::App* up = app_->get_parent(); up != nullptr; up = up->get_parent())
    name.insert(0, up->get_name() + " ");
  return name;
}

}  // namespace taut::cli
