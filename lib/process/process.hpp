#pragma once

// Code that every main.cpp shares: load the robot, open the bus, take part, run until told to stop.

#include <functional>
#include <memory>

#include "participant/application.hpp"
#include "participant/options.hpp"
#include "participant/realtime_loop.hpp"
#include "robot/robot.hpp"

namespace farrier::process {

template <class App>
using Factory =
    std::function<Result<std::unique_ptr<App>>(participant::Participant&, const robot::Robot&)>;

/// Loads the robot file with the options' overrides.
Result<robot::Robot, config::Problems> load_robot(const participant::ProcessOptions& options);

/// Identity of this process in the run.
participant::Identity identity_of(const participant::ProcessOptions& options, const robot::Robot& robot);

/// Adds the proofs of identity of a process of this role to `network`; nothing if `folder` (--security) is empty.
/// Refuses, with the file and the remedy, files that DDS would refuse, or on which it could not agree with the other
/// vendor.
Result<Done> secure(bus::NetworkOptions& network, const std::string& folder, bus::Role role, bus::Vendor vendor);

/// Runs one process to its end. One thread polls. On the real-time clock a process with a control loop has the three
/// threads of `threaded` instead. Returns its exit status: 0 stopped as told, 1 could not take part, 2 bad input.
int run(const participant::ProcessOptions& options, const Factory<participant::Application>& polled,
        const Factory<participant::RealtimeApplication>& threaded = nullptr);

}  // namespace farrier::process
