#pragma once

// A HyQ that trots, as its summaries, gains, estimates, decisions and events would tell it; nothing is simulated. For
// tests of what shows robots.

#include <cstdint>
#include <string>
#include <vector>

#include "robot/robot.hpp"
#include "recording/recording_file.hpp"

namespace farrier::test {

class MadeUpRobot {
 public:
  static constexpr int kTicksPerStep = 20;  ///< 20 ms

  /// Everything it says goes to `take`. `robot` must outlive it.
  MadeUpRobot(const robot::Robot& robot, recording::TakeSample take)
      : robot_(robot), take_(std::move(take)), faults_(robot.joints.size()) {}

  /// A run begins, at tick 0: hellos, mode, gains.
  void begin(std::uint64_t session, std::uint64_t time_ns);
  /// Twenty ticks later.
  void step(std::uint64_t time_ns);
  /// FaultSet bits of a joint from now on; an event says so.
  void set_faults(std::uint16_t joint, std::uint32_t bits, std::uint64_t time_ns);

  /// A robot whose file describes a body trots straight ahead on a ground, unless it stands on a bench.
  void stand_on_bench(bool on_bench) noexcept { says_body_ = !on_bench; }

  Tick tick() const noexcept { return tick_; }

 private:
  template <class Signal>
  void say(const Signal& signal);
  void say_event(std::uint16_t participant, signals::Severity severity, std::uint16_t joint, const std::string& text);
  void say_summaries();
  void say_body();
  void say_supply(Tick tick);
  void say_gains(std::uint16_t joint, signals::Phase phase);
  void say_estimates();
  signals::Phase phase_of(int leg, Tick tick) const;

  const robot::Robot& robot_;
  recording::TakeSample take_;
  std::vector<std::uint32_t> faults_;
  std::vector<std::uint8_t> cdr_;
  Tick tick_ = 0;
  bool says_body_ = true;
  std::uint64_t time_ns_ = 0;
  std::uint32_t generation_ = 1, events_ = 0, announcements_ = 0;
};

/// A recording of `seconds` of it, in the middle of which the first knee loses its force for two seconds.
void write_made_up_recording(const std::string& path, const robot::Robot& robot, int seconds);

}  // namespace farrier::test
