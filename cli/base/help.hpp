#pragma once

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <string>

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

/// An option that takes one of the names of `options`; refuses others, naming those there are.
template <class Target, class Options>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Target& target, const Options& options,
                        const std::string& text) {
  std::string order;
  for (const auto& option : options) {
    order += (order.empty() ? "" : "|") + std::string(option.name);
  }
  return app
      .add_option_function<std::string>(
          name,
          [&target, &options, name, order](const std::string& given) {
            const auto place = std::ranges::find(options, given, [](const auto& option) { return option.name; });
            if (place == std::ranges::end(options)) {
              throw CLI::ValidationError(name, "'" + given + "' is not one of " + order);
            }
            target = place->value;
          },
          text)
      ->type_name(order);
}

/// A number between two bounds, without a second copy of them in the help.
CLI::Validator between(double low, double high);

}  // namespace farrier::cli
