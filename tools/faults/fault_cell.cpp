#include "tools/faults/fault_cell.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "body/model/posture.hpp"
#include "core/ensure.hpp"
#include "core/fault.hpp"
#include "participant/event_registry.hpp"

namespace farrier::faults {
namespace {

using signals::JointState;

/// A process reports the faults injected into it once per period of its health, 0.1 s. The event's way to the operator
/// follows.
constexpr double kTold_s = 0.12;

/// Share of a run that pauses of the computer may hide. The rest shows how a fault affects joints that it does not hit.
constexpr double kMayBeExcused = 0.5;

/// At the end of a run in which the processes may already be ending.
constexpr Tick kAfter = 20;

/// State of every joint, by joint and tick.
class Course {
 public:
  Course(const robot::Robot& robot, const std::vector<trace::TraceRow>& trace, const std::vector<TickSpan>& pauses)
      : ticks_(trace.empty() ? 0 : trace.back().tick + 1),
        period_s_(robot.period_s),
        excused_(static_cast<std::size_t>(ticks_)),
        rows_(robot.joints.size()) {
    for (const TickSpan& pause : pauses) {
      const Tick over = pause.end < ticks_ - kAfterPause ? pause.end + kAfterPause : ticks_;
      for (Tick tick = pause.begin; tick < over; ++tick) {
        excused_[static_cast<std::size_t>(tick)] = true;
      }
    }
    for (auto& joint : rows_) {
      joint.resize(static_cast<std::size_t>(ticks_));
    }
    for (const trace::TraceRow& row : trace) {
      rows_[row.joint][static_cast<std::size_t>(row.tick)] = {row.state, FaultSet(row.faults)};
    }
  }

  Tick end() const noexcept { return std::max<Tick>(0, ticks_ - kAfter); }
  JointState state(std::size_t joint, Tick tick) const { return rows_[joint][static_cast<std::size_t>(tick)].state; }
  bool tripped(std::size_t joint, Tick tick) const {
    return rows_[joint][static_cast<std::size_t>(tick)].faults.has(Fault::kTripped);
  }
  double seconds(Tick ticks) const noexcept { return static_cast<double>(ticks) * period_s_; }

  /// From `begin` on until all of `joints` are in `state`; infinite: never.
  double until(const std::vector<std::size_t>& joints, JointState wanted, Tick begin) const {
    for (Tick tick = begin; tick < end(); ++tick) {
      if (all_in(joints, wanted, tick)) {
        return seconds(tick - begin);
      }
    }
    return std::numeric_limits<double>::infinity();
  }

  /// Returns how long some of `joints` were in another state within a span.
  double elsewhere(const std::vector<std::size_t>& joints, JointState wanted, TickSpan span) const {
    Tick ticks = 0;
    for (Tick tick = span.begin; tick < std::min(span.end, end()); ++tick) {
      ticks += all_in(joints, wanted, tick) ? 0 : 1;
    }
    return seconds(ticks);
  }

  /// Times within a span: how long the computer is to blame for the state of joints, and how long some of `joints` did
  /// not track otherwise.
  struct Untracked {
    double excused_s, elsewhere_s;
  };
  Untracked untracked(const std::vector<std::size_t>& joints, TickSpan span) const {
    Tick excused = 0, elsewhere = 0;
    for (Tick tick = span.begin; tick < std::min(span.end, end()); ++tick) {
      if (excused_[static_cast<std::size_t>(tick)]) {
        ++excused;
      } else if (!all_in(joints, JointState::kTracking, tick)) {
        ++elsewhere;
      }
    }
    return {seconds(excused), seconds(elsewhere)};
  }

  /// From `begin` on until all of `joints` track and go on tracking; infinite: not at the end.
  double until_for_good(const std::vector<std::size_t>& joints, Tick begin) const {
    Tick last = begin - 1;
    for (Tick tick = begin; tick < end(); ++tick) {
      for (const std::size_t joint : joints) {
        last = state(joint, tick) == JointState::kTracking ? last : tick;
      }
    }
    return last + 1 >= end() ? std::numeric_limits<double>::infinity() : seconds(last + 1 - begin);
  }

