#pragma once

// The real-time clock's three threads: the bus thread receives, the control thread steps, the sender thread
// publishes. Samples cross between them through latest-value cells and rings; the control thread never calls DDS.

#include <atomic>
#include <string>

#include "core/time.hpp"
#include "participant/participant.hpp"
#include "participant/wake_up.hpp"

namespace farrier::participant {

/// A control thread's wake-up for one period.
struct Wake {
  SteadyTime now;
  SteadyTime due;            ///< the deadline; of a loop that steps on arrival: the latest time to step
  std::uint64_t missed = 0;  ///< whole periods skipped since the last one
};

class RealtimeApplication {
 public:
  enum class Trigger {
    kDeadline,  ///< step on the grid of the period
    kArrival,   ///< step when fresh inputs are complete, at the latest one and a half periods after the last step
  };

  virtual ~RealtimeApplication() = default;

  /// Bus thread: takes what has arrived, greets, reports health. True once the run has started.
  virtual bool receive(SteadyTime now) = 0;
  /// Control thread: one period.
  virtual void step(const Wake& wake) noexcept = 0;
  /// Sender thread: publishes what the control thread has left.
  virtual void send() = 0;
  /// Sender thread, after send() and below every thread on the way from sensor to valve: publishes and writes what none
  /// of them waits for.
  virtual void send_at_leisure() {}
  /// True if `step` publishes itself, as in a baseline run.
  virtual bool publishes_in_step() const { return false; }
  virtual bool finished() const = 0;
  virtual Nanoseconds period() const = 0;
  virtual Trigger trigger() const = 0;
  virtual std::string waits_for() const = 0;

  WakeUp inputs_complete;  ///< posted by the bus thread
  WakeUp outputs_waiting;  ///< posted by the control thread
};

/// SCHED_FIFO priorities of a process's threads: until the run has begun for it, and from then on.
struct Priorities {
  int joining, control, bus, leisure;
};

/// Priorities of runtime/realtime_thread.hpp, each with `shift` added. With encryption all threads that publish have
/// the priority of the bus. The reason is that libcrypto's locks are glibc's, which spin without sleeping. A thread
/// would spin for ever if the owner of the lock has a lower priority on the same processor.
Priorities priorities_of(const RealtimeApplication& application, int shift, bool secured) noexcept;

/// Drives an application on the real-time clock until SIGTERM, or until the participant cannot take part. Returns the
/// process's exit status, as run does. Notifies systemd when the run has begun, and from then on while the control and
/// the sender thread turn.
int run_realtime(RealtimeApplication& application, Participant& member, const Priorities& priorities);

}  // namespace farrier::participant
