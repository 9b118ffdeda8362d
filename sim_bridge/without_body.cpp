// In place of body_robot.cpp in a build without the physics engine.

#include "sim_bridge/simulated_robot.hpp"

namespace farrier::sim_bridge {

bool has_physics_engine() noexcept { return false; }

Result<std::unique_ptr<SimulatedRobot>> simulated_body(const robot::Robot&, const std::string&, std::uint64_t, bool) {
  return Error{"this build has no physics engine for --world body: install libmujoco-dev and build again"};
}

}  // namespace farrier::sim_bridge
