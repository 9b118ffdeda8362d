#pragma once

// The fixture of the conformance suite: a writing and a reading bus that belong to different "processes", and the
// words the tests are told in.

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "buses.hpp"

namespace farrier::contract {

using namespace std::chrono_literals;

// Budgets are for a loaded two-core machine; what DDS itself needs is in the comments.
inline constexpr Nanoseconds kMatchBudget = 10s;      ///< 5 ms; 1 s where Fast's endpoint discovery repeats itself
inline constexpr Nanoseconds kDeliveryBudget = 5s;    ///< 0.1 ms; tens of ms where a datagram was lost
inline constexpr Nanoseconds kLateJoinerBudget = 5s;  ///< tens of ms, a heartbeat
inline constexpr Nanoseconds kSilenceBudget = 2s;     ///< to notice a lease or a deadline
inline constexpr Nanoseconds kQuietWindow = 200ms;    ///< ten leases of a topic that carries authority
inline constexpr Nanoseconds kAcknowledged = 200ms;   ///< for a sample's acknowledgement to be back
inline constexpr Nanoseconds kDeadline = 10ms;
inline constexpr Nanoseconds kPollPeriod = 5ms;

struct Pair {
  const char* name;
  bus::Vendor writer;
  bus::Vendor reader;
};

inline void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.name; }

/// Waits until `condition` holds, woken by arrivals of `bus`; false when it does not within the budget.
template <class Condition>
bool wait_until(bus::Bus& bus, Nanoseconds budget, Condition&& condition) {
  const SteadyTime end = std::chrono::steady_clock::now() + budget;
  for (;;) {
    const std::uint64_t seen = bus.arrivals();
    if (condition()) {
      return true;
    }
    if (std::chrono::steady_clock::now() >= end) {
      return false;
    }
    bus.wait_for_arrivals(seen + 1, kPollPeriod);
  }
}

inline bus::Qos reliable(int depth = 1, bus::Durability durability = bus::Durability::kVolatile) {
  return {bus::Reliability::kReliable, durability, depth};
}

/// The two buses of a pair.
struct Buses {
  std::shared_ptr<bus::InprocDomain> inproc =
      std::make_shared<bus::InprocDomain>([] { return std::chrono::steady_clock::now(); });
  std::unique_ptr<bus::Bus> writer;
  std::unique_ptr<bus::Bus> reader;

  explicit Buses(const Pair& pair)
      : writer(make_bus(pair.writer, own_domain(), inproc)), reader(make_bus(pair.reader, own_domain(), inproc)) {}
};

/// The tests of a pair share its buses, as the endpoints of a process do. Their endpoints meet in partitions of their
/// own: news of an endpoint's end takes up to a second, and until then it counts as matched.
class Conformance : public testing::TestWithParam<Pair> {
 protected:
  static void TearDownTestSuite() { shared_.clear(); }

  void SetUp() override {
    if (!available(GetParam().writer) || !available(GetParam().reader)) {
      GTEST_SKIP() << "this build has no Fast DDS";
    }
    buses_ = buses();
    use_another_robot();
  }

  /// The buses of this test.
  virtual std::shared_ptr<Buses> buses() {
    std::shared_ptr<Buses>& shared = shared_[GetParam().name];
    if (!shared) {
      shared = std::make_shared<Buses>(GetParam());
    }
    return shared;
  }

  /// The partition of this test's present endpoints.
  std::string robot() const { return "robot" + std::to_string(robots_); }
  /// Leaves the endpoints so far behind.
  void use_another_robot() { ++robots_; }

  bus::Bus& writer_bus() { return *buses_->writer; }
  bus::Bus& reader_bus() { return *buses_->reader; }
  const std::shared_ptr<bus::InprocDomain>& inproc() { return buses_->inproc; }

  template <class Signal>
  bus::Publisher<Signal> publisher(const bus::Qos& qos, std::vector<std::string> partitions = {}) {
    auto created = bus::Publisher<Signal>::create(
        writer_bus(), {bus::TopicOf<Signal>::id, qos, in_robot(std::move(partitions))});
    FARRIER_ENSURE(created.ok(), created.error().message.c_str());
    return std::move(created).value();
  }

  template <class Signal>
  bus::Subscription<Signal> subscription(const bus::Qos& qos, std::vector<std::string> partitions = {},
                                         bool wakes = true) {
    bus::EndpointSpec endpoint{bus::TopicOf<Signal>::id, qos, in_robot(std::move(partitions))};
    endpoint.wakes = wakes;
    auto created = bus::Subscription<Signal>::create(reader_bus(), endpoint);
    FARRIER_ENSURE(created.ok(), created.error().message.c_str());
    return std::move(created).value();
  }

  /// Both ends know of each other: the writer of `readers` readers, the reader of one writer.
  template <class Signal>
  testing::AssertionResult matched(const bus::Publisher<Signal>& publisher,
                                   const bus::Subscription<Signal>& subscription, int readers = 1) {
    if (wait_until(reader_bus(), kMatchBudget, [&] {
          return publisher.matched_readers() >= readers && subscription.status().matched_writers >= 1;
        })) {
      await_first_heartbeat();
      return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << "writer knows " << publisher.matched_readers() << " of " << readers
                                       << " readers, reader knows " << subscription.status().matched_writers
                                       << " of 1 writers";
  }

  /// Takes samples until `count` have come or the budget is spent.
  template <class Signal>
  std::vector<Signal> receive(bus::Subscription<Signal>& subscription, std::size_t count,
                              Nanoseconds budget = kDeliveryBudget) {
    std::vector<Signal> samples;
    wait_until(reader_bus(), budget, [&] {
      subscription.drain([&](const Signal& signal) { samples.push_back(signal); });
      return samples.size() >= count;
    });
    return samples;
  }

  /// Everything that waits now.
  template <class Signal>
  std::vector<Signal> taken(bus::Subscription<Signal>& subscription) {
    std::vector<Signal> samples;
    subscription.drain([&](const Signal& signal) { samples.push_back(signal); });
    return samples;
  }

 private:
  /// Cyclone DDS 0.10 takes samples that the first heartbeat of Fast DDS reports, and that have not come, for older
  /// than its reader. It asks for that heartbeat a few milliseconds after both know of each other.
  void await_first_heartbeat() const {
    if (GetParam().writer == bus::Vendor::kFast && GetParam().reader == bus::Vendor::kCyclone) {
      std::this_thread::sleep_for(50ms);
    }
  }

  /// Names of partitions within this test's; without any, the robot's own.
  std::vector<std::string> in_robot(std::vector<std::string> partitions) const {
    for (std::string& partition : partitions) {
      partition = bus::partition(robot(), partition);
    }
    return partitions.empty() ? std::vector{robot()} : partitions;
  }

  static inline int robots_ = 0;
  static inline std::map<std::string, std::shared_ptr<Buses>> shared_;

  std::shared_ptr<Buses> buses_;
};

}  // namespace farrier::contract
