// farrier compare bandwidth: force control of a held joint, by pose and amplitude, with a valve that differs from its file.

#include <algorithm>
#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/base/progress.hpp"
#include "cli/compare/comparison.hpp"
#include "participant/loop.hpp"
#include "report/compare/bandwidth.hpp"
#include "robot/wear.hpp"

namespace farrier::cli {
namespace {

using report::BandwidthRow;
using report::kBandwidthDesigns;

constexpr double kFromLimit = 0.1;  // of the way between a joint's limits
constexpr std::size_t kPoses = 3;
constexpr std::array kForceShares{0.02, 0.1, 0.4};
constexpr double kTypicalShare = 0.1;

std::array<double, kPoses> poses_of(const robot::Joint& joint) {
  const double margin_rad = kFromLimit * (joint.angle_max_rad - joint.angle_min_rad);
  return {joint.angle_min_rad + margin_rad, joint.home_angle_rad, joint.angle_max_rad - margin_rad};
}

Result<BandwidthRow> bandwidth_row(const robot::Robot& robot, const robot::Joint& joint, double angle_rad,
                                   double share) {
  const double amplitude = share * std::min(joint.push_limit, joint.pull_limit);
  BandwidthRow row{.joint = joint.name,
                   .angle_rad = angle_rad,
                   .amplitude_Nm = std::abs(joint.linkage.torque(angle_rad, amplitude)),
                   .typical = angle_rad == joint.home_angle_rad && share == kTypicalShare,
                   .spool_Hz = trials::spool_Hz(joint),
                   .full_flow_Hz = trials::full_flow_Hz(joint, angle_rad, amplitude),
                   .of = {}};
  for (std::size_t i = 0; i < row.of.size(); ++i) {
    robot::Wear wear = robot::no_wear(joint);
    wear.valve_gain = kBandwidthDesigns[i].valve_gain;
    const robot::Joint real = robot::worn(joint, wear);
    row.of[i] = FARRIER_TRY(trials::force_bandwidth({.real = real,
                                                     .designed = joint,
                                                     .known = kBandwidthDesigns[i].knows ? real : joint,
                                                     .angle_rad = angle_rad,
                                                     .period_s = robot.period_s,
                                                     .delay_ticks = robot.loop_delay_lockstep},
                                                    amplitude));
  }
  return row;
}

Result<std::vector<BandwidthRow>> bandwidth_rows(const robot::Robot& robot) {
  std::vector<BandwidthRow> rows;
  const auto in_a_leg = std::ranges::count(robot.joints, 0, &robot::Joint::leg);
  Progress progress("compare bandwidth", static_cast<Tick>(kPoses * kForceShares.size()) * in_a_leg, "row");
  for (const robot::Joint& joint : robot.joints) {
    if (joint.leg != 0) {
      continue;
    }
    for (const double angle_rad : poses_of(joint)) {
      for (const double share : kForceShares) {
        if (participant::stop_requested()) {
          return Error{"interrupted"};
        }
        rows.push_back(FARRIER_TRY(bandwidth_row(robot, joint, angle_rad, share)));
        progress.update(static_cast<Tick>(rows.size()));
      }
    }
  }
  return rows;
}

}  // namespace

int run_bandwidth(const robot::Robot& on_bench, const CompareOptions& options) {
  participant::install_signal_handlers();
  const auto robot = robot::load_robot(options.robot_path, {.on_ground = on_bench.can_walk()});
  if (!robot) {
    return fail("compare", config::to_string(robot.error()));
  }
  const auto rows = bandwidth_rows(robot.value());
  if (!rows) {
    return fail("compare", rows.error().message);
  }
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(robot.value(), options.seed);
  report::add_bandwidth(outcome.figures, rows.value());
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("-3 dB / -90 degrees (Hz) of a held joint's force, without sensor noise\n%s\nfigures: %s\n",
              report::bandwidth_text(rows.value()).c_str(), options.json_path.c_str());
  return kPassed;
}

}  // namespace farrier::cli
