#pragma once

#include <cstdint>
#include <vector>

#include "plant/actuator.hpp"

namespace farrier::bench {

inline constexpr double kBenchPeriod_s = 1e-3;
inline constexpr int kBenchJoints = 12;

/// One joint of the plant benchmark: its machine, the inputs of every tick and where a fine reference ends up.
struct BenchJoint {
  plant::ActuatorParams actuator;
  plant::LoadParams stance;
  plant::LoadParams swing;
  bool stance_first = false;
  plant::State start;
  std::vector<double> current_A;        ///< per tick
  std::vector<plant::State> reference;  ///< after each tick

  const plant::LoadParams& load_at(int tick) const;
  bool load_changes_at(int tick) const;
};

/// Four legs of one rotary motor and two cylinders, driven for `ticks` by seeded noise, with their references: a
/// classical Runge-Kutta method of 2.5 us steps.
std::vector<BenchJoint> make_bench_joints(int ticks);

/// Sums squared distances to the reference, in units of stroke, velocity_scale() and supply pressure.
class BenchErrorMeter {
 public:
  void add(const BenchJoint& joint, int tick, const plant::State& state);
  double rms() const;

 private:
  double sum_ = 0.0;
  double count_ = 0.0;
};

}  // namespace farrier::bench
