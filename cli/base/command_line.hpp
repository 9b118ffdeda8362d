#pragma once

#include <functional>
#include <memory>
#include <span>

namespace CLI {
class App;
}

namespace farrier::cli {

/// Declares a verb's options on its app and returns the function that runs it with what was parsed.
using Declare = std::function<int()> (*)(CLI::App& app);

/// A verb that a program runs: its name in cli/verbs.def and its options.
struct DeclaredVerb {
  const char* name;
  Declare declare;
};

/// `farrier` with these verbs. Parsing only stores the function that runs the chosen verb in `run`, which must outlive
/// the app.
std::unique_ptr<CLI::App> command_line(std::span<const DeclaredVerb> declared, std::function<int()>& run);

/// The main function of a program of the command: parses, runs a verb of its own, or starts the program of another
/// verb in its place. Returns the exit status.
int run_program(std::span<const DeclaredVerb> declared, int argc, char** argv);

}  // namespace farrier::cli
