#include "report/walk/walk.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "body/model/posture.hpp"
#include "core/units.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr double kPercent = 100.0;
constexpr double kMinute_s = 60.0;
constexpr double kLeastJudged_s = 1.0;

// Bounds on level ground without disturbances.
constexpr double kHeightRms_mm = 10.0, kHeightOffset_mm = 15.0, kTilt_deg = 1.0, kSpeed_percent = 5.0;

Eigen::Quaterniond attitude_of(const signals::BodyTruth& truth) {
  return {truth.attitude[0], truth.attitude[1], truth.attitude[2], truth.attitude[3]};
}

double heading_rad(const Eigen::Quaterniond& attitude) {
  const Eigen::Vector3d ahead = attitude * Eigen::Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

std::string reason_of(const body::Posture& posture, const signals::BodyTruth& truth) {
  const bool pushed = Eigen::Vector3d(truth.push_N.data()).norm() > 0.0;
  return "the trunk tilts by " + short_number(posture.tilt_rad * kDegrees) + " degrees at a height of " +
         short_number(posture.height_m) + " m" + (pushed ? " while it is pushed" : "");
}

/// Sums over the judged ticks.
struct Sums {
  double count = 0.0, heights = 0.0, height_squares = 0.0, tilt_squares = 0.0, yaw_rates = 0.0;
  Eigen::Vector3d velocities = Eigen::Vector3d::Zero();

  void add(const body::Posture& posture, const signals::BodyTruth& truth, const Eigen::Quaterniond& attitude) {
    count += 1.0;
    heights += posture.height_m;
    height_squares += posture.height_m * posture.height_m;
    tilt_squares += posture.tilt_rad * posture.tilt_rad;
    velocities += Eigen::AngleAxisd(-heading_rad(attitude), Eigen::Vector3d::UnitZ()) *
                  Eigen::Vector3d(truth.velocity_m_s.data());
    yaw_rates += (attitude * Eigen::Vector3d(truth.angular_velocity_rad_s.data())).z();
  }
};

double speed_error(const WalkPlan& plan, const Sums& sums) {
  const Eigen::Vector2d asked(plan.forward_m_s, plan.left_m_s);
  if (!asked.isZero()) {
    return (sums.velocities.head<2>() / sums.count - asked).norm() / asked.norm();
  }
  const double yaw = std::abs(plan.yaw_rate_rad_s);
  return yaw > 0.0 ? std::abs(sums.yaw_rates / sums.count - plan.yaw_rate_rad_s) / yaw : 0.0;
}

}  // namespace

WalkFigures judge_walk(const WalkPlan& plan, std::span<const signals::BodyTruth> truth) {
  WalkFigures walk;
  Sums sums;
  Eigen::Vector3d start = Eigen::Vector3d::Zero(), last = start;
  double start_height_m = 0.0, start_heading_rad = 0.0, since_s = 0.0;
  bool walks = false;
  for (const signals::BodyTruth& row : truth) {
    const double now_s = static_cast<double>(row.tick) * plan.period_s;
    const Eigen::Vector3d position(row.position_m.data());
    const Eigen::Quaterniond attitude = attitude_of(row);
    const body::Posture posture = body::posture_of(position, attitude, plan.normal);
    if (row.tick == truth.front().tick) {
      start_height_m = posture.height_m;
    }
    for (std::size_t i = 0; i < row.foot_force_N.size(); i += 3) {
      walk.largest_foot_force_N =
          std::max(walk.largest_foot_force_N, Eigen::Vector3d(row.foot_force_N.data() + i).norm());
    }
    if (body::fall_of(posture, start_height_m)) {
      walk.fell_s = now_s;
      walk.reason = reason_of(posture, row);
      break;
    }
    if (now_s < plan.walk_s) {
      continue;
    }
    if (!walks) {
      walks = true;
      start = last = position;
      start_heading_rad = heading_rad(attitude);
    }
    walk.way_m += (position - last).head<2>().norm();
    last = position;
    since_s = now_s - plan.walk_s;
    if (since_s >= kWalkSettles_s) {
      sums.add(posture, row, attitude);
    }
  }
  walk.seconds = sums.count * plan.period_s;
  if (walk.seconds < kLeastJudged_s) {
    return walk;
  }
  const double mean_m = sums.heights / sums.count;
  walk.height_offset_m = mean_m - plan.height_m * plan.normal.z();
  walk.height_rms_m = std::sqrt(std::max(0.0, sums.height_squares / sums.count - mean_m * mean_m));
  walk.tilt_rms_rad = std::sqrt(sums.tilt_squares / sums.count);
  walk.speed_error = speed_error(plan, sums);
  if (plan.yaw_rate_rad_s == 0.0) {
    const Eigen::Vector3d way = Eigen::AngleAxisd(-start_heading_rad, Eigen::Vector3d::UnitZ()) * (last - start);
    const Eigen::Vector2d asked(plan.forward_m_s, plan.left_m_s);
    const Eigen::Vector2d along = asked.isZero() ? Eigen::Vector2d::Zero() : Eigen::Vector2d(asked.normalized());
    walk.lateral_drift_m_min = (along.x() * way.y() - along.y() * way.x()) / since_s * kMinute_s;
  }
  return walk;
}

void add_walk(Figures& figures, const WalkPlan& plan, const WalkFigures& walk) {
  const auto bound = [&plan](double value) { return plan.plain ? std::optional(value) : std::nullopt; };
  figures.add("trot.body.falls", walk.fell_s ? 1.0 : 0.0, 0.0);
  figures.add("trot.body.way_m", walk.way_m);
  figures.add("trot.body.largest_foot_force_N", walk.largest_foot_force_N);
  if (walk.fell_s) {
    figures.add("trot.body.fell_s", *walk.fell_s);
  }
  if (walk.seconds < kLeastJudged_s) {
    return;
  }
  figures.add("trot.body.height_rms_mm", kMillimetres * walk.height_rms_m, bound(kHeightRms_mm));
  figures.add("trot.body.height_offset_mm", kMillimetres * std::abs(walk.height_offset_m), bound(kHeightOffset_mm));
  figures.add("trot.body.tilt_rms_deg", kDegrees * walk.tilt_rms_rad, bound(kTilt_deg));
  figures.add("trot.body.speed_error_percent", kPercent * walk.speed_error, bound(kSpeed_percent));
  figures.add("trot.body.lateral_drift_m_min", walk.lateral_drift_m_min);
}

std::string walk_text(const WalkFigures& walk) {
  if (walk.fell_s) {
    return "fell after " + short_number(*walk.fell_s) + " s: " + walk.reason;
  }
  return "walked " + short_number(walk.way_m) + " m without a fall";
}

}  // namespace farrier::report
