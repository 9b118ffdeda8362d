#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim_bridge/sim_world.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::sim_bridge::testing {

inline SimWorld world_of(const robot::Robot& robot, std::uint64_t seed = 1) {
  return SimWorld::create(robot, seed).value();
}

inline trace::TraceRow row_of(const SimWorld& world, std::size_t joint) {
  trace::TraceRow row;
  world.describe(joint, row);
  return row;
}

inline std::vector<double> shut(const SimWorld& world) { return std::vector<double>(world.joints(), 0.0); }

/// The numbers of a joint's motion, bit for bit.
inline bool same_state(const trace::TraceRow& one, const trace::TraceRow& other) {
  return one.position_m_or_rad == other.position_m_or_rad &&
         one.velocity_m_s_or_rad_s == other.velocity_m_s_or_rad_s && one.pressure_a_Pa == other.pressure_a_Pa &&
         one.pressure_b_Pa == other.pressure_b_Pa;
}

inline void expect_finite(const trace::TraceRow& row) {
  for (const double value : {row.position_m_or_rad, row.velocity_m_s_or_rad_s, row.force_N_or_Nm, row.pressure_a_Pa,
                             row.pressure_b_Pa, row.external_force_N_or_Nm, row.load_mass_kg_or_kgm2}) {
    ASSERT_TRUE(std::isfinite(value)) << "joint " << row.joint << " at tick " << row.tick;
  }
}

}  // namespace farrier::sim_bridge::testing
