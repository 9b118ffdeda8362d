#include "joint_node/summariser.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::joint_node {

Summariser::Summariser(double period_s, Tick turn) noexcept
    : ticks_(std::max<Tick>(1, std::llround(1.0 / (kRate_Hz * period_s)))), turn_(turn % ticks_) {}

std::optional<signals::JointSummary> Summariser::take(const signals::JointMeasurement& m) noexcept {
  if (m.tick == kNoTick) {
    return {};
  }
  std::optional<signals::JointSummary> done;
  const bool again = m.tick == last_tick_;
  again_ = again ? again_ + 1 : 0;
  const Tick block = (m.tick + turn_) / ticks_;
  if (block != block_ || again_ == ticks_) {
    done = finish();
    block_ = block;
  }
  if (!again) {
    const double error = m.force_reference_N_or_Nm - m.force_N_or_Nm;
    squared_error_ += error * error;
    squared_reference_ += m.force_reference_N_or_Nm * m.force_reference_N_or_Nm;
    ++summary_.ticks;
  }
  last_tick_ = m.tick;
  const bool first = summary_.tick == kNoTick;
  summary_.joint = m.joint;
  summary_.tick = m.tick;
  summary_.sample_time_ns = m.sample_time_ns;
  summary_.position_m_or_rad = m.position_m_or_rad;
  summary_.velocity_m_s_or_rad_s = m.velocity_m_s_or_rad_s;
  summary_.force_N_or_Nm = m.force_N_or_Nm;
  summary_.force_reference_N_or_Nm = m.force_reference_N_or_Nm;
  summary_.valve_current_A = m.valve_current_A;
  summary_.generation = m.generation;
  summary_.faults |= m.faults;
  summary_.state = first ? m.state : std::min(summary_.state, m.state);
  summary_.phase = m.phase;
  return done;
}

std::optional<signals::JointSummary> Summariser::finish() noexcept {
  std::optional<signals::JointSummary> done;
  if (summary_.tick != kNoTick) {
    done = summary_;
    const double ticks = std::max<double>(1.0, summary_.ticks);
    done->force_error_rms_N_or_Nm = std::sqrt(squared_error_ / ticks);
    done->force_reference_rms_N_or_Nm = std::sqrt(squared_reference_ / ticks);
  }
  summary_ = {};
  squared_error_ = squared_reference_ = 0.0;
  again_ = 0;
  return done;
}

}  // namespace farrier::joint_node
