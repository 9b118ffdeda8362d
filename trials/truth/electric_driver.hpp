#pragma once

#include <vector>

#include "robot/robot.hpp"
#include "trials/truth/truth.hpp"

namespace farrier::truth::electric {

/// The command of a run, made of the file's numbers and the sensors' readings. In open loop a torque is asked for by
/// seed and scale and a weak spring holds mid-travel; the third excitation makes the joint follow a position.
class Driver {
 public:
  /// `scale` multiplies the excitation.
  Driver(const robot::Joint& joint, double period_s, const Plan& plan, double scale);

  /// Command of recorded tick k (negative before recording: no excitation), A, within +-0.8 of the largest.
  double command_A(int k, double position, double velocity) const;

 private:
  struct Reference {
    double position, velocity, torque;
  };
  Reference reference(int k) const;

  double middle_, constant_, most_A_, back_emf_;
  double stiffness_ = 0.0, damping_ = 0.0;
  std::vector<double> drive_;  ///< by recorded tick: torque, Nm, or position from the middle, rad
  bool follows_;
  double inertia_, period_s_;
};

}  // namespace farrier::truth::electric
