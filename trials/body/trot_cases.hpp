#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/robot.hpp"
#include "locomotion/motion_script.hpp"

namespace farrier::trials {

/// Runs of one kind, which are judged together. Masses, impulses and heights are HyQ's: those of other robots are in
/// proportion to their mass and the height of their trunk.
struct TrotTrial {
  const char* name;
  const char* sentence;
  bool valve_sticks = false;  ///< a valve stops moving, and the robot shall lie down
  bool lands_softly = false;  ///< it must do so softly in seven of eight runs
};

inline constexpr std::array kTrotTrials{
    TrotTrial{"flat", "0.4 m/s on flat ground, a minute, with a trunk of 51 kg, 59 kg and 67 kg; ten seeds"},
    TrotTrial{"speed", "0.8 m/s; ten seeds"},
    TrotTrial{"sideways", "0.3 m/s to the left; ten seeds"},
    TrotTrial{"turning", "0.5 rad/s on the spot; ten seeds"},
    TrotTrial{"modes", "trot, stop, lie down, stand up, trot; ten seeds"},
    TrotTrial{"pushes", "80 Ns in 0.1 s from four sides at eight phases of the stride"},
    TrotTrial{"push_limit", "the impulse of 0.1 s from each side at which half of eight phases fall; not judged"},
    TrotTrial{"slopes", "0.3 m/s up, down and across a slope of 10 degrees; three seeds"},
    TrotTrial{"blocks", "0.3 m/s over blocks up to 8 cm high; twenty fields"},
    TrotTrial{"step", "0.3 m/s up a step of 10 cm; twenty distances"},
    TrotTrial{"lag", "0.4 m/s with torques that arrive 0, 5 and 10 ticks later; three seeds"},
    TrotTrial{"long_lag", "the same 20 ticks later; not judged"},
    TrotTrial{"payload", "20 kg are put on the trunk, and no controller is told; three seeds"},
    TrotTrial{"supply", "0.4 m/s while the pump gives 7/12 and the accumulator a fifth; ten seeds"},
    TrotTrial{"low_supply", "0.4 m/s while the pump gives half, 20 s; ten seeds"},
    TrotTrial{"pump_stops", "0.4 m/s while the pump stops; three seeds"},
    TrotTrial{"dead_joint", "0.4 m/s while the valve of the first knee sticks shut; eight phases of the stride", true,
              true},
    TrotTrial{"dead_hip", "the same with the valve of the first HFE joint; not judged", true},
    TrotTrial{"dead_abduction", "the same with the valve of the first HAA joint", true, true},
    TrotTrial{"open_valve", "dead_joint with the valve half open to either side; not judged", true},
    TrotTrial{"energy",
              "the account of the pump's work over 10 s at 0.4 m/s, and again with half the step; ten seeds"}};

/// The trial of that name; one that lets no valve stick if there is none.
constexpr TrotTrial trot_trial(std::string_view name) noexcept {
  for (const TrotTrial& trial : kTrotTrials) {
    if (name == trial.name) {
      return trial;
    }
  }
  return {"", ""};
}

/// One run: a robot, a scene and a script.
struct TrotCase {
  std::string trial;  ///< of kTrotTrials
  std::string name;   ///< unique within the trial
  std::uint64_t seed = 1;
  std::optional<double> trunk_mass_kg = std::nullopt;  ///< true mass, which no controller knows
  int lag_ticks = 0;                                   ///< beyond the one tick of every command
  std::string scene;                                   ///< in the format of a scene file
  std::vector<locomotion::TimedCommand> script;
  std::optional<double> fault_s = std::nullopt;  ///< instant of a fault of the supply or of an actuator in the scene
  std::optional<double> load_s = std::nullopt;   ///< instant of a payload in the scene
  int finer = 1;                                 ///< divides the step of body and actuators
  bool may_sink = false;                         ///< a low trunk is no fall
  bool adapts = false;                           ///< the gains of actuators are redesigned from estimates
  bool knows = false;           ///< actuators are told the true physics of valve and piston as they change
  double trot_s = 0.0;          ///< when it first begins to trot
  double judged_from_s = 0.0;   ///< means are over this time ...
  double judged_until_s = 0.0;  ///< ... to this
  double end_s = 0.0;

  static constexpr double kLoadSettled_s = 2.0;  ///< after a load is put on

  /// True if ideal joints cannot run it.
  bool needs_pump() const noexcept { return fault_s || trial == "energy"; }
  /// The command that is judged.
  const locomotion::MotionCommand& judged_command() const noexcept;
};

/// Where a push comes from, and its direction in the world.
struct PushSide {
  const char* name;
  double x, y;
};
inline constexpr std::array kPushSides{PushSide{"behind", 1, 0}, PushSide{"right", 0, 1}, PushSide{"ahead", -1, 0},
                                       PushSide{"left", 0, -1}};
inline constexpr int kPushPhases = 8;  ///< of the stride, at which a push begins

/// A push of 0.1 s while the robot trots on flat ground. The robot needs body and locomotion.
TrotCase push_case(const robot::Robot& robot, const std::string& trial, const PushSide& side, double impulse_Ns,
                   int phase);

/// An impulse that changes the robot's velocity as this one changes HyQ's, rounded to 0.1 Ns.
double scaled_impulse_Ns(const robot::Robot& robot, double of_hyq_Ns);

/// All cases but those of push_limit (push_limit.hpp), trial by trial in the order of kTrotTrials. The robot needs body
/// and locomotion. One without a pump has no case with a fault of the supply or of an
/// actuator, and ideal joints cannot run them.
std::vector<TrotCase> trot_cases(const robot::Robot& robot);

/// The first case of every trial.
std::vector<TrotCase> first_of_each_trial(const std::vector<TrotCase>& cases);

}  // namespace farrier::trials
