// farrier compare friction: every kind of controller on joints whose contacts stick and whose sensors filter.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "cli/base/command.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/progress.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/compare/contenders.hpp"
#include "participant/loop.hpp"
#include "plant/effects/effects.hpp"
#include "report/compare/controllers.hpp"
#include "report/compare/friction.hpp"
#include "report/figures/console.hpp"
#include "report/trot/tracking.hpp"
#include "robot/joint_effects.hpp"
#include "trials/load_cycle.hpp"

namespace farrier::cli {
namespace {

using report::FrictionRun;

/// A contact of a cylinder; of a motor by the lever. Breakaway ratio 1 is Coulomb's model, above it Stribeck's.
struct Friction {
  const char* name;
  const char* effect;  ///< nullptr: viscous friction alone
  double coulomb_N;
  double breakaway_ratio;
  double presliding_m;  ///< 0: the effect's own
  double bristle_damping_Ns_m;
};
constexpr double kLever_m = 0.045;  // of HyQ's flexion joints
constexpr std::array kFrictions{Friction{"viscous", nullptr, 0, 1, 0, 0},
                                Friction{"piston Coulomb", "piston_friction", 10, 1, 0, 0},
                                Friction{"piston Stribeck", "piston_friction", 10, 1.5, 0, 0},
                                Friction{"piston LuGre", "piston_friction", 10, 1.5, 5e-5, 10},
                                Friction{"load Coulomb", "load_friction", 40, 1, 0, 0},
                                Friction{"load Stribeck", "load_friction", 40, 1.5, 0, 0},
                                Friction{"load LuGre", "load_friction", 40, 1.5, 5e-5, 40}};

/// Filters of second order, Hz; 0: none.
struct Filters {
  const char* name;
  double position_Hz, velocity_Hz, force_Hz;
  bool equalised;
};
constexpr std::array kFilters{Filters{"none", 0, 0, 0, false}, Filters{"all 250 Hz", 250, 250, 250, false},
                              Filters{"force 250 Hz", 0, 0, 250, false},
                              Filters{"force 250 Hz, equalised", 0, 0, 250, true},
                              Filters{"force 100 Hz", 0, 0, 100, false}};

plant::ActiveEffect effect_of(const Friction& friction, const robot::Joint& joint) {
  plant::ActiveEffect effect{plant::find_effect(friction.effect), {}};
  const plant::Scales scales(joint.actuator, joint.swing_load);
  const auto& parameters = effect.info().parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    effect.values[i] = plant::default_value(parameters[i], scales, joint.actuator, joint.swing_load);
  }
  const auto set = [&](const char* name, double value) {
    effect.values[plant::find_parameter(effect.info(), name)] = value;
  };
  const double lever = joint.rotary ? kLever_m : 1.0;
  set("coulomb_N", friction.coulomb_N * lever);
  set("breakaway_ratio", friction.breakaway_ratio);
  if (friction.presliding_m > 0.0) {
    set("presliding_m", friction.presliding_m / lever);
    set("bristle_damping_Ns_m", friction.bristle_damping_Ns_m * lever * lever);
  }
  return effect;
}

/// The robot with this friction in place of its own, behind these filters. Everybody knows both.
Result<robot::Robot> robot_with(robot::Robot robot, const Friction& friction, const Filters& filters) {
  for (robot::Joint& joint : robot.joints) {
    std::erase_if(joint.effects, [](const plant::ActiveEffect& effect) {
      return effect.id == plant::find_effect("piston_friction") || effect.id == plant::find_effect("load_friction");
    });
    if (friction.effect != nullptr) {
      const plant::ActiveEffect effect = effect_of(friction, joint);
      joint = FARRIER_TRY(robot::with_effects(joint, std::span(&effect, 1)));
    }
    joint.sensors.position.cut_off_Hz = filters.position_Hz;
    joint.sensors.velocity.cut_off_Hz = filters.velocity_Hz;
    joint.sensors.force.cut_off_Hz = filters.force_Hz;
    joint.equalises_filters = filters.equalised;
  }
  return robot;
}

bool is_announced(const run::InprocResult& result) {
  return std::ranges::any_of(
      result.events, [](const signals::SystemEvent& event) { return event.severity != signals::Severity::kInfo; });
}

/// Runs `believed`, which is also the world, and takes its rows. An Error is a refusal at design time.
class Study {
 public:
  explicit Study(const CompareOptions& o) : options_(o) {}

