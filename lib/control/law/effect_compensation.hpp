#pragma once

// Compensates a joint's known effects around its controller:
//
//   sensors ──▶ corrected ──▶ DelayPredictor ──▶ controller ──▶ current_A ──▶ valve
//               lags, offset,  currents on        as ever        supply, ports, overlap, spool, null shift:
//               gain           their way                         the plant's terms in reverse order

#include <algorithm>
#include <array>
#include <span>

#include "control/law/droop_inverse.hpp"
#include "control/law/force_controller.hpp"
#include "control/law/lag_lead.hpp"
#include "control/model/position_rate.hpp"
#include "control/law/spool_lead.hpp"
#include "control/law/valve_inverse.hpp"
#include "plant/terms/active_effect.hpp"

namespace farrier::control {

/// Effects that EffectCompensation and DelayPredictor can compensate. Reasons for leaving out the others:
/// docs/decisions/0036-effect-compensation.md.
inline constexpr std::array kCompensatedEffects{
    plant::effect_id<plant::InputDelay>(),       plant::effect_id<plant::ValveBias>(),
    plant::effect_id<plant::ValveDynamics>(),    plant::effect_id<plant::ValveDeadband>(),
    plant::effect_id<plant::ValveAsymmetry>(),   plant::effect_id<plant::FlowSaturation>(),
    plant::effect_id<plant::SupplyDroop>(),      plant::effect_id<plant::ForceSensorLag>(),
    plant::effect_id<plant::ForceSensorGain>(),  plant::effect_id<plant::ForceSensorOffset>(),
    plant::effect_id<plant::VelocityFilterLag>()};

constexpr bool is_compensated(plant::EffectId id) noexcept {
  return std::ranges::find(kCompensatedEffects, id) != kCompensatedEffects.end();
}

/// Properties of a joint's sensors beside their effects.
struct CompensationParams {
  double period_s;                        ///< > 0
  double position_noise, velocity_noise;  ///< standard deviations of a sample, m, m/s or rad, rad/s; >= 0
};

/// Removes effects of valve and sensors from a controller's inputs and commands. Without any of kCompensatedEffects the
/// output equals the input, bit for bit. Allocation-free, bounded, cannot fail; corrected and current_A are each called
/// once per period.
class EffectCompensation {
 public:
  EffectCompensation() = default;
  /// `effects` and `actuator` pass plant::validate, as those of a robot file do.
  EffectCompensation(std::span<const plant::ActiveEffect> effects, const plant::ActuatorParams& actuator,
                     const CompensationParams& params) noexcept;

  /// Readings of sensors without effects. The position is unchanged. A velocity that is read with a lag is not used: it
  /// comes from the position, smoothed until its noise is that of the velocity's sensor, if that takes less time than
  /// the lag. Compensating the lag would need its ratio to the period as a gain on that noise.
  Measurement corrected(const Measurement& read) noexcept;

  /// Current at which the same oil flows as through an ideal valve at `opening_A`, which controllers ask for; within
  /// +-valve_current_max_A. `truth`: the output of corrected.
  double current_A(double opening_A, const Measurement& truth) noexcept;

  /// Time until a current asked for now acts: delay of the input, and the rest of the spool's.
  double delay_s() const noexcept { return delay_s_; }

  /// The valve's overlap from now on, A; >= 0.
  void set_overlap_A(double overlap_A) noexcept {
    acts_on_valve_ = acts_on_valve_ || overlap_A > 0.0;
    valve_.set_overlap_A(overlap_A);
  }

  /// Forgets past readings and sets the spool to null.
  void reset() noexcept;

 private:
  void take(const plant::ActiveEffect& effect, const plant::ActuatorParams& actuator,
            const CompensationParams& params) noexcept;

  bool acts_on_valve_ = false;
  bool acts_on_sensors_ = false;
  double current_max_A_ = 0.0;
  double bias_A_ = 0.0;
  DroopInverse supply_;
  ValveInverse valve_;
  SpoolLead spool_;
  double delay_s_ = 0.0;
  double force_gain_ = 1.0;
  double force_offset_ = 0.0;
  LagLead force_lead_, fresh_force_lead_;  ///< fresh: as it was made
  PositionRate velocity_, fresh_velocity_;
};

}  // namespace farrier::control
