#pragma once

// The way of a joint's measurements to its controller:
//
//   truth ──▶ anti-alias filter ──▶ mean of the conversions ──▶ filter of the channel ──▶ equaliser ──▶ controller
//             joint.sensors, run by the sensors                                           run by the joint's node

#include "control/design/measurement_filter.hpp"
#include "control/law/filter_equaliser.hpp"
#include "control/law/signal_aligner.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// A low-pass for each channel.
struct ChannelFilters {
  control::LowPassParams position, velocity, force;
};

/// Filters that make every channel lag as much as the slowest one, at low frequencies. A channel without a filter of its
/// own gets the slowest one's, any other a low-pass of second order for the lag it lacks. None where the joint does not
/// equalise, and for less than half a tick.
ChannelFilters equalisers(const Joint& joint, double period_s) noexcept;

/// Those filters as the joint's node runs them.
control::FilterEqualiser filter_equaliser(const Joint& joint, double period_s) noexcept;

/// Makes the channels of this joint's sensors, and its current, fit for the estimation of a model. Filters that come
/// before the conversions count as none.
control::SignalAligner signal_aligner(const Joint& joint, double period_s) noexcept;

/// The way of each channel, for margins. Effects of sensors are left out: the joint's node corrects them.
control::MeasurementFilters measurement_filters(const Joint& joint, double period_s) noexcept;

/// The robot with the noise of every joint's sensors multiplied by `factor` >= 0. Designs for this robot know it.
Robot with_noise(Robot robot, double factor);

/// "force filter 100 Hz, velocity filter 200 Hz": those that the joint's channels have; empty for none.
std::string filters_text(const Joint& joint);

}  // namespace farrier::robot
