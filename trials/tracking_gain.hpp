#pragma once

#include <cstdint>

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::trials {

/// Force tracking of one joint in closed loop: JointNode with gains for the joint it believes in, on the plant and the
/// sensors of the joint as it is, under its swing load at home.
struct ForceTracking {
  double period_s = 0.001;
  double duration_s = 3.0;   ///< judged, after `settle_s`; > 0
  double settle_s = 0.5;     ///< >= 0
  std::uint64_t seed = 1;    ///< of phases, levels and the sensors' noise
};

/// RMS of the true load-cell force less its reference, over the reference's standard deviation; 1 and more is a loop
/// that swings. The reference resembles that of a trot. It has sines of 2, 5 and 10 Hz (Hubacher 2014, Fig. 7.2), and a
/// level that changes each 0.25 s within 20 ms, as where a foot lands or lifts.
///
/// Three limits give the reference's size; the least counts. By linear theory, with all its parts at their largest at
/// once, it moves the load by at most a quarter of the stroke and at half the speed that the world's valve gives. It
/// asks for at most a quarter of the force that the joint may. A load without a spring is led home by one, which is
/// part of the reference. Refuses a joint that cannot be simulated, and a belief for which there are no gains, with the
/// reason.
///
/// Depends on nothing but its arguments. `world` and `believed` are the same joint but for effects and loads.
Result<double> tracking_nrmse(const robot::Joint& world, const robot::Joint& believed, const ForceTracking& run = {});

/// Gain of a controller from knowing the effects of its joint: both run on the same joint, with the same seed.
struct TrackingGain {
  double old_nrmse;  ///< designed for the nominal joint
  double new_nrmse;  ///< designed for, and compensating, the effects it knows
};

/// `known`: `nominal` with what was found; `world`: with what is there.
Result<TrackingGain> tracking_gain(const robot::Joint& world, const robot::Joint& nominal, const robot::Joint& known,
                                   const ForceTracking& run = {});

}  // namespace farrier::trials
