#pragma once

// One estimator per leg joint:
//
//   joint/measurement ──▶ ValveOpening, SignalAligner ──▶ Estimator of that joint
//       ──▶ joint/model_estimate (every estimate_period_ticks)
//       └──▶ lf/joint/model_estimate (ten a second)

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "control/law/signal_aligner.hpp"
#include "control/law/valve_opening.hpp"
#include "estimation/estimator.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::estimator_service {

/// The ticks of the last 64 of which a measurement was taken.
class TakenTicks {
 public:
  void add(Tick tick) noexcept {
    if (tick > newest_) {
      bits_ = bits_at(tick);
      newest_ = tick;
    }
    bits_ |= shifted(1, newest_ - tick);
  }
  /// Bit i is 1 if the measurement of `tick - i` was taken. `tick`: the newest that was added, or later.
  std::uint64_t bits_at(Tick tick) const noexcept { return shifted(bits_, tick - newest_); }

 private:
  static std::uint64_t shifted(std::uint64_t bits, Tick ticks) noexcept {
    return ticks < std::numeric_limits<std::uint64_t>::digits ? bits << ticks : 0;
  }

  Tick newest_ = kNoTick;
  std::uint64_t bits_ = 0;
};

/// The service's core. No clock, no I/O, no allocation after construction.
class EstimatorService {
 public:
  /// Every estimator starts from the joint's swing load in both phases, and knows that a command acts
  /// `loop_delay_ticks` after the sample it answers. Refuses estimator settings out of range, naming the joint.
  static Result<EstimatorService> create(const robot::Robot& robot, int loop_delay_ticks);

  /// A copy knows what this one does, and learns by itself.
  EstimatorService(const EstimatorService& other);
  EstimatorService& operator=(const EstimatorService& other) { return *this = EstimatorService(other); }
  EstimatorService(EstimatorService&&) noexcept = default;
  EstimatorService& operator=(EstimatorService&&) noexcept = default;
  ~EstimatorService() = default;

  /// Takes one joint's measurement. Measurements of joints the robot does not have are left out.
  void take(const signals::JointMeasurement& measurement) noexcept;

  /// Takes the pressure of the supply, which holds until the next one. Before the first one the robot file's holds.
  void take(const signals::SupplyState& supply) noexcept { supply_Pa_ = supply.pressure_Pa; }

  /// Present estimate of a joint, as of `tick`. Not an estimate for a joint the robot does not have.
  signals::JointModelEstimate estimate(std::uint16_t joint, Tick tick) const noexcept;

 private:
  /// From a joint's measurements to what its estimator reads.
  struct Inputs {
    control::ValveOpening valve;
    control::SignalAligner aligner;
    Tick newest = kNoTick;
  };

  EstimatorService(std::vector<std::unique_ptr<estimation::Estimator>> estimators, std::vector<Inputs> inputs)
      : estimators_(std::move(estimators)), inputs_(std::move(inputs)), taken_(estimators_.size()) {}

  std::vector<std::unique_ptr<estimation::Estimator>> estimators_;  // by joint number
  std::vector<Inputs> inputs_;                                      // likewise
  std::vector<TakenTicks> taken_;                                   // likewise
  double supply_Pa_ = 0.0;
};

}  // namespace farrier::estimator_service
