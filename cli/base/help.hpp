#pragma once

#include <CLI/CLI.hpp>

#include <map>
#include <string>

#include "core/choice.hpp"

namespace farrier::cli {

/// Gives an app help that reads like git's, and errors that name the command and where its help is.
void use_help(CLI::App& app);

/// An option that takes one of the named values; refuses others, naming those there are. `order` lists them for
/// people, most usual first.
template <class Target, class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Target& target,
                        const std::map<std::string, Value>& choices, const std::string& order,
                        const std::string& text) {
  return app
      .add_option_function<std::string>(
          name,
          [&target, &choices, name, order](const std::string& given) {
            const auto place = choices.find(given);
            if (place == choices.end()) {
              throw CLI::ValidationError(name, "'" + given + "' is not one of " + order);
            }
            target = place->second;
          },
          text)
      ->type_name(order);
}

/// An option that takes one of the names of `options`, an array of Option; refuses others, naming those there are.
template <class Target, class Options>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Target& target, const Options& options,
                        const std::string& text) {
  const std::string order = names_of(options, "|");
  return app
      .add_option_function<std::string>(
          name,
          [&target, &options, name, order](const std::string& given) {
            const auto chosen = parse_choice("", options, given);
            if (!chosen) {
              throw CLI::ValidationError(name, "'" + given + "' is not one of " + order);
            }
            target = chosen.value();
          },
          text)
      ->type_name(order);
}

/// The same where the name itself is kept.
template <class Options>
CLI::Option* add_name(CLI::App& app, const std::string& name, std::string& target, const Options& options,
                      const std::string& text) {
  const std::string order = names_of(options, "|");
  return app.add_option(name, target, text)
      ->check([&options, order](const std::string& given) {
        return parse_choice("", options, given) ? "" : "'" + given + "' is not one of " + order;
      })
      ->type_name(order);
}

/// A number between two bounds, without a second copy of them in the help.
CLI::Validator between(double low, double high);

}  // namespace farrier::cli
