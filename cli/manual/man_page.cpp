#include "cli/manual/man_page.hpp"

#include <algorithm>
#include <cctype>

namespace farrier::cli {
namespace {

/// Text that roff takes for itself nowhere.
std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : std::string(1, c);
  }
  return escaped.starts_with('.') ? "\\&" + escaped : escaped;
}

/// A line in bold: a dot or quote at its beginning would be a request.
std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }

/// "--dds cyclone|fast": the names in bold, what stands for a value in italics.
std::string styled(const std::string& heading) {
  const std::size_t space = heading.find(' ');
  if (space == std::string::npos) {
    return heading.starts_with('<') ? "\\fI" + plain(heading) + "\\fR" : bold(heading);
  }
  return bold(heading.substr(0, space)) + " \\fI" + plain(heading.substr(space + 1)) + "\\fR";
}

std::string dashed(const CommandText& command) { return command.name.empty() ? "farrier" : "farrier-" + command.name; }

std::string head(const CommandText& command, const std::string& version) {
  std::string title = dashed(command);
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return ".\\\" Written by 'farrier man'.\n.TH \"" + plain(title) + "\" 1 \"\" \"Farrier " + plain(version) +
         "\" \"Farrier\"\n.nh\n.ad l\n.SH NAME\n" + plain(dashed(command)) + " \\- " + plain(command.sentence) + "\n.SH SYNOPSIS\n";
}

std::string options_section(const CommandText& command) {
  std::string text = ".SH OPTIONS\n";
  for (const OptionText& option : command.options) {
    text += ".TP\n" + styled(heading_of(option)) + "\n" + plain(option.meaning) +
            (option.unless_told.empty() ? "" : " (" + plain(option.unless_told) + " unless told)") + ".\n";
  }
  return text;
}

std::string exit_section() {
  return ".SH EXIT STATUS\n"
         ".TP\n\\fB0\\fR\nDone; every bound held.\n"
         ".TP\n\\fB1\\fR\nIt ran and did not meet its bounds, or broke down.\n"
         ".TP\n\\fB2\\fR\nRefused before anything moved.\n"
         ".TP\n\\fB130\\fR, \\fB143\\fR\nInterrupted.\n";
}

std::string command_page(const CommandText& command, const std::string& version) {
  std::string text = head(command, version) + bold(command.full_name());
  for (const OptionText& option : command.options) {
    text += "\n" + plain(usage_of(option));
  }
  return text + "\n.SH DESCRIPTION\n" + plain(command.sentence) + ".\n" + options_section(command) + exit_section() +
         ".SH SEE ALSO\n\\fBfarrier\\fR(1)\n";
}

std::string top_page(const CommandText& farrier, const std::vector<CommandText>& commands,
                     const std::string& version) {
  std::string text = head(farrier, version) + "\\fBfarrier\\fR \\fI<command>\\fR [\\fI<options>\\fR]\n.SH DESCRIPTION\n" +
                     plain(farrier.sentence) + ".\nEach command has a page of its own.\n.SH COMMANDS\n";
  for (const CommandText& command : commands) {
    text += ".TP\n\\fB" + plain(dashed(command)) + "\\fR(1)\n" + plain(command.sentence) + ".\n";
  }
  text += options_section(farrier) + exit_section() + ".SH SEE ALSO\n";
  for (const CommandText& command : commands) {
    text += "\\fB" + plain(dashed(command)) + "\\fR(1)" + (&command == &commands.back() ? "\n" : ",\n");
  }
  return text;
}

}  // namespace

std::map<std::string, std::string> man_pages(const CommandText& farrier, const std::vector<CommandText>& commands,
                                             const std::string& version) {
  std::map<std::string, std::string> pages{{"farrier.1", top_page(farrier, commands, version)}};
  for (const CommandText& command : commands) {
    pages[dashed(command) + ".1"] = command_page(command, version);
  }
  return pages;
}

}  // namespace farrier::cli
