#pragma once

// The same robot on a ground with other force controllers, and with less that disturbs them.

#include <span>
#include <string>
#include <vector>

#include "trials/body/compared_runs.hpp"

namespace farrier::trials {

/// A robot under comparison.
struct BodyContender {
  std::string name;         ///< of one word, as in figures
  std::string description;  ///< for people
  robot::Robot robot;
};

/// Name of the robot as its file has it, and of the one whose controller knows all that can be known.
inline constexpr const char* kFileDesign = "file";
inline constexpr const char* kPerfectKnowledge = "perfect";

/// Force controllers: the file's, feedback linearisation, LQR in both forms and flow inversion for loads of the mass
/// matrix, LQR for the loads of the bench and for a blocked piston, PID. The first has the robot of the file.
/// `on_ground` and `on_bench` are of one file with a body.
std::vector<BodyContender> force_controllers(const robot::Robot& on_ground, const robot::Robot& on_bench);

/// The robot of the file with perfect knowledge: no effect that its law does not have (friction, overlap, leakage, a
/// supply whose pressure changes). Sensors, valve and delay stay. The next ones lose, one after the other, the noise, the
/// delay, the lag of the spool and the uncompensated share of the velocity. The last ones are the file's robot with each of
/// its disturbances removed alone.
std::vector<BodyContender> limits_of_force(const robot::Robot& on_ground);

/// The robot with valves that follow their current at once, and have no overlap and no leakage.
robot::Robot with_ideal_valves(robot::Robot robot);

/// A contender's runs.
struct ContenderResult {
  std::string name, description;
  ComparedRuns runs;
};

/// compare_runs of each contender, whose gains do not adapt. Stops when `done` says false; then the results are those of
/// the contenders that ended.
std::vector<ContenderResult> compare_on_body(std::span<const BodyContender> contenders, int seeds,
                                             const std::function<bool()>& done);

}  // namespace farrier::trials
