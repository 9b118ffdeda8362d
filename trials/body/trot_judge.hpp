#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "trials/body/trot_trial.hpp"

namespace farrier::trials {

/// Compares truth and estimate tick by tick.
class TrotJudge {
 public:
  TrotJudge(const world::BodyWorld& world, const locomotion::TrotController& controller, const TrotCase& one,
            double period_s, double height_m)
      : world_(world), controller_(controller), one_(one), period_s_(period_s), height_m_(height_m) {}

  void observe();

  TrotFigures figures(const BodyFigures& body) const;

  /// Height of the trunk above the ground's plane.
  double height_m() const { return height_of(world_.state()); }

 private:
  static constexpr double kSettled_s = 4.0;

  double height_of(const body::BodyState& is) const;

  void note_state(const body::BodyState& is);

  // Way since the trot began, to the left of the commanded line.
  double to_the_left_m(const Eigen::Vector3d& place_m) const;

  std::optional<double> lateral_drift_m_s() const;

  void note_motion(const body::BodyState& is, const Eigen::Matrix3d& rotation);

  double speed_error() const;

  const world::BodyWorld& world_;
  const locomotion::TrotController& controller_;
  const TrotCase& one_;
  double period_s_;
  double height_m_;
  bool started_ = false;
  Eigen::Vector3d start_, last_, estimated_start_, estimated_last_, judged_start_, judged_last_;
  double heading_ = 0.0;  // when the trot began
  double heading_error_ = 0.0, heading_drift_ = 0.0, since_s_ = 0.0, way_m_ = 0.0, sag_m_ = 0.0;
  std::optional<double> loaded_sag_m_;
  double heights_m_ = 0.0, height_squares_m2_ = 0.0, tilt_squares_ = 0.0, yaw_rates_ = 0.0, count_ = 0.0;
  Eigen::Vector3d velocities_ = Eigen::Vector3d::Zero();
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace farrier::trials
