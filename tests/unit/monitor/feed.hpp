#pragma once

// Frames of HyQ from samples that a test makes up, on a clock that it moves.

#include <gtest/gtest.h>

#include "monitor/robot_view.hpp"
#include "signals/cdr.hpp"

namespace farrier::monitor::testing {

inline constexpr std::uint64_t kSession = 77;
inline constexpr int kTicksPerSummary = 20;  // fifty summaries a second at 1 kHz

inline const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_robot(FARRIER_ROBOTS "hyq.yaml").value();
  return robot;
}

inline signals::JointSummary summary(std::uint16_t joint, Tick tick) {
  signals::JointSummary s;
  s.joint = joint;
  s.tick = tick;
  s.ticks = kTicksPerSummary;
  s.force_error_rms_N_or_Nm = 10.0;
  s.force_reference_rms_N_or_Nm = 200.0;
  s.generation = 3;
  s.state = signals::JointState::kTracking;
  s.phase = signals::Phase::kStance;
  return s;
}

inline signals::SystemHello hello(std::uint16_t participant, const char* name, std::uint64_t session = kSession) {
  signals::SystemHello h;
  h.participant = participant;
  h.session = session;
  h.vendor = 1;
  signals::assign(h.name, name);
  return h;
}

/// An estimate, without physics, of a joint that moves a load of this mass.
signals::JointModelEstimateCopy estimate(std::uint16_t joint, Tick tick, double mass);

class Feed {
 public:
  template <class Signal>
  void take(const Signal& signal) {
    signals::to_cdr(signal, cdr_);
    take_bytes(bus::TopicOf<Signal>::id);
  }
  void take_bytes(bus::TopicId topic, std::vector<std::uint8_t> bytes) {
    cdr_ = std::move(bytes);
    take_bytes(topic);
  }
  void pass(double seconds) { now_ns_ += static_cast<std::uint64_t>(seconds * 1e9); }

  /// Summaries of every joint, fifty a second, from `begin` on; change(summary) before each is taken. Time passes.
  template <class Change>
  void walk(Tick begin, int summaries, Change&& change) {
    for (int i = 0; i < summaries; ++i) {
      pass(0.02);
      for (const robot::Joint& joint : hyq().joints) {
        signals::JointSummary s = summary(joint.number, begin + (i + 1) * kTicksPerSummary);
        change(s);
        take(s);
      }
    }
  }
  void walk(Tick begin, int summaries) {
    walk(begin, summaries, [](signals::JointSummary&) {});
  }

  Frame frame() { return view_.frame(now_ns_); }
  RobotView& view() { return view_; }
  std::uint64_t now_ns() const { return now_ns_; }

 private:
  void take_bytes(bus::TopicId topic) {
    view_.take({.topic = topic, .sequence = 0, .log_time_ns = now_ns_, .publish_time_ns = now_ns_, .cdr = cdr_});
  }

  RobotView view_{hyq()};
  std::vector<std::uint8_t> cdr_;
  std::uint64_t now_ns_ = 1'700'000'000'000'000'000;
};

/// A robot that walks: a second of all joints, three processes, an estimate and gains for each joint, two events.
void walk_for_a_second(Feed& feed);

}  // namespace farrier::monitor::testing
