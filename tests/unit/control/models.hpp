#pragma once

#include <cmath>
#include <cstdint>

#include "control/design/lqr.hpp"
#include "core/noise.hpp"

namespace farrier::control::testing {

inline constexpr double kPeriodS = 1e-3;

/// Half the stroke 0.04 m, 1.2 m/s, 5000 N, 10 mA: Hubacher (2014) (3.52), (3.53).
inline constexpr Normalisation kNormalisation{0.04, 1.2, 5000.0, 0.01};

/// Cylinder of Hubacher (2014) Table A.1 with what rigs change about it.
struct Rig {
  double bulk_modulus_Pa;
  double line_volume_m3;
  double valve_gain;  // m^3/s/(A sqrt(Pa))
  double supply_Pa;
  double load_mass_kg;
  double load_damping;    // Ns/m
  double load_stiffness;  // N/m
};

/// FC1D, Table A.2, line volume of 0.6 m of 3.8 mm bore, springs k_1 + k_2 of Table A.1.
inline Rig fc1d(double mass_kg, double stiffness = 21480.0) {
  return {5.5e8, 6.8047e-6, 1.6704e-6, 125e5, mass_kg, 500.0, stiffness};
}

/// HyQ's valve, hose and oil on the same cylinder; a leg has no load spring.
inline Rig hyq(double mass_kg, double damping = 500.0) {
  return {1.8181e9, 8.17e-6, 6.12e-6, 160e5, mass_kg, damping, 0.0};
}

struct ContinuousModel {
  Eigen::Matrix3d a;
  Eigen::Vector3d b;
};

/// (3.43)-(3.51) at mid-stroke, at rest, u -> 0+, with row 2 from (3.47).
inline ContinuousModel force_model(const Rig& rig) {
  constexpr double kArea = 2.0106e-4;
  constexpr double kAlpha = 0.6094;
  constexpr double kHalfStroke = 0.04;
  constexpr double kPistonDamping = 700.0;
  const double volume_a = rig.line_volume_m3 + kHalfStroke * kArea;
  const double volume_b = rig.line_volume_m3 + kHalfStroke * kAlpha * kArea;
  const double compliance = rig.bulk_modulus_Pa * (1.0 / volume_a + kAlpha * kAlpha / volume_b);
  const double m = rig.load_mass_kg;
  ContinuousModel model;
  model.a << 0.0, 1.0, 0.0,                                             //
      -rig.load_stiffness / m, -rig.load_damping / m, 1.0 / m,          //
      kPistonDamping * rig.load_stiffness / m,                          //
      kPistonDamping * rig.load_damping / m - kArea * kArea * compliance,  //
      -kPistonDamping / m;
  const double valve = rig.valve_gain / std::sqrt(1.0 + kAlpha * kAlpha * kAlpha);
  model.b << 0.0, 0.0, kArea * valve * compliance * std::sqrt(rig.supply_Pa);
  return model;
}

inline DiscreteModel sampled(const Rig& rig) {
  const ContinuousModel model = force_model(rig);
  return discretise(model.a, model.b, kPeriodS);
}

inline constexpr std::uint64_t kSeed = 20140131;

/// Standard normal entries addressed by (seed, name, number).
template <class M>
M random_matrix(const char* name, int number) {
  const NoiseStream noise(kSeed, name, "entries");
  M matrix;
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    matrix(i) = noise.normal(number * 64 + i);
  }
  return matrix;
}

/// x[k+1] = a x + b u with the current acting `delay` periods late.
class Plant {
 public:
  Plant(const DiscreteModel& model, int delay) : model_(model), delay_(delay) {}
  const Eigen::Vector3d& state() const { return x_; }
  void step(double current_A) {
    const double acting = delay_ == 0 ? current_A : past_[delay_ - 1];
    x_ = model_.a * x_ + model_.b * acting;
    past_[1] = past_[0];
    past_[0] = current_A;
  }

 private:
  DiscreteModel model_;
  int delay_;
  double past_[2] = {0.0, 0.0};
  Eigen::Vector3d x_ = Eigen::Vector3d::Zero();
};

}  // namespace farrier::control::testing
