#include "cli/compare/varied_study.hpp"

#include <algorithm>
#include <cmath>

#include "participant/loop.hpp"
#include "cli/compare/contenders.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::cli {

VariedStudy::VariedStudy(const robot::Robot& nominal, std::span<const report::Contender> contenders,
                         const CompareOptions& o, const std::string& title)
    : nominal_(nominal),
      seeds_(static_cast<std::uint64_t>(o.seeds)),
      first_seed_(o.seed),
      ticks_(run::ticks_of(o.duration_s, nominal)),
      progress_(title, ticks_ * static_cast<Tick>(seeds_ * contenders.size())) {
  for (const report::Contender contender : contenders) {
    entrants_.push_back({contender, believed_by(contender, nominal)});
  }
  trace_.reserve(static_cast<std::size_t>(ticks_) * nominal.joints.size());
}

Result<Done> VariedStudy::run() {
  for (std::uint64_t i = 0; i < seeds_; ++i) {
    const trials::Draw draw = trials::draw_variation(nominal_, first_seed_ + i);
    const robot::Robot world = trials::varied(nominal_, draw);
    for (const Entrant& entrant : entrants_) {
      if (auto ran = run(entrant, first_seed_ + i, draw, world); !ran) {
        return Error{std::string(to_string(entrant.contender)) + ", seed " + std::to_string(first_seed_ + i) + ": " +
                     ran.error().message};
      }
    }
  }
  return Done{};
}

Result<Done> VariedStudy::run(const Entrant& entrant, std::uint64_t seed, const trials::Draw& draw,
                              const robot::Robot& world) {
  const gait::Schedule schedule(nominal_.plan, seed);
  run::InprocRun run = run_of(entrant.contender, world);
  run.ticks = ticks_;
  run.seed = seed;
  trace_.clear();
  run.sink = [&](const trace::TraceRow& row) { trace_.push_back(row); };
  run.progress = [&](Tick tick) {
    progress_.update(ticks_done_ + tick);
    return !participant::stop_requested();
  };
  FARRIER_TRY(run::run_inproc(entrant.believed, run));
  ticks_done_ += ticks_;
  progress_.update(ticks_done_);
  judge(entrant.contender, seed, draw, world, schedule);
  return Done{};
}

void VariedStudy::judge(report::Contender contender, std::uint64_t seed, const trials::Draw& draw,
                        const robot::Robot& world, const gait::Schedule& schedule) {
  const report::Tracking tracking = report::track(nominal_, schedule, trace_, nominal_.loop_delay_lockstep);
  long_enough_ = long_enough_ && report::long_enough(nominal_, tracking);
  const std::vector<double> demands = peak_demands(world, schedule);
  for (const robot::Joint& joint : nominal_.joints) {
    const trials::JointDraw& drawn = draw.joints[joint.number];
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

/// Largest judged reference of each joint in stance over p_s A_a - p_t A_b where it pushes, p_s A_b - p_t A_a where
/// it pulls.
std::vector<double> VariedStudy::peak_demands(const robot::Robot& world, const gait::Schedule& schedule) const {
  std::vector<Tick> first;
  for (const robot::Joint& joint : nominal_.joints) {
    first.push_back(report::first_judged_tick(nominal_, schedule, joint.leg));
  }
  std::vector<double> demands(nominal_.joints.size(), 0.0);
  for (const trace::TraceRow& row : trace_) {
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

}  // namespace farrier::cli
