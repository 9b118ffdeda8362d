#pragma once

#include <string>

#include "core/time.hpp"

namespace farrier::participant {

/// A process's node bound to its ports, driven from outside: by a process's main loop over DDS, or by the lab, which
/// drives all of them in one thread over the in-process bus.
class Application {
 public:
  virtual ~Application() = default;

  /// Does all work that is possible now. `now` is the steady clock; in lock-step nothing in a trace depends on it.
  virtual void poll(SteadyTime now) = 0;

  /// True when the run's last tick is done.
  virtual bool finished() const = 0;

  /// Lower bound of the samples that must still arrive before poll() can do more; at least 1.
  virtual int missing() const = 0;

  /// Returns the input that it waits for, for people: "joint/sensors of lf_kfe at tick 1312".
  virtual std::string waits_for() const = 0;
};

}  // namespace farrier::participant
