#include "monitor/robot_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "control/model/model_rows.hpp"
#include "estimation/poles.hpp"
#include "monitor/load_mass.hpp"
#include "recording/visit_sample.hpp"
#include "signals/tick_of.hpp"

namespace farrier::monitor {
namespace {

constexpr std::size_t kMostParticipants = 256;  // of a robot: a number beyond is no participant's

double seconds(std::uint64_t from_ns, std::uint64_t to_ns) noexcept {
  return from_ns == 0 ? std::numeric_limits<double>::infinity()
                      : static_cast<double>(to_ns - std::min(from_ns, to_ns)) * 1e-9;
}

}  // namespace

RobotView::RobotView(const robot::Robot& robot)
    : robot_(robot), body_(BodyView::create(robot)), supply_(robot.period_s) {
  begin_anew();
}

const std::vector<bus::TopicId>& RobotView::topics() {
  using enum bus::TopicId;
  static const std::vector<bus::TopicId> topics{kJointSummary,
                                                kJointControllerGains,
                                                kJointModelEstimateCopy,
                                                kJointUpdateDecision,
                                                kGaitPhase,
                                                kSystemMode,
                                                kSystemHello,
                                                kSystemHealth,
                                                kSystemEvent,
                                                kBodyTruth,
                                                kBodyState,
                                                kSupplyState,
                                                kSupplyTruth};
  return topics;
}

void RobotView::begin_anew() {
  tick_ = kNoTick;
  mode_ = {};
  joints_.assign(robot_.joints.size(), {});
  legs_.assign(robot_.plan.legs.size(), {});
  switches_.assign(robot_.plan.legs.size(), std::vector<Switch>{{kNoTick, signals::Phase::kStance}});
  participants_.clear();
  if (body_) {
    body_->begin_anew();
  }
  supply_.begin_anew();
}

double RobotView::since_first_s(std::uint64_t time_ns) const noexcept {
  return first_ns_ == 0 ? 0.0 : seconds(first_ns_, time_ns);
}

void RobotView::take(const recording::Sample& sample) {
  first_ns_ = first_ns_ == 0 ? sample.log_time_ns : first_ns_;
  newest_ns_ = std::max(newest_ns_, sample.log_time_ns);
  recording::visit_sample(sample, [this](const auto& signal) {
    if (!signals::is_probe(signal)) {
      take(signal);
    }
  });
}

void RobotView::note(signals::Severity severity, std::string text, std::uint64_t time_ns) {
  events_.push_back({event_count_++, since_first_s(time_ns), tick_, severity, "monitor", {}, std::move(text)});
}

void RobotView::take(const signals::JointSummary& summary) {
  if (summary.joint >= joints_.size()) {
    return;
  }
  Joint& joint = joints_[summary.joint];
  tick_ = std::max(tick_, summary.tick);
  const Tick before = joint.now.newest.tick;
  const double ticks = summary.ticks;
  if (before != kNoTick && summary.tick > before && joint.second.size() > 1) {
    // Compares two summaries in a row; a summary that is itself lost says nothing about control.
    const Tick expected = summary.tick - before;
    const Tick usual = joint.second.back().tick - joint.second[joint.second.size() - 2].tick;
    joint.now.missed_ticks += expected <= usual + usual / 2 && expected > summary.ticks
                                  ? static_cast<std::uint64_t>(expected - summary.ticks)
                                  : 0;
  }
  const double error = summary.force_error_rms_N_or_Nm;
  const double reference = summary.force_reference_rms_N_or_Nm;
  joint.second.push_back(
      {newest_ns_, summary.tick, summary.ticks, ticks * error * error, ticks * reference * reference});
  joint.heard_ns = newest_ns_;
  joint.now.newest = summary;
  joint.now.faults |= summary.faults;
  joint.now.summaries.push_back(summary);
}

void RobotView::take(const signals::JointControllerGains& gains) {
  if (gains.joint < joints_.size() && known(gains.phase)) {
    joints_[gains.joint].now.gains[gains.phase] = gains;
  }
}

void RobotView::take(const signals::JointModelEstimateCopy& estimate) {
  if (estimate.joint < joints_.size()) {
    JointFrame& joint = joints_[estimate.joint].now;
    joint.estimate = estimate;
    joint.poles = estimation::poles<3>(control::model_of_rows(estimate.a, estimate.b).a);
    joint.mass_kg_or_kgm2 = load_mass(estimate, robot_.period_s);
  }
}

void RobotView::take(const signals::JointUpdateDecision& decision) {
  if (decision.joint < joints_.size()) {
    JointFrame& joint = joints_[decision.joint].now;
    joint.decision = decision;
    joint.redesigns += decision.verdict == signals::UpdateVerdict::kAccepted ? 1 : 0;
  }
}

void RobotView::take(const signals::GaitPhase& phase) {
  if (phase.leg < switches_.size() && known(phase.phase)) {
    std::vector<Switch>& leg = switches_[phase.leg];
    // A touchdown that is felt comes before the one that was announced for later.
    std::erase_if(leg, [&](const Switch& one) { return one.tick > phase.switch_tick; });
    leg.push_back({phase.switch_tick, phase.phase});
    ++(phase.felt != 0 ? legs_[phase.leg].felt_switches : legs_[phase.leg].planned_switches);
  }
}

void RobotView::take(const signals::SystemMode& mode) {
  tick_ = std::max(tick_, mode.effective_tick);
  mode_ = mode;
}

void RobotView::take(const signals::SystemHello& hello) {
  if (hello.participant >= kMostParticipants) {
    return;
  }
  if (hello.session != session_) {
    if (session_ != 0) {
      begin_anew();
      note(signals::Severity::kInfo, "another run begins: session " + std::to_string(hello.session), newest_ns_);
    }
    session_ = hello.session;
  }
  participants_.resize(std::max<std::size_t>(participants_.size(), hello.participant + 1u));
  participants_[hello.participant].now.hello = hello;
}

void RobotView::take(const signals::SystemHealth& health) {
  if (health.participant >= kMostParticipants) {
    return;
  }
  tick_ = std::max(tick_, health.tick);
  participants_.resize(std::max<std::size_t>(participants_.size(), health.participant + 1u));
  participants_[health.participant].now.health = health;
  participants_[health.participant].heard_ns = newest_ns_;
}

void RobotView::take(const signals::BodyTruth& truth) {
  if (body_) {
    body_->take(truth, newest_ns_);
  }
}

void RobotView::take(const signals::BodyState& state) {
  if (body_) {
    body_->take(state, newest_ns_);
  }
}

void RobotView::take(const signals::SystemEvent& event) {
  std::string who = "participant " + std::to_string(event.participant);
  if (event.participant < participants_.size() && participants_[event.participant].now.hello.session != 0) {
    who = signals::text_of(participants_[event.participant].now.hello.name);
  }
  events_.push_back({event_count_++, since_first_s(newest_ns_), event.tick, event.severity, std::move(who),
                     event.joint < robot_.joints.size() ? robot_.joints[event.joint].name : std::string(),
                     std::string(signals::text_of(event.text))});
}

Frame RobotView::frame(std::uint64_t time_ns) {
  Frame frame;
  frame.time_s = since_first_s(time_ns);
  frame.tick = tick_;
  frame.age_s = seconds(newest_ns_, time_ns);
  frame.mode = mode_;
  frame.events = std::exchange(events_, {});
  for (std::vector<Switch>& leg : switches_) {
    const auto ahead = std::ranges::find_if(leg, [&](const Switch& one) { return one.tick > tick_; });
    leg.erase(leg.begin(), ahead - 1);
    frame.phases.push_back(leg.front().phase);
  }
  frame.legs = legs_;
  for (Joint& joint : joints_) {
    while (!joint.second.empty() && seconds(joint.second.front().time_ns, time_ns) > 1.0) {
      joint.second.pop_front();
    }
    JointFrame& now = joint.now;
    double ticks = 0.0, squared_error = 0.0, squared_reference = 0.0;
    for (const Heard& heard : joint.second) {
      ticks += heard.ticks;
      squared_error += heard.squared_error;
      squared_reference += heard.squared_reference;
    }
    now.force_error_rms = ticks > 0.0 ? std::sqrt(squared_error / ticks) : 0.0;
    now.force_reference_rms = ticks > 0.0 ? std::sqrt(squared_reference / ticks) : 0.0;
    now.age_s = seconds(joint.heard_ns, time_ns);
    now.rate_Hz = 0.0;
    if (joint.second.size() > 1 && joint.second.back().time_ns > joint.second.front().time_ns) {
      now.rate_Hz = static_cast<double>(joint.second.back().tick - joint.second.front().tick) /
                    seconds(joint.second.front().time_ns, joint.second.back().time_ns);
    }
    frame.joints.push_back(now);
    now.summaries.clear();
    now.faults = now.newest.faults;
  }
  if (body_) {
    frame.body = body_->frame(frame.joints, time_ns);
  }
  frame.supply = supply_.frame(time_ns);
  for (Participant& participant : participants_) {
    participant.now.age_s = seconds(participant.heard_ns, time_ns);
    frame.participants.push_back(participant.now);
  }
  return frame;
}

}  // namespace farrier::monitor
