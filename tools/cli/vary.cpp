#include "tools/cli/vary.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lab/inproc_run.hpp"
#include "lab/vary.hpp"
#include "participant/loop.hpp"
#include "tools/cli/command.hpp"
#include "tools/cli/progress.hpp"
#include "tools/report/console.hpp"
#include "tools/report/outcome.hpp"
#include "tools/report/tracking.hpp"
#include "tools/report/vary_result.hpp"

namespace farrier::cli {
namespace {

using report::Contender;

constexpr std::size_t kLongestTable = 40;

/// The robot as the nodes of this contender know it: nominal, with the contender's kind of controller. Only adaptation
/// needs the dither, so only adaptation pays for it; who is told of actual touchdowns need not be early for them.
robot::Robot believed_by(Contender contender, const robot::Robot& nominal) {
  robot::Robot robot = nominal;
  for (robot::Joint& joint : robot.joints) {
    joint.kind = contender == Contender::kFeedbackLinearisation ? control::Kind::kFeedbackLinearisation
                                                                : control::Kind::kLqr;
    joint.dither_percent = contender == Contender::kAdaptive ? joint.dither_percent : 0.0;
  }
  if (contender == Contender::kPerfect) {
    robot.safety.stance_lead_s = 0.0;
  }
  return robot;
}

lab::InprocRun run_of(Contender contender, const robot::Robot& world) {
  lab::InprocRun run;
  run.grouping = lab::Grouping::kOne;
  run.world = &world;
  switch (contender) {
    case Contender::kAdaptive: run.design = supervisor::Design::kAdaptive; break;
    case Contender::kPerfect:
      run.design = supervisor::Design::kPhases;
      run.designer = &world;
      run.announce = lab::Announce::kActual;
      break;
    case Contender::kStance: run.design = supervisor::Design::kStance; break;
    case Contender::kSwing: run.design = supervisor::Design::kSwing; break;
    case Contender::kFeedbackLinearisation: break;  // takes no gains
  }
  return run;
}

class Study {
 public:
  Study(const robot::Robot& nominal, const TrotOptions& o)
      : nominal_(nominal),
        seeds_(static_cast<std::uint64_t>(o.seeds)),
        first_seed_(o.seed),
        ticks_(lab::ticks_of(o.duration_s, nominal)),
        progress_("trot --vary", ticks_ * static_cast<Tick>(seeds_ * report::kContenders.size())) {
    for (const Contender contender : report::kContenders) {
      believed_.push_back(believed_by(contender, nominal));
    }
    trace_.reserve(static_cast<std::size_t>(ticks_) * nominal.joints.size());
  }

  Result<Done> run() {
    for (std::uint64_t i = 0; i < seeds_; ++i) {
      const lab::Draw draw = lab::draw_variation(nominal_, first_seed_ + i);
      const robot::Robot world = lab::varied(nominal_, draw);
      for (const Contender contender : report::kContenders) {
        if (auto ran = run(contender, first_seed_ + i, draw, world); !ran) {
          return Error{std::string(to_string(contender)) + ", seed " + std::to_string(first_seed_ + i) + ": " +
                       ran.error().message};
        }
      }
    }
    return Done{};
  }

  const std::vector<report::VaryRow>& rows() const noexcept { return rows_; }
  bool long_enough() const noexcept { return long_enough_; }

 private:
  Result<Done> run(Contender contender, std::uint64_t seed, const lab::Draw& draw, const robot::Robot& world) {
    const gait::Schedule schedule(nominal_.plan, seed);
    lab::InprocRun run = run_of(contender, world);
    run.ticks = ticks_;
    run.seed = seed;
    trace_.clear();
    run.sink = [&](const record::TraceRow& row) { trace_.push_back(row); };
    run.progress = [&](Tick tick) {
      progress_.update(ticks_done_ + tick);
      return !participant::stop_requested();
    };
    const robot::Robot& believed = believed_[static_cast<std::size_t>(contender)];
    if (auto ran = lab::run_inproc(believed, run); !ran) {
      return ran.error();
    }
    ticks_done_ += ticks_;
    progress_.update(ticks_done_);
    judge(contender, seed, draw, world, schedule);
    return Done{};
  }

