#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "core/result.hpp"
#include "robot/robot.hpp"
#include "tools/monitor/display.hpp"

namespace farrier::cli {

/// The page of `farrier monitor`.
struct WebOptions {
  std::string address;    ///< of its server, from --web or --port; empty: none
  std::string recording;  ///< recording to show instead of a running robot; empty: the robot
};

/// The options --web, --port and --open. The first two exclude each other and `once`.
void declare_web(CLI::App& app, WebOptions& options, CLI::Option* once);

/// Opens the page for a robot that runs, and says where. Refuses, with the option to correct.
Result<std::unique_ptr<display::Display>> open_web(const WebOptions& options, const robot::Robot& robot);

/// Shows the recording until the user asks for the end; returns the exit status.
int show_recording(const WebOptions& options);

}  // namespace farrier::cli
