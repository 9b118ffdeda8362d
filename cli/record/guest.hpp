#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <memory>
#include <string>

#include "bus/bus.hpp"
#include "bus/network.hpp"
#include "bus/roles.hpp"
#include "core/result.hpp"
#include "cli/base/installation.hpp"

namespace farrier::cli {

/// A guest that counts from the first sample waits this long for it. Discovery can take seconds on a busy computer.
constexpr std::chrono::seconds kFirstSampleLimit{10};

/// Options of a command that joins a running robot as an observer.
struct GuestOptions {
  std::string robot_path = shipped_robot("hyq.yaml");
  std::string vendor = "cyclone";
  std::string security;
  bus::NetworkOptions network;
};

/// Reason of a refusal, and the command's exit status then.
struct Refused {
  std::string message;
  int status;
};

/// --domain, --address and --peers.
std::array<CLI::Option*, 3> declare_network(CLI::App& app, bus::NetworkOptions& network);

/// --dds
void declare_vendor(CLI::App& app, std::string& vendor);

/// All of these, --robot and --security.
void declare_guest(CLI::App& app, GuestOptions& options);

/// The robot's bus, with the rights of `role`.
Result<std::unique_ptr<bus::Bus>, Refused> join_as_guest(const GuestOptions& options, bus::Role role);

/// Waits until this time, or until the command is asked to stop.
void nap(bus::Bus& bus, SteadyTime until);

}  // namespace farrier::cli