  void judge(Contender contender, std::uint64_t seed, const lab::Draw& draw, const robot::Robot& world,
             const gait::Schedule& schedule) {
    const report::Tracking tracking = report::track(nominal_, schedule, trace_, nominal_.loop_delay_lockstep);
    long_enough_ = long_enough_ && report::long_enough(nominal_, tracking);
    const std::vector<double> demands = peak_demands(world, schedule);
    for (const robot::Joint& joint : nominal_.joints) {
      const lab::JointDraw& drawn = draw.joints[joint.number];
      const report::JointTracking& of_joint = tracking.joints[joint.number];
      rows_.push_back({.seed = seed,
                       .contender = contender,
                       .joint = joint.name,
                       .supply_factor = draw.supply_factor,
                       .friction_factor = drawn.friction_factor,
                       .valve_factor = drawn.valve_factor,
                       .stance_mass_kg_or_kgm2 = drawn.stance_mass,
                       .peak_demand = demands[joint.number],
                       .stance_nrmse = of_joint.stance.nrmse,
                       .swing_nrmse = of_joint.swing.nrmse,
                       .left_tracking = of_joint.tripped || of_joint.not_tracking_ticks > 0});
    }
  }

  /// Largest judged reference of each joint in stance over p_s A_a - p_t A_b where it pushes, p_s A_b - p_t A_a where it pulls.
  std::vector<double> peak_demands(const robot::Robot& world, const gait::Schedule& schedule) const {
    std::vector<Tick> first;
    for (const robot::Joint& joint : nominal_.joints) {
      first.push_back(report::first_judged_tick(nominal_, schedule, joint.leg));
    }
    std::vector<double> demands(nominal_.joints.size(), 0.0);
    for (const record::TraceRow& row : trace_) {
      const bool stance = schedule.phase(nominal_.joints[row.joint].leg, row.tick) == gait::Phase::kStance;
      if (stance && row.tick >= first[row.joint]) {
        const plant::ActuatorParams& a = world.joints[row.joint].actuator;
        const double force = row.force_reference_N_or_Nm;
        const double available = force > 0.0 ? a.supply_pressure_Pa * a.area_a - a.return_pressure_Pa * a.area_b
                                             : a.supply_pressure_Pa * a.area_b - a.return_pressure_Pa * a.area_a;
        demands[row.joint] = std::max(demands[row.joint], std::abs(force) / available);
      }
    }
    return demands;
  }

  const robot::Robot& nominal_;
  std::uint64_t seeds_;
  std::uint64_t first_seed_;
  Tick ticks_;
  Progress progress_;
  std::vector<robot::Robot> believed_;  ///< by contender
  std::vector<record::TraceRow> trace_;
  std::vector<report::VaryRow> rows_;
  Tick ticks_done_ = 0;
  bool long_enough_ = true;
};

int fail(const Error& error) {
  std::fprintf(stderr, "farrier trot --vary: %s\n", error.message.c_str());
  return participant::stop_requested() ? participant::stop_status() : kFailed;
}

/// Runs the study with its progress bar, which is gone when this returns.
Result<std::vector<report::VaryRow>> rows_of_study(const robot::Robot& robot, const TrotOptions& o,
                                                   bool& long_enough) {
  const robot::Robot nominal = lab::with_varied_body(robot);
  Study study(nominal, o);
  if (auto ran = study.run(); !ran) {
    return ran.error();
  }
  long_enough = study.long_enough();
  return study.rows();
}

}  // namespace

int vary(const robot::Robot& robot, const TrotOptions& o, const std::string& rows_path) {
  participant::install_signal_handlers();
  bool long_enough = false;
  const auto rows = rows_of_study(robot, o, long_enough);
  if (!rows) {
    return fail(rows.error());
  }
  report::Outcome outcome;
  outcome.command = "trot";
  outcome.run = report::run_info(robot, o.seed);
  report::add_vary(outcome.figures, rows.value());
  if (!long_enough) {
    outcome.failures.emplace_back(kTooShort);
  }
  if (auto written = report::write_vary_csv(rows_path, rows.value()); !written) {
    return fail(written.error());
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail(written.error());
  }
  std::printf("%s\n%s", report::vary_text(rows.value(), kLongestTable).c_str(),
              report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\nevery joint and seed: %s\n", o.json_path.c_str(), rows_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
