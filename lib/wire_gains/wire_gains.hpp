#pragma once

// Gains of a slot as they are designed, and as they travel.

#include "control/design/closed_loop.hpp"
#include "plant/joint_physics.hpp"
#include "signals/signals.hpp"

namespace farrier::wire_gains {

/// Gains as they travel. `authority` and `generation` >= 1.
signals::JointControllerGains pack_gains(std::uint16_t joint, signals::Phase phase, std::uint32_t authority,
                                         std::uint32_t generation, const control::Gains& gains) noexcept;

/// The same gains with physics to invert the flow law by; an electric joint has none, and its gains go without.
signals::JointControllerGains with_physics(signals::JointControllerGains gains,
                                           const plant::JointPhysics& physics) noexcept;

/// Gains that came over the wire, as they stand there: whether they may act is for the joint to check.
control::Gains unpack_gains(const signals::JointControllerGains& signal) noexcept;

}  // namespace farrier::wire_gains
