#pragma once

#include "control/model/discretise.hpp"
#include "plant/joint_physics.hpp"
#include "plant/linear_model.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// Form of a joint's linear model. By default the valve just opens to extend, which is the sign the thesis designs for
/// and the one with the higher valve gain.
struct ModelForm {
  double valve_sign = 1.0;  ///< +1 extending, -1 retracting, 0 the mean of both
  plant::PistonMass piston = plant::PistonMass::kCounted;
};

/// Sampled model of a joint under a bench load at its home pose. An electric joint has one for all forms and poses.
control::DiscreteModel model_of(const Joint& joint, const plant::LoadParams& load, double period_s,
                                const ModelForm& form = {});

/// Physics of a joint under a bench load as its file knows it. The leakage is that of the effects internal_leakage and
/// valve_deadband: what leaks past the four lands of a shut valve is, at mean pressure, leakage between the chambers.
plant::JointPhysics nominal_physics(const Joint& joint, const plant::LoadParams& load) noexcept;

}  // namespace farrier::robot
