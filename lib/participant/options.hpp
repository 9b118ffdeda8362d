#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "bus/network.hpp"
#include "participant/participant.hpp"

namespace farrier::participant {

/// The world that sim_bridge simulates: each joint on a bench load, or the whole robot on a ground, on its actuators or
/// on ideal sources of torque.
enum class World { kBench, kBody, kIdeal };
inline constexpr std::array kWorlds{Option<World>{"bench", World::kBench}, Option<World>{"body", World::kBody},
                                    Option<World>{"ideal", World::kIdeal}};
inline bool is_on_ground(World world) noexcept { return world != World::kBench; }
/// True if sim_bridge publishes supply/state there; `pump`: the robot file has one.
inline bool tells_supply(World world, bool pump) noexcept { return world == World::kBody && pump; }

/// Command line every process of a run shares; `farrier trot` fills it in, an integrator writes it in a unit file.
struct ProcessOptions {
  std::string name;  ///< of this participant, as others see it; parse_options fills in the process's own
  std::string robot_path = "deploy/robots/hyq.yaml";
  bus::Vendor vendor = bus::Vendor::kCyclone;
  bus::ClockKind clock = bus::ClockKind::kLockstep;
  bus::NetworkOptions network;
  std::string security;  ///< folder of keys and permissions; empty: DDS is not secured
  std::uint16_t number = 0;
  std::uint16_t participants = 0;
  std::uint64_t session = 1;
  std::uint64_t seed = 1;
  Tick ticks = 0;                   ///< length of the run; 0: until SIGTERM
  std::vector<std::string> joints;  ///< joint_node: the joints it hosts
  std::string trace_path;           ///< sim_bridge: where the trace goes, or empty
  std::string design = "stance";    ///< supervisor: a name of robot::kDesigns
  std::string gait;                 ///< overrides of the robot file, or empty
  double frequency_Hz = 0;
  std::string estimator;        ///< section of the robot file for every joint, or empty
  std::string controller;       ///< kind of every controller, as in a robot file, or empty
  World world = World::kBench;  ///< sim_bridge, locomotion
  std::string simulated_path;   ///< sim_bridge: robot file of the robot it simulates; empty: robot_path
  std::string scene_path;       ///< sim_bridge: scene file of a body's ground; empty: a plane
  std::vector<double>
      velocity;  ///< locomotion: of a walking body, forward, left (m/s), yaw rate (rad/s); empty: it lies
  std::vector<std::string> faults;  ///< on the way of samples into this process (FaultInjection), real time only
  int slow = 1;                     ///< slow motion by this factor, real time only
  bool standby = false;             ///< supervisor: takes over when the leader falls silent, real time only
  int priority_shift = 0;           ///< added to every SCHED_FIFO priority, real time only
  bool no_dither = false;           ///< joint_node: valves are not probed, whatever the robot file says
};

/// Network options for the clock: in lock-step no process is dropped for being delayed.
bus::NetworkOptions network_of(const ProcessOptions& options);

/// Parses argv; prints help or every mistake and exits (0 or 2) when there is nothing to run.
ProcessOptions parse_options(const std::string& process, const std::string& purpose, int argc, char** argv);

/// The argv a launcher passes to get these options; the inverse of parse_options.
std::vector<std::string> to_arguments(const ProcessOptions& options);

}  // namespace farrier::participant
