// watch_joint ROBOT.yaml JOINT DOMAIN: prints what a joint of a robot measures that runs on this computer in real time,
// ten lines of it. A process of one's own that only listens: it opens the topic as the robot's processes do and takes
// no part in the run.

#include <cstdio>
#include <cstdlib>

#include "bus_factory/bus_factory.hpp"
#include "participant/participant.hpp"
#include "process/process.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  using namespace std::chrono_literals;
  if (argc != 4) {
    std::fprintf(stderr, "usage: watch_joint ROBOT.yaml JOINT DOMAIN\n");
    return 2;
  }
  const auto robot = robot::load_robot(argv[1]);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return 2;
  }
  const robot::Joint* const joint = robot.value().find(argv[2]);
  if (joint == nullptr) {
    std::fprintf(stderr, "watch_joint: %s has no joint '%s'\n", argv[1], argv[2]);
    return 2;
  }
  bus::NetworkOptions network;
  network.domain = std::atoi(argv[3]);
  auto bus = bus_factory::create_bus(bus::Vendor::kCyclone, network);
  if (!bus) {
    std::fprintf(stderr, "watch_joint: %s\n", bus.error().message.c_str());
    return 1;
  }
  // The listener has the robot's clock: a reader for lock-step asks for more than a writer in real time offers.
  const participant::Identity listener{
      .name = "watch_joint", .robot = robot.value().name, .clock = bus::ClockKind::kRealtime};
  auto measurements = bus::Subscription<signals::JointMeasurement>::create(
      *bus.value(), participant::endpoint_of(listener, bus::TopicId::kJointMeasurement));
  if (!measurements) {
    std::fprintf(stderr, "watch_joint: %s\n", measurements.error().message.c_str());
    return 1;
  }
  int lines = 0;
  for (int waits = 0; lines < 10 && waits < 100; ++waits) {
    const std::uint64_t arrivals = bus.value()->arrivals();
    measurements.value().drain([&](const signals::JointMeasurement& m) {
      if (m.joint == joint->number && lines < 10) {
        std::printf("tick %lld: force %g %s\n", static_cast<long long>(m.tick), m.force_N_or_Nm,
                    joint->rotary ? "Nm" : "N");
        ++lines;
      }
    });
    bus.value()->wait_for_arrivals(arrivals + 1, 100ms);
  }
  if (lines == 0) {
    std::fprintf(stderr, "watch_joint: nothing came within 10 s: is the robot running in domain %s?\n", argv[3]);
  }
  return lines > 0 ? 0 : 1;
}