  /// One run for each of the controllers, models of friction and filters.
  template <class RunOne>
  Result<Done> add(const robot::Robot& nominal, const std::string& title, RunOne run_one) {
    Progress progress(title, static_cast<Tick>(kFilters.size() * report::kControllers.size() * kFrictions.size()));
    Tick done = 0;
    for (const Filters& filters : kFilters) {
      for (const report::Contender contender : report::kControllers) {
        for (const Friction& friction : kFrictions) {
          const robot::Robot robot = FARRIER_TRY(robot_with(nominal, friction, filters));
          FrictionRun row{.robot = nominal.name,
                          .contender = contender,
                          .friction = friction.name,
                          .filters = filters.name,
                          .refusal = {}};
          run_one(robot, row);
          if (participant::stop_requested()) {
            return Error{row.refusal};
          }
          runs_.push_back(std::move(row));
          progress.update(++done);
        }
      }
    }
    return Done{};
  }

  Result<Done> add_rig();
  Result<Done> add_trot(const robot::Robot& robot);
  const std::vector<FrictionRun>& runs() const noexcept { return runs_; }

 private:
  /// Runs; empty where it was refused, with the reason in `row`.
  std::optional<std::vector<trace::TraceRow>> run(const robot::Robot& believed, run::InprocRun run, FrictionRun& row) {
    std::vector<trace::TraceRow> rows;
    run.seed = options_.seed;
    run.sink = [&](const trace::TraceRow& each) { rows.push_back(each); };
    run.progress = [](Tick) { return !participant::stop_requested(); };
    const auto result = run::run_inproc(believed, run);
    if (!result) {
      row.refusal = result.error().message;
      return std::nullopt;
    }
    row.announced = is_announced(result.value());
    return rows;
  }

  const CompareOptions& options_;
  std::vector<FrictionRun> runs_;
};

/// The load cycle of Fig. 7.8 on the shipped rig.
Result<Done> Study::add_rig() {
  const auto rig = robot::load_robot(shipped_robot("fc1d.yaml"));
  if (!rig) {
    return Error{config::to_string(rig.error())};
  }
  auto cycle = FARRIER_TRY(trials::make_load_cycle(rig.value()));
  return add(cycle.robot, "compare friction, load cycle", [&](const robot::Robot& robot, FrictionRun& row) {
    const robot::Robot believed = believed_by(row.contender, robot);
    run::InprocRun one = run_of(row.contender, robot);
    one.ticks = cycle.begin.back();
    one.load_changes = cycle.changes;
    if (const auto rows = run(believed, one, row)) {
      const auto error = [&](std::size_t quarter) { return trials::quarter_error(cycle, *rows, quarter); };
      row.swing_nrmse = std::max(error(0), error(2));
      row.stance_nrmse = std::max(error(1), error(3));
      row.left_tracking = std::ranges::any_of(*rows, [&](const trace::TraceRow& each) {
        return each.tick >= cycle.begin[0] && each.state != signals::JointState::kTracking;
      });
    }
  });
}

/// The gait of the robot.
Result<Done> Study::add_trot(const robot::Robot& nominal) {
  const gait::Schedule schedule(nominal.plan, options_.seed);
  return add(nominal, "compare friction, trots", [&](const robot::Robot& robot, FrictionRun& row) {
    const robot::Robot believed = believed_by(row.contender, robot);
    run::InprocRun one = run_of(row.contender, robot);
    one.ticks = run::ticks_of(options_.duration_s, nominal);
    const auto rows = run(believed, one, row);
    if (!rows) {
      return;
    }
    const report::Tracking tracking = report::track(nominal, schedule, *rows, nominal.loop_delay_lockstep);
    for (const report::JointTracking& joint : tracking.joints) {
      row.swing_nrmse = std::max(row.swing_nrmse, report::infinite_if_lost(joint.swing.nrmse));
      row.stance_nrmse = std::max(row.stance_nrmse, report::infinite_if_lost(joint.stance.nrmse));
      row.left_tracking |= joint.tripped || joint.not_tracking_ticks > 0;
    }
  });
}

}  // namespace

int run_friction(const robot::Robot& robot, const CompareOptions& options) {
  participant::install_signal_handlers();
  Study study(options);
  if (const auto added = study.add_rig(); !added) {
    return fail("compare", added.error().message);
  }
  if (const auto added = study.add_trot(robot); !added) {
    return fail("compare", added.error().message);
  }
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(robot, options.seed);
  report::add_friction(outcome.figures, study.runs());
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s\n%s", report::friction_text(study.runs()).c_str(),
              report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\n", options.json_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
