#pragma once

#include <vector>

#include "trials/truth/simulator.hpp"
#include "trials/truth/truth.hpp"

namespace farrier::truth {

/// Linear theory of a joint in mid-stroke, from its file; to choose frequencies, levels and gains by.
struct Mechanics {
  double speed_per_A;      ///< m/s or rad/s per A, unloaded, half the supply across each land
  double oil_stiffness;    ///< both chambers, N/m or Nm/rad
  double mass, load_mass, load_damping, load_stiffness;
  double piston_damping;
  double push;             ///< area_a times half the supply, N or Nm
  double stroke, current_max_A;
};
Mechanics mechanics_of(const robot::Joint& joint);

/// The current of a run. In open loop it is given by seed and scale, with a slow term that holds mid-stroke. In closed
/// loop a force controller makes it from its measurements; the slow term then tends to the place of a model of the
/// joint. Every run has calm and strong eighths, in both of its halves.
class Driver {
 public:
  /// `scale` multiplies the excitation; 1 is lively for a joint that is as its file says.
  Driver(const robot::Joint& joint, const Clock& clock, const Plan& plan, double scale);

  /// Current of recorded tick k (negative before recording: no excitation), A, within +-0.8 of the largest.
  double current(int k, const Reading& measured);

 private:
  double bring_back(double off_middle, const Reading& measured) const;
  double track(double reference, const Reading& measured);

  Mechanics mechanics_;
  double period_s_;
  bool closed_loop_;
  double centring_stiffness_;
  std::vector<double> drive_;  ///< by recorded tick: current, A, or force reference, N or Nm
  double model_x_ = 0.0, model_v_ = 0.0, integral_A_ = 0.0;
};

}  // namespace farrier::truth
