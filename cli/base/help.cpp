#include "cli/base/help.hpp"

#include <CLI/CLI.hpp>

#include <cmath>

#include "cli/base/command_text.hpp"
#include "cli/base/verbs.hpp"

namespace farrier::cli {
namespace {

constexpr std::size_t kUsageWidth = 80;

std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name() : full_name(*app.get_parent()) + " " + app.get_name();
}

/// usage: farrier trot [--robot <file>] ...   wrapped, then the sentence, then each option with its meaning below it.
class GitLikeFormatter final : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override {
    return app->get_subcommands({}).empty() ? command_help(*app) : top_help(*app);
  }

 private:
  static std::string top_help(const CLI::App& app) {
    std::string text = "usage: " + full_name(app) + " <command> [<options>]\n\n" + app.get_description() +
                       ".\n\nThe commands are:\n\n";
    for (const Verb& verb : verbs()) {
      std::string name(verb.name);
      name.resize(12, ' ');
      text += "   " + name + std::string(verb.sentence) + "\n";
    }
    return text + "   test        Run the tests (./farrier test, with --all the long ones too)\n" +
           "   docs        Make the site of the documents (./farrier docs)\n\n" +
           "See '" + full_name(app) + " <command> --help' for what a command takes.\n";
  }

  static std::string command_help(const CLI::App& app) {
    std::string line = "usage: " + full_name(app);
    const std::string indent(line.size(), ' ');
    std::string text;
    const CommandText command = command_text(app);
    for (const OptionText& option : command.options) {
      const std::string usage = usage_of(option);
      if (line.size() + 1 + usage.size() > kUsageWidth) {
        text += line + "\n";
        line = indent;
      }
      line += " " + usage;
    }
    text += line + "\n\n    " + command.sentence + ".\n\n";
    for (const OptionText& option : command.options) {
      text += "    " + heading_of(option) + "\n        " + option.meaning +
              (option.unless_told.empty() ? "" : " (" + option.unless_told + " unless told)") + "\n";
    }
    return text;
  }
};

}  // namespace

void use_help(CLI::App& app) {
  app.formatter(std::make_shared<GitLikeFormatter>());
  app.set_help_flag("-h,--help", "print this help");
  app.failure_message([](const CLI::App* failed, const CLI::Error& error) {
    const CLI::App* command = failed;
    while (!command->get_subcommands().empty()) {
      command = command->get_subcommands().front();
    }
    const std::string name = full_name(*command);
    return name + ": " + error.what() + "\nsee '" + name + " --help'\n";
  });
}

CLI::Validator between(double low, double high) {
  return CLI::Validator(
      [low, high](std::string& given) {
        double value = NAN;
        if (!CLI::detail::lexical_cast(given, value) || !(value >= low && value <= high)) {
          char text[96];
          std::snprintf(text, sizeof text, " is out of range: give %g to %g", low, high);
          return "'" + given + "'" + text;
        }
        return std::string();
      },
      "");
}

}  // namespace farrier::cli
