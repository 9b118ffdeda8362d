#pragma once

#include <vector>

#include "core/result.hpp"
#include "robot/robot.hpp"
#include "trials/body/body_trial.hpp"

namespace farrier::trials {

/// Holds the home pose, each joint by itself, without control of the trunk's attitude:
///   tau = k_p (q_0 - q) - k_d q' - J_z' f.
/// Here f is an even share of the weight and J_z the vertical row of the foot's Jacobian at home.
class Stand final : public BodyController {
 public:
  struct Gains {
    double stiffness_Nm_rad = 1500.0;
    double damping_Nms_rad = 40.0;
  };

  /// Refuses a robot that its file does not describe as rigid bodies.
  static Result<Stand> create(const robot::Robot& robot, const Gains& gains);
  static Result<Stand> create(const robot::Robot& robot) { return create(robot, Gains{}); }

  void step(const world::World& world, std::span<double> torques_Nm) noexcept override;

 private:
  Stand() = default;

  Gains gains_;
  std::vector<double> home_rad_;
  std::vector<double> feed_forward_Nm_;
};

}  // namespace farrier::trials
