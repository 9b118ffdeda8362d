#include "trials/body/trot_judge.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace farrier::trials {
namespace {

constexpr double kLeastWay_m = 1.0;

double heading_rad(const Eigen::Matrix3d& rotation) { return std::atan2(rotation(1, 0), rotation(0, 0)); }

double wrapped_rad(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

// FNV-1a over words of 64 bits.
void add_to_hash(std::uint64_t& hash, double number) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3ull;
}

}  // namespace

void TrotJudge::observe() {
  const double now_s = static_cast<double>(world_.tick()) * period_s_;
  const body::BodyState& is = world_.state();
  note_state(is);
  if (now_s < one_.trot_s) {
    return;
  }
  const Eigen::Matrix3d rotation = is.attitude.toRotationMatrix();
  const locomotion::TrunkState& estimated = controller_.state().trunk;
  const double heading_error = heading_rad(estimated.rotation) - heading_rad(rotation);
  if (!started_) {
    started_ = true;
    start_ = last_ = is.position_m;
    estimated_start_ = estimated.position_m;
    heading_error_ = heading_error;
    heading_ = heading_rad(rotation);
  }
  way_m_ += (is.position_m - last_).head<2>().norm();
  last_ = is.position_m;
  estimated_last_ = estimated.position_m;
  heading_drift_ = wrapped_rad(heading_error - heading_error_);
  since_s_ = now_s - one_.trot_s;
  if (now_s >= one_.judged_from_s && now_s < one_.judged_until_s) {
    note_motion(is, rotation);
  }
  if (since_s_ >= kSettled_s && now_s < one_.judged_until_s) {
    sag_m_ = std::max(sag_m_, height_m_ - height_of(is));
    if (one_.load_s && now_s >= *one_.load_s + TrotCase::kLoadSettled_s) {
      loaded_sag_m_ = std::max(loaded_sag_m_.value_or(0.0), height_m_ - height_of(is));
    }
  }
}

TrotFigures TrotJudge::figures(const BodyFigures& body) const {
  TrotFigures figures;
  if (!body.passes()) {
    figures.fell_s = static_cast<double>(body.ticks) * period_s_;
    figures.fall = body.fall ? to_string(*body.fall) : body.failure.value_or("");
  }
  figures.largest_torque_Nm = *std::ranges::max_element(body.largest_torque_Nm);
  figures.sag_m = sag_m_;
  figures.loaded_sag_m = loaded_sag_m_;
  figures.hash = hash_;
  if (count_ > 0) {
    const double n = count_;
    const double mean_m = heights_m_ / n;
    figures.height_offset_m = mean_m - height_m_;
    figures.height_rms_m = std::sqrt(std::max(0.0, height_squares_m2_ / n - mean_m * mean_m));
    figures.tilt_rms_rad = std::sqrt(tilt_squares_ / n);
    figures.speed_error = speed_error();
    figures.way_m = (judged_last_ - judged_start_).head<2>().norm();
    figures.lateral_drift_m_s = lateral_drift_m_s();
  }
  if (since_s_ > 0.0) {
    figures.heading_drift_rad_s = heading_drift_ / since_s_;
  }
  if (way_m_ >= kLeastWay_m) {
    // The estimate's world is turned against the true one by the heading error at the start.
    const Eigen::Vector3d way =
        Eigen::AngleAxisd(heading_error_, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(last_ - start_);
    figures.odometry_error = (estimated_last_ - estimated_start_ - way).head<2>().norm() / way_m_;
  }
  return figures;
}

double TrotJudge::height_of(const body::BodyState& is) const {
  const Eigen::Vector3d normal = world_.ground_normal();
  return normal.dot(is.position_m) / normal.z();
}

void TrotJudge::note_state(const body::BodyState& is) {
  for (const double number : is.position_m) add_to_hash(hash_, number);
  for (const double number : is.attitude.coeffs()) add_to_hash(hash_, number);
  for (const double number : is.velocity()) add_to_hash(hash_, number);
  for (const double number : is.angles_rad) add_to_hash(hash_, number);
}

double TrotJudge::to_the_left_m(const Eigen::Vector3d& place_m) const {
  const locomotion::MotionCommand& asked = one_.judged_command();
  const Eigen::Vector2d direction =
      Eigen::Rotation2Dd(heading_) * Eigen::Vector2d(asked.forward_m_s, asked.left_m_s).normalized();
  const Eigen::Vector2d way = (place_m - start_).head<2>();
  return direction.x() * way.y() - direction.y() * way.x();
}

std::optional<double> TrotJudge::lateral_drift_m_s() const {
  const locomotion::MotionCommand& asked = one_.judged_command();
  if (asked.yaw_rate_rad_s != 0.0 || (asked.forward_m_s == 0.0 && asked.left_m_s == 0.0)) {
    return std::nullopt;
  }
  return (to_the_left_m(judged_last_) - to_the_left_m(judged_start_)) / (count_ * period_s_);
}

void TrotJudge::note_motion(const body::BodyState& is, const Eigen::Matrix3d& rotation) {
  if (count_ == 0.0) {
    judged_start_ = is.position_m;
  }
  judged_last_ = is.position_m;
  const double height_m = height_of(is);
  heights_m_ += height_m;
  height_squares_m2_ += height_m * height_m;
  const double tilt = std::acos(std::clamp(world_.ground_normal().dot(rotation.col(2)), -1.0, 1.0));
  tilt_squares_ += tilt * tilt;
  velocities_ += Eigen::AngleAxisd(-heading_rad(rotation), Eigen::Vector3d::UnitZ()) * is.linear_velocity_m_s;
  yaw_rates_ += (rotation * is.angular_velocity_rad_s).z();
  count_ += 1.0;
}

double TrotJudge::speed_error() const {
  const locomotion::MotionCommand& asked = one_.judged_command();
  const Eigen::Vector2d velocity(asked.forward_m_s, asked.left_m_s);
  if (velocity.isZero()) {
    return std::abs(yaw_rates_ / count_ - asked.yaw_rate_rad_s) / std::abs(asked.yaw_rate_rad_s);
  }
  return (velocities_.head<2>() / count_ - velocity).norm() / velocity.norm();
}

}  // namespace farrier::trials