  double tripped_time(Tick begin) const {
    Tick ticks = 0;
    for (std::size_t joint = 0; joint < rows_.size(); ++joint) {
      for (Tick tick = begin; tick < end(); ++tick) {
        ticks += tripped(joint, tick) ? 1 : 0;
      }
    }
    return seconds(ticks);
  }

 private:
  struct Row {
    JointState state = JointState::kNull;
    FaultSet faults;
  };

  bool all_in(const std::vector<std::size_t>& joints, JointState wanted, Tick tick) const {
    return std::ranges::all_of(joints, [&](std::size_t joint) { return state(joint, tick) == wanted; });
  }

  Tick ticks_;
  double period_s_;
  std::vector<bool> excused_;  // by tick
  std::vector<std::vector<Row>> rows_;
};

bool is_hit(const robot::Robot& robot, const Row& row, const robot::Joint& joint) {
  const robot::Joint& hit = hit_joint(robot);
  return row.hit == Hit::kAll || (row.hit == Hit::kLeg && joint.leg == hit.leg) || joint.number == hit.number;
}

}  // namespace

const robot::Joint& hit_joint(const robot::Robot& robot) {
  const auto last = std::ranges::find_if(robot.joints.rbegin(), robot.joints.rend(),
                                         [](const robot::Joint& joint) { return joint.leg == 0; });
  FARRIER_ENSURE(last != robot.joints.rend(), "a robot has a first leg with joints");
  return *last;
}

TickSpan place_of(const robot::Robot& robot, const gait::Schedule& schedule, const Row& row, gait::Phase phase,
                  Tick earliest) {
  constexpr Tick kShortlyAfter = 20;
  const int leg = hit_joint(robot).leg;
  Tick begin = std::max(schedule.lead_in_ticks(), earliest);
  while (schedule.phase(leg, begin) == phase) {
    ++begin;
  }
  while (schedule.phase(leg, begin) != phase) {
    ++begin;
  }
  const Tick length =
      phase == gait::Phase::kStance ? schedule.stance_ticks() : schedule.stride_ticks() - schedule.stance_ticks();
  const Tick lasts = std::llround(row.lasts_s / robot.period_s);
  begin += std::max(kShortlyAfter, (length - lasts) / 2);
  return {begin, begin + lasts};
}

BodyAfterFault body_after_fault(const std::vector<signals::BodyTruth>& truth, Tick begin, const Walk& walk) {
  constexpr double kShare = 0.5;
  const double least_m = kShare * walk.speed_m_s * static_cast<double>(walk.stride_ticks) * walk.period_s;
  BodyAfterFault body;
  double start_height_m = 0.0;
  Tick judged = begin - 1;
  auto stride_ago = truth.begin();
  for (const signals::BodyTruth& row : truth) {
    const Eigen::Quaterniond attitude(row.attitude[0], row.attitude[1], row.attitude[2], row.attitude[3]);
    const body::Posture posture =
        body::posture_of(Eigen::Vector3d(row.position_m.data()), attitude, Eigen::Vector3d::UnitZ());
    start_height_m = row.tick == 0 ? posture.height_m : start_height_m;
    if (row.tick < begin) {
      continue;
    }
    while (stride_ago->tick < row.tick - walk.stride_ticks) {
      ++stride_ago;
    }
    const double moved_m =
        std::hypot(row.position_m[0] - stride_ago->position_m[0], row.position_m[1] - stride_ago->position_m[1]);
    const bool lies = body::fall_of(posture, start_height_m).has_value();
    body.fell = body.fell || lies;
    body.not_walking_s += !lies && moved_m >= least_m ? 0.0 : static_cast<double>(row.tick - judged) * walk.period_s;
    judged = row.tick;
    body.trunk_speed_m_s = std::max(body.trunk_speed_m_s, -row.velocity_m_s[2]);
    for (std::size_t i = 0; i < row.foot_force_N.size(); i += 3) {
      body.ground_force_N = std::max(body.ground_force_N, Eigen::Vector3d(row.foot_force_N.data() + i).norm());
    }
  }
  return body;
}

Check walks_on_check(const BodyAfterFault& body) { return {"not_walking", "not walking", 0.0, body.not_walking_s}; }

std::vector<bus_faults::ArrowFault> arrow_faults(const robot::Robot& robot, const Row& row, const TickSpan& span) {
  std::vector<bus_faults::ArrowFault> faults;
  for (const char* arrow : row.arrows) {
    bus_faults::ArrowFault fault = bus_faults::parse_arrow_fault(arrow).value();
    fault.from = span.begin;
    fault.until = span.end;
    if (row.hit == Hit::kJoint) {
      fault.key = hit_joint(robot).number;
    }
    faults.push_back(std::move(fault));
  }
  return faults;
}

bool Cell::holds() const noexcept { return error.empty() && std::ranges::all_of(checks, &Check::holds); }

std::vector<Check> judge(const robot::Robot& robot, const Row& row, const Moments& moments,
                         const std::vector<trace::TraceRow>& trace, const std::vector<Heard>& events) {
  const Course course(robot, trace, moments.pauses);
  const Expectation& expected = row.expected;
  std::vector<std::size_t> hit, others;
  for (const robot::Joint& joint : robot.joints) {
    const bool spared =
        !is_hit(robot, row, joint) || (expected.reaction == JointState::kTracking && !expected.may_stutter);
    (spared ? others : hit).push_back(joint.number);
  }
  std::vector<Check> checks;
  const TickSpan& fault = moments.fault;
  if (expected.reaction != JointState::kTracking) {
    const double reached = course.until(hit, expected.reaction, fault.begin);
    checks.push_back(
        {"reaction", std::string(signals::to_string(expected.reaction)) + " after", expected.within_s, reached});
    if (std::isfinite(reached)) {
      const Tick then = fault.begin + std::llround(reached / robot.period_s);
      const Tick until = expected.latches ? moments.armed : fault.end;
      checks.push_back({"left", std::string("not ") + signals::to_string(expected.reaction) + " until its end", 0.0,
                        course.elsewhere(hit, expected.reaction, {then, until})});
    }
  }
  if (expected.recovers_s > 0.0) {
    const Tick end = expected.latches ? moments.armed : fault.end;
    checks.push_back({"recovery", "tracking again after", expected.recovers_s, course.until_for_good(hit, end)});
  }
  const bool has_trace = !trace.empty();
  if (!others.empty() && has_trace) {
    const TickSpan looked_at{fault.begin - kBefore, course.end()};
    const auto [excused_s, elsewhere_s] = course.untracked(others, looked_at);
    checks.push_back({"others", "others not tracking", 0.0, elsewhere_s});
    checks.push_back(
        {"excused", "others not judged", kMayBeExcused * course.seconds(looked_at.end - looked_at.begin), excused_s});
  }
  if (!expected.latches && has_trace) {
    checks.push_back({"tripped", "tripped", 0.0, course.tripped_time(fault.begin)});
  }
  const auto told_after = [&](const std::string& text) {
    const auto seen = std::ranges::find_if(events, [&](const Heard& event) {
      return event.tick >= fault.begin && event.text.find(text) != std::string::npos;
    });
    return seen == events.end() ? std::numeric_limits<double>::infinity() : course.seconds(seen->tick - fault.begin);
  };
  if (expected.event != nullptr) {
    checks.push_back({"event", std::string("event '") + expected.event + "' after", expected.event_within_s,
                      told_after(expected.event)});
  }
  if (!row.arrows.empty()) {
    double last = 0.0;
    for (const bus_faults::ArrowFault& arrow : arrow_faults(robot, row, fault)) {
      using participant::EventKind;
      last = std::max(last, told_after(participant::text_of(EventKind::kFaultOnPurpose, to_string(arrow))));
    }
    checks.push_back({"acts", "told that the fault acts after", row.lasts_s + kTold_s, last});
  }
  return checks;
}

}  // namespace farrier::faults
