#include "trials/vary.hpp"

#include "core/noise.hpp"

namespace farrier::trials {
namespace {

double draw_within(const robot::Interval& range, std::uint64_t seed, const std::string& name, const char* quantity) noexcept {
  return range.low + (range.high - range.low) * NoiseStream(seed, name, quantity).uniform(0);
}

/// A load whose mass grows in stance carries the body; one that stays is the leg itself.
bool carries_the_body(const robot::Joint& joint) noexcept { return joint.stance_load.mass != joint.swing_load.mass; }

}  // namespace

robot::Robot with_varied_body(robot::Robot nominal) {
  if (nominal.variation.body_mass_kg > 0.0 && nominal.file.body) {
    nominal.plan.body_weight_N = nominal.file.body->gravity_m_s2 * nominal.variation.body_mass_kg;
  }
  return nominal;
}

Draw draw_variation(const robot::Robot& nominal, std::uint64_t seed) {
  const robot::Variation& within = nominal.variation;
  Draw draw{.supply_factor = draw_within(within.supply_factor, seed, nominal.name, "vary.supply"), .joints = {}};
  for (const robot::Joint& joint : nominal.joints) {
    draw.joints.push_back({.friction_factor = draw_within(within.friction_factor, seed, joint.name, "vary.friction"),
                           .valve_factor = draw_within(within.valve_gain_factor, seed, joint.name, "vary.valve"),
                           .stance_mass = carries_the_body(joint)
                                              ? draw_within(within.stance_mass_kg, seed, joint.name, "vary.stance_mass")
                                              : joint.stance_load.mass});
  }
  return draw;
}

robot::Robot varied(const robot::Robot& nominal, const Draw& draw) {
  robot::Robot robot = nominal;
  for (robot::Joint& joint : robot.joints) {
    const JointDraw& drawn = draw.joints[joint.number];
    joint.actuator.supply_pressure_Pa *= draw.supply_factor;
    joint.actuator.valve_gain *= drawn.valve_factor;
    joint.swing_load.damping *= drawn.friction_factor;
    joint.stance_load.damping *= drawn.friction_factor;
    joint.stance_load.mass = drawn.stance_mass;
  }
  return robot;
}

}  // namespace farrier::trials
