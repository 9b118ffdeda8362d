#include "cli/trot/body_run.hpp"

#include <unistd.h>

#include <cstdio>
#include <optional>

#include "body/scene/scene.hpp"
#include "cli/base/command.hpp"
#include "cli/trot/run_events.hpp"
#include "cli/trot/trot_run.hpp"
#include "locomotion/motion_script.hpp"
#include "report/figures/console.hpp"
#include "report/trot/adaptation.hpp"
#include "report/walk/walk_run.hpp"
#include "robot/keys.hpp"
#include "trace/body_trace.hpp"
#include "trace/supply_trace.hpp"
#include "trace/trace.hpp"
#include "world/scene_file.hpp"

namespace farrier::cli {
namespace {

Result<report::WalkPlan> plan_of(const robot::Robot& robot, const TrotOptions& o) {
  report::WalkPlan plan{.period_s = robot.period_s,
                        .forward_m_s = o.velocity[0],
                        .left_m_s = o.velocity[1],
                        .yaw_rate_rad_s = o.velocity[2],
                        .height_m = robot.locomotion->reference.default_height_m,
                        .walk_s = locomotion::kWalk_s,
                        .normal = Eigen::Vector3d::UnitZ(),
                        .plain = o.scene_path.empty()};
  if (!o.scene_path.empty()) {
    const auto scene = world::load_scene(o.scene_path);
    if (!scene) {
      return Error{config::to_string(scene.error())};
    }
    plan.normal = scene.value().ground * Eigen::Vector3d::UnitZ();
  }
  return plan;
}

/// The samples of the shared supply; none without a pump and with ideal joints.
Result<std::vector<trace::SupplyRow>> supply_rows(const robot::Robot& robot, const TrotOptions& o) {
  if (!participant::tells_supply(o.world, robot.supply.has_value())) {
    return std::vector<trace::SupplyRow>{};
  }
  return trace::read_supply_trace(trace::supply_trace_path(o.trace_path));
}

}  // namespace

std::string cannot_adapt_on_ground(const robot::Robot& robot) {
  for (const robot::Joint& joint : robot.joints) {
    if (!control::takes_physics(joint.kind)) {
      const bool linear = joint.kind == control::Kind::kLqr;
      return std::string("--design adaptive is not for the controller ") +
             name_of(robot::kControllerKinds, joint.kind) + " of joint " + joint.name +
             " on a ground: " + (linear ? "its estimates are not valid there" : "its gains do not adapt") +
             "; leave it out, or add --world bench, or --controller feedback_linearisation";
    }
    if (joint.estimator.regresses()) {
      return std::string("--design adaptive is not for the estimator ") +
             name_of(estimation::kEstimationMethods, joint.estimator.method) + " of joint " + joint.name +
             " on a ground: it finds no valve; add --estimator with a section of method valve_flow or greybox";
    }
  }
  return "";
}

std::string refused_on_ground(const robot::Robot& robot, const TrotOptions& o) {
  if (robot.plan.gait.pattern == gait::Pattern::kStand) {
    return "the gait 'stand' is for the bench, a robot on a ground needs steps: add --world bench, or give another "
           "--gait";
  }
  if (o.design == robot::Design::kAdaptive) {
    if (std::string why = cannot_adapt_on_ground(robot); !why.empty()) {
      return why;
    }
  }
  if (o.dither_cost || o.security_cost) {
    return "--dither-cost and --security-cost compare runs on the bench: add --world bench";
  }
  return "";
}

int run_on_ground(const robot::Robot& robot, const TrotOptions& o) {
  const auto plan = plan_of(robot, o);
  if (!plan) {
    std::fprintf(stderr, "%s", plan.error().message.c_str());
    return kBadInput;
  }
  auto ran = run_once(robot, o, "trot");
  if (!ran) {
    return fail("trot", ran.error().message);
  }
  const auto truth =
      trace::read_body_trace(trace::body_trace_path(o.trace_path), static_cast<int>(robot.plan.legs.size()));
  if (!truth) {
    return fail("trot", truth.error().message);
  }
  const bool lockstep = o.clock == bus::ClockKind::kLockstep;
  report::Outcome outcome;
  outcome.command = "trot";
  outcome.run = report::run_info(robot, o.seed);
  outcome.run.processes = report::process_infos(ran.value().hellos, ran.value().healths);
  outcome.run.decisions = report::decision_infos(robot, ran.value().decisions);
  outcome.warnings = ran.value().warnings;
  const report::WalkFigures walk = report::judge_walk(plan.value(), truth.value());
  report::add_walk(outcome.figures, plan.value(), walk);
  if (ran.value().rows.empty()) {
    auto read = trace::read_trace(o.trace_path, robot::joint_names(robot));
    if (!read) {
      return fail("trot", read.error().message);
    }
    ran.value().rows = std::move(read).value();
  }
  const report::GaitChanges changes{.phases = ran.value().phases, .rows = ran.value().rows};
  report::add_gait_changes(outcome.figures, robot, changes);
  if (o.design == robot::Design::kAdaptive) {
    report::add_updates(outcome.figures, robot, outcome.run.decisions, static_cast<Tick>(truth.value().size()), false);
  }
  outcome.figures.add("trot.ticks", static_cast<double>(truth.value().size()));
  outcome.figures.add("trot.ticks_per_s", static_cast<double>(truth.value().size()) / ran.value().wall_s);
  report::add_transport(outcome.figures, outcome.run, lockstep);
  if (walk.fell_s) {
    outcome.failures.push_back("the robot " + report::walk_text(walk));
  } else if (walk.seconds <= 0.0) {
    outcome.failures.emplace_back(
        "too short to be judged, which begins four seconds after the first step: give a longer "
        "--duration");
  }
  write_events(o.out + "/events.txt", robot, ran.value(), outcome.run.decisions);
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("trot", written.error().message);
  }
  const auto supply = supply_rows(robot, o);
  if (!supply) {
    return fail("trot", supply.error().message);
  }
  const auto page =
      report::write_walk_report(o.out, outcome, {robot, plan.value(), walk, truth.value(), supply.value(), changes});
  if (!page) {
    return fail("trot", page.error().message);
  }
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  if (!walk.fell_s) {
    std::printf("%s %s\n", robot.name.c_str(), report::walk_text(walk).c_str());
  }
  std::printf("report: %s\nfigures: %s\ntrace: %s\n", page.value().c_str(), o.json_path.c_str(), o.trace_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
