#include <taut/cli/described.h>

#include <fmt/format.h>

#include <algorithm>

namespace taut::cli {

namespace {

std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

bool is_long(const std::string& name) { return name.starts_with("--"); }

/// All names of the options, or of what is below, with blanks between.
std::string option_names(const DescribedCommand& command) {
  std::string words;
  for (const DescribedOption& option : command.options)
    for (const std::string& name : option.names)
      if (!option.is_operand) words += name + " ";
  return words;
}

std::string names_below(const DescribedCommand& command) {
  std::string words;
  for (const DescribedCommand& below : command.below) words += last_word(below.name) + " ";
  return words;
}

std::string choice_names(const DescribedOption& option) {
  std::string words;
  for (const auto& choice : option.choices) words += choice.first + " ";
  return words;
}

template <typename Visit>
void each(const DescribedCommand& command, const Visit& visit) {
  visit(command);
  for (const DescribedCommand& below : command.below) each(below, visit);
}

// ---- bash ---------------------------------------------------------------------------------------

constexpr const char* kBash = R"(# bash completion of taut
_taut() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD - 1]}} at=taut word options below files help=''
  COMPREPLY=()
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$at $word" in
      'taut help') help='taut help' ;;  # what follows taut may follow that
{paths}    esac
  done
  case "${{help:-$at}} $prev" in
{values}  esac
  case $at in
{words}  esac
  if [[ -n $help ]]; then options='--as --help' files=''; fi
  if [[ $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
  else
    mapfile -t COMPREPLY < <(compgen -W "$below" -- "$cur"; [[ -z $files ]] || compgen -f -- "$cur")
  fi
}}
complete -o filenames -F _taut taut
)";

std::string bash(const DescribedCommand& program) {
  std::string paths, values, words;
  each(program, [&](const DescribedCommand& command) {
    if (command.name != program.name) paths += fmt::format("      '{0}') at='{0}' ;;\n", command.name);
    words += fmt::format("    '{}') options='{}' below='{}' files={} ;;\n", command.name, option_names(command),
                         names_below(command), command.needs_below() ? "" : "yes");
    for (const DescribedOption& option : command.options) {
      if (option.value.empty()) continue;
      std::string patterns;
      for (const std::string& name : option.names)
        patterns += (patterns.empty() ? "'" : " | '") + command.name + " " + name + "'";
      const std::string what =
          option.choices.empty() ? (option.is_file() ? "-f" : "-W ''") : "-W '" + choice_names(option) + "'";
      values += fmt::format("    {}) mapfile -t COMPREPLY < <(compgen {} -- \"$cur\"); return ;;\n", patterns, what);
    }
  });
  return fmt::format(kBash, fmt::arg("paths", paths), fmt::arg("values", values), fmt::arg("words", words));
}

// ---- zsh ----------------------------------------------------------------------------------------

// Within single quotes, and where brackets and colons end the description.
std::string zsh_words(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      out.append("\\").append(1, c);
    else
      out += c;
  }
  return out;
}

std::string zsh_function(const std::string& name) {
  std::string words = "_" + name;
  std::replace(words.begin(), words.end(), ' ', '_');
  return words;
}

std::string zsh_value(const DescribedOption& option) {
  if (option.value.empty()) return "";
  if (!option.choices.empty()) return ":" + zsh_words(option.value) + ":(" + choice_names(option) + ")";
  return ":" + zsh_words(option.value) + ":" + (option.is_file() ? "_files" : " ");
}

std::string zsh_options(const DescribedCommand& command) {
  std::string text;
  for (const DescribedOption& option : command.options)
    for (const std::string& name : option.names)
      if (!option.is_operand)
        text += fmt::format(" \\\n    '{}[{}]{}'", name, zsh_words(option.what), zsh_value(option));
  return text;
}

std::string zsh_list(const DescribedCommand& command) {
  std::string text;
  for (const DescribedCommand& below : command.below)
    text += fmt::format(" \\\n      '{}:{}'", last_word(below.name), zsh_words(below.what));
  return text;
}

std::string zsh_branches(const DescribedCommand& command) {
  std::string text;
  for (const DescribedCommand& below : command.below)
    text += fmt::format("        {}) {} ;;\n", last_word(below.name),
                        zsh_function(below.name == "taut help" ? "taut" : below.name));
  return text;
}

std::string zsh(const DescribedCommand& program) {
  std::string text = "#compdef taut\n\n";
  each(program, [&](const DescribedCommand& command) {
    text += zsh_function(command.name) + "() {\n";
    if (command.below.empty()) {
      text += "  _arguments -S" + zsh_options(command) + " \\\n    '*:file:_files'\n}\n\n";
      return;
    }
    text += "  local -a below\n  local state line\n";
    text += "  _arguments -C" + zsh_options(command) + " \\\n    '1: :->below' '*:: :->rest'\n";
    text += "  case $state in\n    below)\n      below=(" + zsh_list(command) + ")\n      _describe subcommand below\n";
    text += command.needs_below() ? "" : "      _files\n";
    text += "      ;;\n    rest)\n      case $line[1] in\n" + zsh_branches(command) +
            "        *) _files ;;\n      esac\n      ;;\n  esac\n}\n\n";
  });
  return text + "_taut \"$@\"\n";
}

// ---- fish ---------------------------------------------------------------------------------------

std::string fish_words(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out;
}

constexpr const char* kFish = R"(# fish completion of taut
function __taut_at
    set -l at
    for word in (commandline -opc)[2..-1]
        string match -q -- '-*' $word; and continue
        test $word = help; and continue
        contains -- (string trim -- "$at $word") $__taut_commands; and set at (string trim -- "$at $word")
    end
    test "$at" = "$argv"
end
)";

std::string fish_option(const DescribedOption& option, const std::string& at) {
  std::string text = at == "help" ? "complete -c taut -n 'contains help (commandline -opc)'"
                                  : fmt::format("complete -c taut -n '__taut_at {}'", at);
  for (const std::string& name : option.names)
    text += is_long(name) ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty()) text += option.is_file() ? " -r" : " -x";
  if (!option.choices.empty()) text += " -a '" + choice_names(option) + "'";
  return text + " -d '" + fish_words(option.what) + "'\n";
}

std::string fish(const DescribedCommand& program) {
  std::string names, lines;
  each(program, [&](const DescribedCommand& command) {
    const std::string at = command.name == program.name ? "" : command.name.substr(program.name.size() + 1);
    if (!at.empty()) names += " '" + at + "'";
    for (const DescribedCommand& below : command.below)
      lines += fmt::format("complete -c taut -f -n '__taut_at {}' -a {} -d '{}'\n", at, last_word(below.name),
                           fish_words(below.what));
    for (const DescribedOption& option : command.options)
      if (!option.is_operand) lines += fish_option(option, at);
  });
  return "set -g __taut_commands" + names + "\n" + kFish + lines;
}

}  // namespace

bool is_shell(const std::string& name) { return name == "bash" || name == "zsh" || name == "fish"; }

std::string completion_script(const DescribedCommand& program, const std::string& shell) {
  return shell == "bash" ? bash(program) : shell == "zsh" ? zsh(program) : fish(program);
}

}  // namespace taut::cli
