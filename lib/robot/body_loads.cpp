#include "robot/body_loads.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "body/dynamics/rigid_body.hpp"
#include "gait/schedule.hpp"

namespace farrier::robot {
namespace {

constexpr double kMiddle = 0.5;

body::Link& link_of(Robot& robot, const Joint& joint) {
  return robot.body->legs[static_cast<std::size_t>(joint.leg)].links[static_cast<std::size_t>(joint.index_in_leg)];
}

double lever_at_home(const Joint& joint) { return joint.linkage.lever(joint.home_angle_rad); }

/// Inertia of the actuator that moves with the joint at all times, actuator coordinates. A rotor behind a spring does not.
double piston_mass(const Joint& joint) {
  if (joint.electric) {
    return joint.electric->rigid ? plant::armature_kg_m2(*joint.electric) : 0.0;
  }
  return joint.actuator.piston_mass;
}

/// The legs that stand by plan in the middle of a leg's swing or stance, of a stride after the first.
std::vector<int> standing_legs(const gait::Schedule& schedule, int legs, int leg, Phase phase) {
  const Tick from = schedule.lead_in_ticks() + 2 * schedule.stride_ticks();
  for (Tick tick = from; tick < from + schedule.stride_ticks(); ++tick) {
    const auto progress = [&](Tick at) {
      return phase == Phase::kSwing ? schedule.swing_progress(leg, at) : schedule.stance_progress(leg, at);
    };
    if (progress(tick) >= 0.0 && progress(tick) < kMiddle && progress(tick + 1) >= kMiddle) {
      std::vector<int> standing;
      for (int other = 0; other < legs; ++other) {
        if (schedule.phase(other, tick) == Phase::kStance) {
          standing.push_back(other);
        }
      }
      return standing;
    }
  }
  std::vector<int> standing;
  for (int other = 0; other < legs; ++other) {
    if (phase == Phase::kStance || other != leg) {
      standing.push_back(other);
    }
  }
  return standing;
}

}  // namespace

body::JointVector joint_inertias_kg_m2(const body::BodyModel& model, const body::JointVector& angles_rad,
                                       std::span<const int> standing) {
  auto body = body::RigidBody::create(model).value();
  body::BodyState state = body::BodyState::zero(body.joints());
  state.angles_rad = angles_rad;
  body.set_state(state);
  const Eigen::MatrixXd mass = body.mass_matrix();
  Eigen::MatrixXd mobility = mass.ldlt().solve(Eigen::MatrixXd::Identity(mass.rows(), mass.cols()));
  if (!standing.empty()) {
    Eigen::MatrixXd feet(3 * static_cast<Eigen::Index>(standing.size()), mass.cols());
    for (std::size_t i = 0; i < standing.size(); ++i) {
      feet.middleRows<3>(3 * static_cast<Eigen::Index>(i)) = body.foot_jacobian(standing[i]);
    }
    const Eigen::MatrixXd moved = feet * mobility;
    const Eigen::MatrixXd held = moved * feet.transpose();
    mobility -= moved.transpose() * held.ldlt().solve(moved);
  }
  return mobility.diagonal().tail(body.joints()).cwiseInverse();
}

void put_loads_of_body(Robot& robot) {
  body::JointVector home(static_cast<Eigen::Index>(robot.joints.size()));
  for (const Joint& joint : robot.joints) {
    home[joint.number] = joint.home_angle_rad;
    const double lever = lever_at_home(joint);
    link_of(robot, joint).armature_kg_m2 = piston_mass(joint) * lever * lever;
  }
  const gait::Schedule schedule(robot.plan, 0);
  const auto legs = static_cast<int>(robot.plan.legs.size());
  for (int leg = 0; leg < legs; ++leg) {
    for (const Phase phase : {Phase::kSwing, Phase::kStance}) {
      const body::JointVector inertias =
          joint_inertias_kg_m2(*robot.body, home, standing_legs(schedule, legs, leg, phase));
      for (gait::JointPlan& planned : robot.plan.legs[static_cast<std::size_t>(leg)].joints) {
        Joint& joint = robot.joints[planned.joint];
        const double square = lever_at_home(joint) * lever_at_home(joint);
        plant::LoadParams& load = phase == Phase::kSwing ? joint.swing_load : joint.stance_load;
        load.mass = inertias[joint.number] / square - piston_mass(joint);
        load.damping = link_of(robot, joint).damping_Nms_rad / square;
        (phase == Phase::kSwing ? planned.swing_load : planned.stance_load) = load;
      }
    }
  }
}

}  // namespace farrier::robot
