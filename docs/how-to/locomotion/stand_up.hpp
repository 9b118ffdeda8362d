#pragma once

// A controller of one's own, as docs/how-to/write-a-locomotion-process.md explains it.

#include <algorithm>

#include "gait/gait_params.hpp"
#include "gait/leg_kinematics.hpp"
#include "gait/smooth_step.hpp"
#include "locomotion/controller.hpp"
#include "locomotion/rotation.hpp"

namespace farrier::locomotion {

/// Moves all feet down from where they are to `height_m` below the hips, by springs in the joints. Equal forces at the
/// feet carry the weight: tau = h - J^T f + K (q_d - q) - D q'.
class StandUp final : public Controller {
 public:
  StandUp(const BodyModel& model, const gait::RobotPlan& plan, double height_m)
      : model_(model), plan_(plan), height_m_(height_m) {
    torques_.fill(Eigen::Vector3d::Zero());
  }

  const LegTorques& step(Tick now, const Readings& readings, const MotionCommand&) noexcept override {
    constexpr double kRise_s = 3.0, kStiffness_Nm_rad = 300.0, kDamping_Nms_rad = 12.0;
    if (!started_) {
      start_ = readings.legs;
      started_ = true;
    }
    // an upright trunk: this example has no estimator
    model_.update({readings.legs.data(), plan_.legs.size()}, {.gravity_m_s2 = {0.0, 0.0, -kGravity_m_s2}}, body_);
    const double progress = gait::smooth_step(static_cast<double>(now) * plan_.period_s / kRise_s).value;
    const double weight_N = model_.mass_kg() * kGravity_m_s2 / static_cast<double>(plan_.legs.size());
    for (std::size_t i = 0; i < plan_.legs.size(); ++i) {
      const gait::LegGeometry& geometry = plan_.legs[i].geometry;
      Eigen::Vector3d foot = gait::fk(geometry, start_[i].position_rad);
      foot.z() += progress * (-height_m_ - foot.z());
      const Eigen::Vector3d wanted = gait::ik(geometry, foot).value_or(readings.legs[i].position_rad);
      const Eigen::Vector3d force{0.0, 0.0, std::min(1.0, 2.0 * progress) * weight_N};
      torques_[i] = body_.legs[i].bias_torque_Nm - body_.legs[i].jacobian.transpose() * force +
                    kStiffness_Nm_rad * (wanted - readings.legs[i].position_rad) -
                    kDamping_Nms_rad * readings.legs[i].velocity_rad_s;
    }
    return torques_;
  }

 private:
  const BodyModel& model_;
  const gait::RobotPlan& plan_;
  double height_m_;
  bool started_ = false;
  PerLeg<LegReadings> start_;
  BodyState body_;
  LegTorques torques_;
};

}  // namespace farrier::locomotion
