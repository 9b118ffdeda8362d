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
#include "trials/body/trot_judge.hpp"
#include "world/scene_file.hpp"

namespace farrier::trials {
namespace {

constexpr double kDeepSag_m = 0.02;

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
    figures.energy_error = std::abs(actuators.audit().residual_J()) / account.pump_J;
    figures.energy = robot.energy();
    figures.least_supply_Pa = robot.least_supply_Pa();
    figures.mean_flow_m3_s = (account.actuators_m3 + account.leakage_m3) / time_s;
  }
}

}  // namespace

Result<std::optional<TrotFigures>> run_trot_case(const robot::Robot& robot, const TrotCase& one, Joints joints,
                                                 const std::function<bool()>& keep_on,
                                                 const ActuatedRobot::Listener& listener) {
  if (!robot.can_walk()) {
    return Error{robot.cannot_walk_error()};
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
    actuated.emplace(FARRIER_TRY(
        ActuatedRobot::create(robot, true_robot, scene.value(), one.seed, one.finer, one.adapts, one.knows)));
    actuated->listen(listener);
    driver.tell_phases(*actuated);
    actuated->track_from(static_cast<Tick>(std::lround(one.judged_from_s / robot.period_s)));
  }
  world::World& moved = ideal ? static_cast<world::World&>(*ideal) : *actuated;
  const world::BodyWorld& truth = ideal ? *ideal : actuated->robot().body();
  TrotJudge judge(truth, controller, one, robot.period_s, robot.locomotion->reference.default_height_m);
  std::optional<SupplyJudge> supply_judge;
  if (actuated && robot.supply_guard) {
    driver.guard_supply(*robot.supply_guard);
    if (one.fault_s) {
      supply_judge.emplace(*robot.supply_guard, *robot.locomotion, *one.fault_s, kDeepSag_m);
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
                                moved.supply()->pressure_Pa, driver.demand(),
                                controller.state().dead_joint.has_value());
        }
        stopped = keep_on && !keep_on();
        return !stopped;
      },
      one.may_sink);
  if (stopped) {
    return std::optional<TrotFigures>();
  }
  TrotFigures figures = judge.figures(body);
  figures.finer = one.finer;
  if (actuated) {
    figures.force_nrmse = force_nrmse_of(*actuated);
    figures.switches = actuated->switches();
    figures.adaptation = actuated->adaptation();
    figures.supply = supply_judge ? std::optional(supply_judge->figures()) : std::nullopt;
    note_supply(*actuated, static_cast<double>(body.ticks) * robot.period_s, figures);
  }
  return std::optional(figures);
}

std::vector<TrotJob> jobs_of(const robot::Robot& robot, std::span<const TrotCase> cases) {
  std::vector<TrotJob> jobs;
  for (const TrotCase& one : cases) {
    jobs.push_back({&robot, one});
  }
  return jobs;
}

void run_trot_jobs(std::span<const TrotJob> jobs, Joints joints, int threads,
                   const std::function<void(const TrotRow&)>& done, const std::function<bool()>& keep_on) {
  std::atomic<std::size_t> next{0};
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      const TrotCase& one = jobs[i].one;
      TrotRow row{.trial = one.trial, .name = one.name, .figures = {}, .failure = {}};
      const auto ran = run_trot_case(*jobs[i].robot, one, joints, keep_on);
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
