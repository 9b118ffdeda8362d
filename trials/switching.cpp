#include "trials/switching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/law/force_controller.hpp"
#include "core/ensure.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::trials {
namespace {

using JointRows = std::vector<const trace::TraceRow*>;

constexpr auto kSwing = signals::Phase::kSwing;
constexpr auto kTracking = signals::JointState::kTracking;

std::vector<JointRows> by_joint(const robot::Robot& robot, std::span<const trace::TraceRow> rows) {
  std::vector<JointRows> sorted(robot.joints.size());
  for (const trace::TraceRow& row : rows) {
    FARRIER_ENSURE(row.joint < sorted.size(), "a trace row of a joint the robot does not have");
    sorted[row.joint].push_back(&row);
  }
  return sorted;
}

bool lands(const trace::TraceRow& before, const trace::TraceRow& now) {
  return before.actual_phase == kSwing && now.actual_phase != kSwing;
}

double window_error(const JointRows& rows, std::size_t begin, std::size_t length, double period_s) {
  double sum = 0.0;
  for (std::size_t i = begin; i < begin + length; ++i) {
    sum += std::abs(rows[i]->force_reference_N_or_Nm - rows[i]->force_N_or_Nm) * period_s;
  }
  return sum;
}

const signals::JointControllerGains* issued(std::span<const signals::JointControllerGains> gains,
                                            const trace::TraceRow& row) {
  const auto found = std::ranges::find_if(gains, [&](const signals::JointControllerGains& update) {
    return update.joint == row.joint && update.generation == row.generation;
  });
  return found == gains.end() ? nullptr : &*found;
}

double largest_bump(const robot::Joint& joint, const JointRows& rows,
                    std::span<const signals::JointControllerGains> gains) {
  const double home = joint.linkage.position(joint.home_angle_rad);
  control::ForceController controller;
  control::Measurement measured{};
  double reference = 0.0;
  double command_A = 0.0;
  std::uint32_t generation = 0;
  double largest_A = 0.0;
  for (const trace::TraceRow* row : rows) {
    if (row->state != kTracking) {
      controller.reset();
      generation = 0;
      continue;
    }
    if (row->generation != generation) {
      const signals::JointControllerGains* update = issued(gains, *row);
      if (update == nullptr) {
        return std::numeric_limits<double>::quiet_NaN();
      }
      controller.set_gains(wire_gains::unpack_gains(*update), measured, reference);
      if (generation != 0) {
        control::ForceController unmoved = controller;
        largest_A = std::max(largest_A, std::abs(unmoved.step(reference, measured).valve_current_A - command_A));
      }
      generation = row->generation;
    }
    measured = {row->position_m_or_rad - home, row->velocity_m_s_or_rad_s, row->force_N_or_Nm};
    reference = row->force_reference_N_or_Nm;
    command_A = controller.step(reference, measured).valve_current_A;
  }
  return largest_A / joint.actuator.valve_current_max_A;
}

}  // namespace

TouchdownErrors touchdown_errors(const robot::Robot& robot, std::span<const trace::TraceRow> rows, Tick from) {
  const auto sorted = by_joint(robot, rows);
  const auto window = static_cast<std::size_t>(std::llround(kTouchdownWindow_s / robot.period_s));
  TouchdownErrors errors{.integral_Ns = std::vector<double>(robot.joints.size(), 0.0),
                         .touchdowns = std::numeric_limits<int>::max()};
  for (const robot::Joint& joint : robot.joints) {
    if (joint.index_in_leg == 0) {
      continue;  // abducts, does not flex
    }
    const JointRows& of_joint = sorted[joint.number];
    int touchdowns = 0;
    for (std::size_t i = 1; i + window <= of_joint.size(); ++i) {
      if (of_joint[i]->tick >= from && lands(*of_joint[i - 1], *of_joint[i])) {
        errors.integral_Ns[joint.number] += window_error(of_joint, i, window, robot.period_s);
        ++touchdowns;
      }
    }
    errors.touchdowns = std::min(errors.touchdowns, touchdowns);
  }
  return errors;
}

std::vector<supervisor::SlotGains> last_gains(const robot::Robot& robot,
                                              std::span<const signals::JointControllerGains> gains) {
  std::vector<supervisor::SlotGains> last(robot.joints.size());
  std::vector<PerPhase<bool>> given(robot.joints.size());
  for (const signals::JointControllerGains& update : gains) {
    FARRIER_ENSURE(update.joint < last.size() && known(update.phase), "gains of a slot that is none");
    last[update.joint][update.phase] = wire_gains::unpack_gains(update);
    given[update.joint][update.phase] = true;
  }
  FARRIER_ENSURE(std::ranges::all_of(given, [](const auto& slots) { return slots[0] && slots[1]; }),
                 "a supervisor's first gains fill every slot");
  return last;
}

std::vector<supervisor::SlotGains> in_both_slots(std::vector<supervisor::SlotGains> gains, signals::Phase phase) {
  for (supervisor::SlotGains& slots : gains) {
    slots.fill(control::Gains(slots[phase]));
  }
  return gains;
}

double largest_bump(const robot::Robot& robot, std::span<const trace::TraceRow> rows,
                    std::span<const signals::JointControllerGains> gains) {
  const auto sorted = by_joint(robot, rows);
  double largest = 0.0;
  for (const robot::Joint& joint : robot.joints) {
    const double bump = largest_bump(joint, sorted[joint.number], gains);
    if (std::isnan(bump)) {
      return bump;
    }
    largest = std::max(largest, bump);
  }
  return largest;
}

}  // namespace farrier::trials
