#include <taut/cli/described.h>

#include <fmt/format.h>

#include <algorithm>

namespace taut::cli {

namespace {

// What roff would take for its own: a backslash, a minus that would become a hyphen, a line that begins with a dot or
// a quote.
std::string plain(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_line = i == 0 || text[i - 1] == '\n';
    if (begins_line && (text[i] == '.' || text[i] == '\'')) out += "\\&";
    if (text[i] == '\\')
      out += "\\e";
    else if (text[i] == '-')
      out += "\\-";
    else
      out += text[i];
  }
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

// `taut-grid-solve`
std::string page_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string entry(const DescribedOption& option) {
  std::string head;
  for (const std::string& name : option.names) head += (head.empty() ? "" : ", ") + ("\\fB" + plain(name) + "\\fR");
  if (!option.value.empty()) head += " \\fI" + plain(option.value) + "\\fR";
  return ".TP\n" + head + "\n" + plain(option.what) + "\n";
}

std::string options(const DescribedCommand& command) {
  std::string text, group;
  for (const DescribedOption& option : command.options) {
    if (option.group != group) text += ".SS " + plain(option.group) + "\n";
    group = option.group;
    text += entry(option);
  }
  return text.empty() ? "" : ".SH OPTIONS\n" + text;
}

std::string list_of(const std::vector<DescribedCommand>& commands) {
  std::string text;
  for (const DescribedCommand& command : commands)
    text += ".TP\n\\fB" + plain(page_name(command.name)) + "\\fR(1)\n" + plain(command.what) + "\n";
  return text.empty() ? "" : ".SH SUBCOMMANDS\n" + text;
}

// The paragraphs are tables of names mostly: their lines stay as they are.
std::string notes(const DescribedCommand& command) {
  return command.footer.empty() ? "" : ".SH NOTES\n.nf\n" + plain(command.footer) + "\n.fi\n";
}

constexpr const char* kExitStatus =
    ".SH EXIT STATUS\n"
    ".TP\n0\nfound\n.TP\n1\nthere is none, which is proven\n.TP\n2\nwrong usage\n.TP\n3\nwrong input\n"
    ".TP\n4\nstopped by a limit or an interrupt, or unproven\n.TP\n70\na defect of the program\n";

}  // namespace

std::string manual_page(const DescribedCommand& command, const std::string& version) {
  const std::string name = page_name(command.name);
  std::string text = fmt::format(".TH {} 1 \"\" \"taut {}\" \"taut\"\n", upper(plain(name)), version);
  text += ".SH NAME\n" + plain(name) + " \\- " + plain(command.what) + "\n";
  text += ".SH SYNOPSIS\n\\fB" + plain(command.name) + "\\fR" + plain(command.usage.substr(command.name.size())) + "\n";
  text += list_of(command.below) + options(command) + notes(command) + kExitStatus;
  return text + (command.name == "taut" ? "" : ".SH SEE ALSO\n\\fBtaut\\fR(1)\n");
}

}  // namespace taut::cli
