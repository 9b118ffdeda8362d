#pragma once

#include <algorithm>
#include <optional>

#include "core/low_alarm.hpp"
#include "locomotion/trot_controller.hpp"
#include "locomotion/supply_guard.hpp"
#include "world/body_world.hpp"

namespace farrier::trials {

/// The true motion after a fault of the supply or of an actuator. Seconds are since the fault.
struct SupplyFigures {
  std::optional<double> low_s = std::nullopt;  ///< first sample of the pressure that is low
  std::optional<double> sag_s =
      std::nullopt;  ///< the trunk is 20 mm below the default height, before it is asked to lie
  std::optional<double> slows_s = std::nullopt;  ///< locomotion trots more slowly than commanded
  std::optional<double> acts_s = std::nullopt;   ///< locomotion stands or lies down for it
  std::optional<double> lying_s = std::nullopt;  ///< the trunk has the height of a robot that lies, or less
  double largest_sinking_m_s = 0.0;
  double largest_foot_force_N = 0.0;  ///< mean of a tick
  bool recovers = false;              ///< the pressure at the end is not below the one from which on a trot slows down
  double end_speed_m_s = 0.0;         ///< way of the trunk per time, from 10 s after the fault to the end
};

/// Makes them tick by tick.
class SupplyJudge {
 public:
  /// `height_m`: the default height; the trunk's sag counts as deep from `deep_m` on.
  SupplyJudge(const locomotion::SupplyGuardParams& limits, const locomotion::LocomotionParams& locomotion,
              double fault_s, double deep_m)
      : low_(limits.low_Pa, limits.recovered_Pa),
        height_m_(locomotion.reference.default_height_m),
        lying_m_(locomotion.mode.folded_height_m + locomotion.mode.height_tolerance_m),
        fault_s_(fault_s),
        deep_m_(deep_m),
        slow_Pa_(limits.slow_Pa) {}

  /// `height_m`: of the trunk above the ground's plane. `dead_joint`: locomotion has found one.
  void observe(double now_s, const world::BodyWorld& body, double height_m, double pressure_Pa,
               locomotion::SupplyDemand demand, bool dead_joint) noexcept;

  const SupplyFigures& figures() const noexcept { return figures_; }

 private:
  LowAlarm low_;
  static constexpr double kEnd_s = 10.0;

  double height_m_, lying_m_, fault_s_, deep_m_, slow_Pa_;
  std::optional<double> end_from_s_;
  Eigen::Vector3d end_from_m_;
  SupplyFigures figures_;
};

}  // namespace farrier::trials
