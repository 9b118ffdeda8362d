#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "participant/application.hpp"
#include "participant/participant.hpp"
#include "participant/realtime_loop.hpp"
#include "robot/robot.hpp"

namespace farrier::bench {

/// Baseline of a timer on this computer: a thread with the control loop's priority that does nothing but wake up.
struct TimerLoop {
  std::array<double, 4> wake_up_s;  ///< after the deadline: p50, p99, p99.9, largest
  std::uint64_t periods, missed;
};
TimerLoop bare_timer_loop(Nanoseconds period, Nanoseconds duration);

/// sim_bridge of a bare exchange on the real-time clock: sensors of all joints on each deadline, straight from the
/// timer's thread; it measures when their valve commands come.
Result<std::unique_ptr<participant::RealtimeApplication>> create_bare_clock(const robot::Robot& robot,
                                                                            participant::Participant& participant,
                                                                            Tick ticks);

/// The other members: each answers what it receives at once, by one thread, with nothing computed.
/// `joints`: those a joint node hosts; the participant's number says what it is.
Result<std::unique_ptr<participant::Application>> create_bare_answer(const robot::Robot& robot,
                                                                     const std::vector<std::string>& joints,
                                                                     participant::Participant& participant);

}  // namespace farrier::bench
