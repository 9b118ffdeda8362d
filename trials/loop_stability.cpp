#include "trials/loop_stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "control/law/filter_equaliser.hpp"
#include "control/law/force_controller.hpp"
#include "plant/load_pressure.hpp"
#include "robot/sensor_path.hpp"
#include "sim_bridge/sensor_chain.hpp"

namespace farrier::trials {
namespace {

constexpr double kPushShare = 1e-4;  ///< of the force that counts as 1
constexpr int kTicks = 5000;
constexpr double kTolerance = 1e-11;  ///< of a substep, so that the push is far above its error
constexpr double kNearest = 0.9;
constexpr double kStep = 0.01;
constexpr int kSteps = 20;

/// Commands of the controller on their way to the valve.
class DelayedCurrent {
 public:
  explicit DelayedCurrent(double delay_ticks) noexcept
      : whole_(static_cast<std::size_t>(delay_ticks)), share_(delay_ticks - static_cast<double>(whole_)) {}

  void put(double current_A) noexcept {
    std::shift_right(commands_.begin(), commands_.end(), 1);
    commands_[0] = current_A;
  }
  /// Share of the tick at which the current changes, and what it is before and after.
  double changes_at() const noexcept { return share_; }
  double before() const noexcept { return commands_[whole_ + 1]; }
  double after() const noexcept { return commands_[whole_]; }

 private:
  static constexpr std::size_t kLength = static_cast<std::size_t>(kLongestDelay_ticks) + control::kMaxDelayTicks + 2;
  std::array<double, kLength> commands_{};  // newest first
  std::size_t whole_;
  double share_;
};

/// The joint at rest at home, its chambers in steady flow (3.19), (3.20), as the linear model takes them.
Result<plant::Joint> plant_of(const robot::Joint& joint, const plant::LoadParams& load) {
  const plant::ActuatorParams& actuator = joint.actuator;
  const double home = joint.linkage.position(joint.home_angle_rad);
  const double held_Pa = load.stiffness * (home - load.equilibrium_position) / actuator.area_a;
  const plant::State at_rest = plant::steady_chambers(actuator, {.position = home, .load_pressure_Pa = held_Pa});
  auto made = FARRIER_TRY(plant::HydraulicJoint::create(actuator, load, at_rest, kTolerance, joint.effects));
  return plant::Joint(std::move(made));
}

}  // namespace

Result<bool> is_stable(const RunningLoop& loop, const LoopChange& change) {
  robot::Joint joint = loop.joint;
  joint.noise = {};
  joint.sensors.position_step = 0.0;
  plant::Joint plant = FARRIER_TRY(plant_of(joint, loop.load));
  sim_bridge::SensorChain sensors = FARRIER_TRY(sim_bridge::SensorChain::create(joint, loop.period_s, 0));
  control::FilterEqualiser equaliser = robot::filter_equaliser(loop.joint, loop.period_s);
  control::ForceController controller;
  sensors.begin(sim_bridge::truth_of(plant));
  const double home = sensors.sample().position;
  const double force_at_rest = sensors.sample().force;
  if (!controller.set_gains(loop.gains, {0.0, 0.0, 0.0}, 0.0)) {
    return Error{"gains that cannot act"};
  }
  DelayedCurrent current(loop.gains.delay_ticks + change.delay_ticks);
  const double push = kPushShare * loop.gains.normalisation.force;
  // Squares of the force in two windows, after what the push excites beside the slowest mode has died out.
  constexpr int kFirstWindow = kTicks * 4 / 10;
  constexpr int kSecondWindow = kTicks * 7 / 10;
  constexpr int kPushed = 20;     // ticks of the push's own response
  constexpr double kGone = 1e-8;  // share of its square: less is the integrator's error
  constexpr double kGrown = 1e3;  // more has grown, and is no longer small
  constexpr double kFalls = 0.9;  // from window to window; a limit cycle stays
  double pushed = 0.0;
  double before = 0.0;
  double after = 0.0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const sim_bridge::Measured& read = sensors.sample();
    const control::Measurement measured =
        equaliser.take({read.position - home, read.velocity, read.force - force_at_rest});
    const double command_A = controller.step(0.0, measured).valve_current_A;
    if (!std::isfinite(command_A) || std::abs(command_A) >= loop.gains.normalisation.current_A) {
      return false;
    }
    current.put(change.gain * command_A);
    double at = 0.0;
    const int conversions = sensors.conversions();
    for (int i = 0; i < conversions; ++i) {
      const double end = static_cast<double>(i + 1) / conversions;
      for (const double until : {std::clamp(current.changes_at(), at, end), end}) {
        if (until > at) {
          plant.step(at < current.changes_at() ? current.before() : current.after(), tick == 0 ? push : 0.0,
                     (until - at) * loop.period_s);
          at = until;
        }
      }
      sensors.convert(sim_bridge::truth_of(plant), tick + 1, i);
    }
    const double square = measured.force * measured.force;
    if (tick < kPushed) {
      pushed = std::max(pushed, square);
    } else if (square > kGrown * pushed) {
      return false;
    }
    if (tick >= kFirstWindow) {
      (tick < kSecondWindow ? before : after) += square;
    }
  }
  return after < kFalls * before || after < kGone * pushed * (kTicks - kSecondWindow);
}

Result<double> first_unstable(const RunningLoop& loop, const std::function<LoopChange(double factor)>& of) {
  for (const double factor : {0.3, 0.5, 0.7, 0.8}) {
    if (!FARRIER_TRY(is_stable(loop, of(factor)))) {
      return factor;
    }
  }
  for (int i = 0; i <= kSteps; ++i) {
    const double factor = kNearest + kStep * i;
    if (!FARRIER_TRY(is_stable(loop, of(factor)))) {
      return factor - 0.5 * kStep;
    }
  }
  return kNearest + kStep * kSteps;
}

}  // namespace farrier::trials
