#pragma once

#include <optional>

#include "core/low_alarm.hpp"
#include "locomotion/controller.hpp"

namespace farrier::locomotion {

/// Limits of the hydraulic supply.
struct SupplyGuardParams {
  double low_Pa = 0.0;                ///< below this the supply is low until it has recovered
  double slow_Pa = 0.0;               ///< below this a trot becomes slower ...
  double recovered_Pa = 0.0;          ///< ... and from this on faster again; >= slow_Pa >= low_Pa
  double lie_Pa = 0.0;                ///< below this it cannot carry the robot; <= low_Pa
  double least_pump_flow_m3_s = 0.0;  ///< a pump that gives less has stopped; >= 0
  double stand_after_s = 0.3;         ///< time for which the supply is low before the robot stands, >= 0
  double lie_after_s = 0.1;           ///< time without pressure or pump before it lies down, >= 0
  double slowest = 0.3;               ///< least factor on the commanded velocities, 0..1
  double slowing_1_s = 0.5;           ///< rate at which the factor falls, >= 0
  double quickening_1_s = 0.1;        ///< rate at which it rises, >= 0
};

/// Readings of the supply's sensors.
struct SupplyReading {
  double pressure_Pa = 0.0;
  double pump_flow_m3_s = 0.0;
};

/// The least that a robot does about its supply.
enum class SupplyDemand : unsigned char {
  kNone,   ///< the operator's command acts
  kSlow,   ///< a trot is slower than commanded
  kStand,  ///< a trot ends, the robot stands
  kLie,    ///< the robot lies down while there is oil in the accumulator
};

/// Replaces the operator's command while the supply cannot carry it. While the pressure is between that of a low supply
/// and slow_Pa the velocities shrink by a factor, so that the trot needs less oil. It stays as it is up to recovered_Pa and
/// grows from there on, so that pump and trot find a balance. A demand to stand or lie stays until the supply has recovered and
/// the operator has asked for the same or less, so that a robot does not start and stop by itself.
class SupplyGuard {
 public:
  SupplyGuard(const SupplyGuardParams& params, double period_s) noexcept
      : params_(params), period_s_(period_s), low_(params.low_Pa, params.recovered_Pa) {}

  /// Takes the newest reading, once a tick; before the first one nothing is demanded. Returns the command that acts.
  MotionCommand step(const MotionCommand& asked, const std::optional<SupplyReading>& reading) noexcept;

  SupplyDemand demand() const noexcept {
    return demand_ == SupplyDemand::kNone && speed_ < 1.0 ? SupplyDemand::kSlow : demand_;
  }
  /// Factor on the commanded velocities, params.slowest..1.
  double speed() const noexcept { return speed_; }

 private:
  void judge(const SupplyReading& reading) noexcept;

  SupplyGuardParams params_;
  double period_s_;
  LowAlarm low_;
  bool empty_ = false;
  double low_s_ = 0.0, empty_s_ = 0.0;  // for which it has been so
  double speed_ = 1.0;
  SupplyDemand demand_ = SupplyDemand::kNone;  // kNone, kStand or kLie
};

}  // namespace farrier::locomotion
