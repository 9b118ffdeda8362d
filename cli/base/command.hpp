#pragma once

// Every subcommand: one function that declares its options on a CLI11 app and returns what runs it.

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace farrier::cli {

inline constexpr int kPassed = 0;
inline constexpr int kFailed = 1;    ///< ran, and did not meet its bounds, or broke down
inline constexpr int kBadInput = 2;  ///< refused before anything moved; interrupted: 129, 130 or 143

/// Says on standard error why `farrier <command>` ends. Returns its exit status: `status`, or that of an interrupt when the
/// user has stopped the command.
int fail(const char* command, const std::string& message, int status = kFailed);

/// The same for input that is refused: kBadInput.
int refuse(const char* command, const std::string& message);

std::function<int()> declare_bench(CLI::App& app);
std::function<int()> declare_compare(CLI::App& app);
std::function<int()> declare_completion(CLI::App& app);
std::function<int()> declare_convert(CLI::App& app);
std::function<int()> declare_deploy(CLI::App& app);
std::function<int()> declare_diagnose(CLI::App& app);
std::function<int()> declare_doctor(CLI::App& app);
std::function<int()> declare_drive(CLI::App& app);
std::function<int()> declare_echo(CLI::App& app);
std::function<int()> declare_export(CLI::App& app);
std::function<int()> declare_faults(CLI::App& app);
std::function<int()> declare_identify(CLI::App& app);
std::function<int()> declare_info(CLI::App& app);
std::function<int()> declare_man(CLI::App& app);
std::function<int()> declare_monitor(CLI::App& app);
std::function<int()> declare_record(CLI::App& app);
std::function<int()> declare_replay(CLI::App& app);
std::function<int()> declare_reproduce(CLI::App& app);
std::function<int()> declare_request(CLI::App& app);
std::function<int()> declare_robot(CLI::App& app);
std::function<int()> declare_ros(CLI::App& app);
std::function<int()> declare_security(CLI::App& app);
std::function<int()> declare_tables(CLI::App& app);
std::function<int()> declare_topics(CLI::App& app);
std::function<int()> declare_trial(CLI::App& app);
std::function<int()> declare_trot(CLI::App& app);

}  // namespace farrier::cli
