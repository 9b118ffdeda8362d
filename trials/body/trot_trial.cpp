#include "trials/body/trot_trial.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <mutex>
#include <numbers>
#include <thread>

#include "robot/locomotion_model.hpp"
#include "robot/locomotion_params.hpp"
#include "trials/body/actuated_robot.hpp"
#include "trials/body/controller_driver.hpp"
#include "world/scene_file.hpp"

namespace farrier::trials {
namespace {

constexpr double kLeastWay_m = 1.0;
constexpr double kDeepSag_m = 0.02;

double heading_rad(const Eigen::Matrix3d& rotation) { return std::atan2(rotation(1, 0), rotation(0, 0)); }

double wrapped_rad(double angle_rad) { return std::remainder(angle_rad, 2.0 * std::numbers::pi); }

// FNV-1a over words of 64 bits.
void add_to_hash(std::uint64_t& hash, double number) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3ull;
}

/// Compares truth and estimate tick by tick.
class Judge {
 public:
  Judge(const world::BodyWorld& world, const locomotion::TrotController& controller, const TrotCase& one,
        double period_s, double height_m)
      : world_(world), controller_(controller), one_(one), period_s_(period_s), height_m_(height_m) {}

  void observe() {
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
    }
  }

  TrotFigures figures(const BodyFigures& body) const {
    TrotFigures figures;
    if (!body.passes()) {
      figures.fell_s = static_cast<double>(body.ticks) * period_s_;
      figures.fall = body.fall ? to_string(*body.fall) : body.failure.value_or("");
    }
    figures.largest_torque_Nm = *std::ranges::max_element(body.largest_torque_Nm);
    figures.sag_m = sag_m_;
    figures.hash = hash_;
    if (count_ > 0) {
      const double n = count_;
      const double mean_m = heights_m_ / n;
      figures.height_offset_m = mean_m - height_m_;
      figures.height_rms_m = std::sqrt(std::max(0.0, height_squares_m2_ / n - mean_m * mean_m));
      figures.tilt_rms_rad = std::sqrt(tilt_squares_ / n);
      figures.speed_error = speed_error();
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

  /// Of the trunk above the ground's plane.
  double height_m() const { return height_of(world_.state()); }

 private:
  static constexpr double kSettled_s = 4.0;

  double height_of(const body::BodyState& is) const {
    const Eigen::Vector3d normal = world_.ground_normal();
    return normal.dot(is.position_m) / normal.z();
  }

  void note_state(const body::BodyState& is) {
    for (const double number : is.position_m) add_to_hash(hash_, number);
    for (const double number : is.attitude.coeffs()) add_to_hash(hash_, number);
    for (const double number : is.velocity()) add_to_hash(hash_, number);
    for (const double number : is.angles_rad) add_to_hash(hash_, number);
  }

  // Way since the trot began, to the left of the commanded line.
  double to_the_left_m(const Eigen::Vector3d& place_m) const {
    const locomotion::MotionCommand& asked = one_.judged_command();
    const Eigen::Vector2d direction =
        Eigen::Rotation2Dd(heading_) * Eigen::Vector2d(asked.forward_m_s, asked.left_m_s).normalized();
    const Eigen::Vector2d way = (place_m - start_).head<2>();
    return direction.x() * way.y() - direction.y() * way.x();
  }

  std::optional<double> lateral_drift_m_s() const {
    const locomotion::MotionCommand& asked = one_.judged_command();
    if (asked.yaw_rate_rad_s != 0.0 || (asked.forward_m_s == 0.0 && asked.left_m_s == 0.0)) {
      return std::nullopt;
    }
    return (to_the_left_m(judged_last_) - to_the_left_m(judged_start_)) / (count_ * period_s_);
  }

  void note_motion(const body::BodyState& is, const Eigen::Matrix3d& rotation) {
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

  double speed_error() const {
    const locomotion::MotionCommand& asked = one_.judged_command();
    const Eigen::Vector2d velocity(asked.forward_m_s, asked.left_m_s);
    if (velocity.isZero()) {
      return std::abs(yaw_rates_ / count_ - asked.yaw_rate_rad_s) / std::abs(asked.yaw_rate_rad_s);
    }
    return (velocities_.head<2>() / count_ - velocity).norm() / velocity.norm();
  }

  const world::BodyWorld& world_;
  const locomotion::TrotController& controller_;
  const TrotCase& one_;
  double period_s_;
  double height_m_;
  bool started_ = false;
  Eigen::Vector3d start_, last_, estimated_start_, estimated_last_, judged_start_, judged_last_;
  double heading_ = 0.0;  // when the trot began
  double heading_error_ = 0.0, heading_drift_ = 0.0, since_s_ = 0.0, way_m_ = 0.0, sag_m_ = 0.0;
  double heights_m_ = 0.0, height_squares_m2_ = 0.0, tilt_squares_ = 0.0, yaw_rates_ = 0.0, count_ = 0.0;
  Eigen::Vector3d velocities_ = Eigen::Vector3d::Zero();
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

// The robot with another trunk mass of the same shape.
robot::Robot with_trunk_mass(const robot::Robot& robot, double mass_kg) {
  robot::Robot heavier = robot;
  body::RigidInertia& trunk = heavier.body->trunk;
  trunk.tensor_kg_m2 *= mass_kg / trunk.mass_kg;
  trunk.mass_kg = mass_kg;
  return heavier;
}

ForceErrors force_nrmse_of(const ActuatedRobot& robot) {
  ForceErrors all{};
  for (std::size_t place = 0; place < all.size(); ++place) {
    for (const Phase phase : {Phase::kSwing, Phase::kStance}) {
      const ActuatedRobot::Tracking& sums = robot.tracking(place)[phase];
      all[place][static_cast<std::size_t>(phase)] = sums.reference > 0.0 ? std::sqrt(sums.error / sums.reference) : 0.0;
    }
  }
  return all;
}

void note_supply(const ActuatedRobot& robot, double time_s, TrotFigures& figures) {
  const world::Actuators& actuators = *robot.robot().actuators();
  if (const plant::Supply* supply = actuators.supply(); supply != nullptr && time_s > 0.0) {
    const plant::SupplyAccount& account = supply->account();
    figures.energy_error = std::abs(actuators.lost_J()) / account.pump_J;
    figures.least_supply_Pa = robot.least_supply_Pa();
    figures.mean_flow_m3_s = (account.actuators_m3 + account.leakage_m3) / time_s;
  }
}

}  // namespace

Result<std::optional<TrotFigures>> run_trot_case(const robot::Robot& robot, const TrotCase& one, Joints joints,
                                                 const std::function<bool()>& keep_on) {
  if (!robot.body || !robot.locomotion) {
    return Error{robot.name + " cannot walk on a ground: give body.trunk and locomotion in its file"};
  }
  const auto scene = world::load_scene_text(one.scene, one.trial + ", " + one.name);
  if (!scene) {
    return Error{config::to_string(scene.error())};
  }
  const robot::Robot true_robot = with_trunk_mass(robot, one.trunk_mass_kg.value_or(robot.body->trunk.mass_kg));
  const auto model = FARRIER_TRY(robot::LocomotionModel::create(*robot.body));
  locomotion::TrotController controller(*robot.locomotion, robot::locomotion_plan(robot.plan), model);
  ControllerDriver driver(controller, one.script, robot.period_s, one.lag_ticks);
  std::optional<world::BodyWorld> ideal;
  std::optional<ActuatedRobot> actuated;
  if (joints == Joints::kIdeal) {
    ideal.emplace(FARRIER_TRY(world::BodyWorld::create(true_robot, scene.value(), one.seed, kTrotNoise)));
  } else {
    actuated.emplace(FARRIER_TRY(ActuatedRobot::create(robot, true_robot, scene.value(), one.seed)));
    actuated->track_from(static_cast<Tick>(std::lround(one.judged_from_s / robot.period_s)));
  }
  world::World& moved = ideal ? static_cast<world::World&>(*ideal) : *actuated;
  const world::BodyWorld& truth = ideal ? *ideal : actuated->robot().body();
  Judge judge(truth, controller, one, robot.period_s, robot.locomotion->reference.default_height_m);
  std::optional<SupplyJudge> supply_judge;
  if (actuated && robot.supply_guard) {
    driver.guard_supply(*robot.supply_guard);
    if (one.supply_fault_s) {
      supply_judge.emplace(*robot.supply_guard, *robot.locomotion, *one.supply_fault_s, kDeepSag_m);
    }
  }
  bool stopped = false;
  const auto ticks = static_cast<Tick>(std::lround(one.end_s / robot.period_s));
  const BodyFigures body = run_body_trial(
      moved, truth, driver, ticks,
      [&] {
        judge.observe();
        if (supply_judge) {
          supply_judge->observe(static_cast<double>(truth.tick()) * robot.period_s, truth, judge.height_m(),
                                moved.supply()->pressure_Pa, driver.demand());
        }
        stopped = keep_on && !keep_on();
        return !stopped;
      },
      one.may_sink);
  if (stopped) {
    return std::optional<TrotFigures>();
  }
  TrotFigures figures = judge.figures(body);
  if (actuated) {
    figures.force_nrmse = force_nrmse_of(*actuated);
    figures.supply = supply_judge ? std::optional(supply_judge->figures()) : std::nullopt;
    note_supply(*actuated, static_cast<double>(body.ticks) * robot.period_s, figures);
  }
  return std::optional(figures);
}

void run_trot_cases(const robot::Robot& robot, std::span<const TrotCase> cases, Joints joints, int threads,
                    const std::function<void(const TrotRow&)>& done, const std::function<bool()>& keep_on) {
  std::atomic<std::size_t> next{0};
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size(); i = next++) {
      TrotRow row{.trial = cases[i].trial, .name = cases[i].name, .figures = {}, .failure = {}};
      const auto ran = run_trot_case(robot, cases[i], joints, keep_on);
      if (ran && !ran.value()) {
        return;
      }
      if (ran) {
        row.figures = *ran.value();
      } else {
        row.failure = ran.error().message;
      }
      const std::lock_guard lock(telling);
      done(row);
    }
  };
  std::vector<std::thread> beside;
  for (int thread = 1; thread < threads; ++thread) {
    beside.emplace_back(work);
  }
  work();
  for (std::thread& thread : beside) {
    thread.join();
  }
}

}  // namespace farrier::trials
