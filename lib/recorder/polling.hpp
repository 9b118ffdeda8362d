#pragma once

#include "bus/bus.hpp"
#include "recorder/watching_endpoint.hpp"
#include "robot/robot.hpp"
#include "signals/tick_of.hpp"

namespace farrier::recorder {

/// The reading end of an observer who polls: one sample of each key is kept, and none wakes a thread.
inline bus::EndpointSpec polled_endpoint(const robot::Robot& robot, bus::TopicId topic) {
  bus::EndpointSpec endpoint = watching_endpoint(robot, topic, 1);
  endpoint.wakes = false;
  return endpoint;
}

/// Times that are a period apart; those that were missed are left out.
class Due {
 public:
  explicit Due(Nanoseconds period) : period_(period) {}
  bool now(SteadyTime now) {
    if (now < next_) {
      return false;
    }
    next_ = next_ + period_ > now ? next_ + period_ : now + period_;
    return true;
  }
  SteadyTime next() const noexcept { return next_; }

 private:
  Nanoseconds period_;
  SteadyTime next_{};
};

/// The newest sample of a topic, by a polled reader.
template <class Signal>
class Newest {
 public:
  static Result<Newest> create(bus::Bus& bus, const robot::Robot& robot) {
    auto heard = FARRIER_TRY(bus::Subscription<Signal>::create(bus, polled_endpoint(robot, bus::TopicOf<Signal>::id)));
    return Newest(std::move(heard));
  }
  /// True if one has come.
  bool drain() {
    bool came = false;
    heard_.drain([&](const Signal& signal) {
      if (!signals::is_probe(signal)) {
        sample_ = signal;
        came = true;
      }
    });
    return came;
  }
  const Signal& sample() const noexcept { return sample_; }

 private:
  explicit Newest(bus::Subscription<Signal> heard) : heard_(std::move(heard)) {}

  bus::Subscription<Signal> heard_;
  Signal sample_;
};

}  // namespace farrier::recorder
