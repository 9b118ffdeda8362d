#pragma once

// Iterated extended Kalman filter of motion and unknowns together:
//
//   x, v, F_s, i_v ──▶ GreyBoxModel::pass ──▶ prediction errors ──▶ a change of load? ──▶ correct, again until at rest

#include <Eigen/Core>

#include "estimation/grey_box_model.hpp"

namespace farrier::estimation {

using GreyBoxCovariance = Eigen::Matrix<double, kGreyBoxStates, kGreyBoxStates>;

/// Assumed noise. Variances per tick.
struct GreyBoxNoise {
  Eigen::Vector3d sensor_variance;  ///< of position, velocity, force; > 0
  double force_variance = 0.0;      ///< of force on the load that no term has
  double flow_error = 0.0;          ///< share of the valve's flow at supply pressure
  Unknowns drift_variance = Unknowns::Zero();
  double bent_velocity_variance = 0.0;  ///< on end stops and voids, and while nothing is learnt
  double bent_pressure_variance = 0.0;
};

/// Starting point of the filter after a change of load.
struct GreyBoxRestart {
  Unknowns unknowns;             ///< only mass and damping are used
  double mass_variance = 0.0;    ///< of its logarithm
  double damping_variance = 0.0;
  double threshold = 0.0;        ///< GreyBoxParams::change_threshold
};

class GreyBoxFilter {
 public:
  enum class Outcome { kTaken, kChanged, kRepaired };

  GreyBoxFilter(const GreyBoxModel& model, const GreyBoxNoise& noise, const GreyBoxRestart& restart,
                const Unknowns& unknowns, const Unknowns& variance, double period_s) noexcept;

  /// Sets the motion to the measurement; the unknowns stay.
  void anchor(const Eigen::Vector3d& measured) noexcept;

  /// Takes a tick: `current_A` acted since the last, `measured` is position, velocity, force now. With `learn` false
  /// the motion follows and the unknowns stay. All finite. At most kMostPasses predictions.
  Outcome step(const Eigen::Vector3d& measured, double current_A, bool learn) noexcept;

  const Unknowns& unknowns() const noexcept { return unknowns_; }
  Eigen::Matrix<double, kUnknowns, kUnknowns> covariance() const noexcept {
    return covariance_.bottomRightCorner<kUnknowns, kUnknowns>();
  }
  /// Squared, normalised prediction error of the last step: 3 on average when the model and the noise are right.
  double surprise() const noexcept { return surprise_; }

  /// The load's share of the estimate (the first five unknowns), saved and restored when the phase of a leg changes.
  struct Load {
    Eigen::Matrix<double, 5, 1> unknowns;
    Eigen::Matrix<double, 5, 5> covariance;
  };
  Load load() const noexcept;
  void set_load(const Load& load) noexcept;

  static constexpr int kMostPasses = 10;

 private:
  struct Prediction;
  Prediction predict(const Unknowns& about, double current_A, bool learn) const noexcept;
  double surprise_of(const Prediction& prediction, const Eigen::Vector3d& error) const noexcept;
  void load_changed() noexcept;
  void keep_within_bounds() noexcept;
  void begin_anew(const Eigen::Vector3d& measured) noexcept;

  GreyBoxModel model_;
  GreyBoxNoise noise_;
  GreyBoxRestart restart_;
  Unknowns first_unknowns_, first_variance_;
  double period_s_;
  Motion motion_ = Motion::Zero();
  Unknowns unknowns_;
  GreyBoxCovariance covariance_;
  double surplus_ = 0.0;  // surprise beyond the expectation from noise, summed
  double surprise_ = 0.0;
  int ticks_since_change_ = 0;
};

}  // namespace farrier::estimation
