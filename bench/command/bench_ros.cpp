#include "bench/command/bench_ros.hpp"

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "bus_ros/ros_node.hpp"
#include "core/median.hpp"
#include "participant/participant.hpp"

namespace farrier::cli {
namespace {

constexpr int kRosDomain = 66;
constexpr const char* kLoopback = "127.0.0.1";
constexpr Tick kRosTicks = 5000;
constexpr int kRosPairs = 9;
// The least the product promises.
constexpr double kRosPercent = 3.0;
constexpr double kRosLatencyRatio = 1.05;

/// A node that reads joint states while it lives.
class Reader {
 public:
  static Result<std::unique_ptr<Reader>> create(const robot::Robot& robot) {
    auto node =
        FARRIER_TRY(bus_ros::RosNode::create({.network = {.domain = kRosDomain, .address = kLoopback, .peers = {}},
                                              .name = "bench",
                                              .ros_namespace = "/" + robot.name,
                                              .graph = bus_ros::Graph::kJazzy}));
    auto states = FARRIER_TRY(node.reader<JointState>("joint_states", {.reliable = true, .depth = 100}));
    return std::unique_ptr<Reader>(new Reader(std::move(node), std::move(states)));
  }
  ~Reader() {
    ends_ = true;
    thread_.join();
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  std::uint64_t messages() const noexcept { return messages_; }

 private:
  using JointState = ros_messages::sensor_msgs::JointState;

  Reader(bus_ros::RosNode node, bus_ros::RosReader<JointState> states)
      : node_(std::move(node)), states_(std::move(states)), thread_([this] { read(); }) {}
  void read() {
    while (!ends_) {
      states_.take([this](const JointState&, std::uint64_t) { ++messages_; });
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  bus_ros::RosNode node_;
  bus_ros::RosReader<JointState> states_;
  std::atomic<bool> ends_{false};
  std::atomic<std::uint64_t> messages_{0};
  std::thread thread_;
};

/// One run, and what came of it.
struct Measured {
  double latency_s = 0.0, processor_share = 0.0, messages_per_s = 0.0;
};

Result<Measured> measure_ros(const robot::Robot& robot, DdsRun run, bool beside) {
  std::unique_ptr<Reader> reader;
  if (beside) {
    reader = FARRIER_TRY(Reader::create(robot));
    run.onlookers = {{.name = "ros",
                      .arguments = {"ros", "--ros-domain", std::to_string(kRosDomain), "--ros-address", kLoopback},
                      .listens = "commands are refused"}};
  }
  const auto outcome = FARRIER_TRY(run_over_dds(robot, run));
  Measured measured{.latency_s = outcome.healths[participant::kSimBridge].latency_s[0]};
  if (beside) {
    measured.processor_share = outcome.onlookers.front().processor_share;
    measured.messages_per_s = static_cast<double>(reader->messages()) / outcome.wall_s;
  }
  return measured;
}

}  // namespace

Result<Done> bench_ros(const robot::Robot& robot, const DdsRun& plain, report::Figures& figures) {
  std::vector<double> alone, beside, ratios, shares, rates;
  for (int pair = 1; pair <= kRosPairs; ++pair) {
    // The order alternates, too: a speed that rises or falls for a while favours neither.
    for (const bool with_node : {pair % 2 == 0, pair % 2 == 1}) {
      DdsRun run = plain;
      run.common.clock = bus::ClockKind::kRealtime;
      run.common.ticks = kRosTicks;
      run.title = std::string(with_node ? "real time, beside a node of ROS 2" : "real time, alone") + ", pair " +
                  std::to_string(pair) + " of " + std::to_string(kRosPairs);
      const auto measured = FARRIER_TRY(measure_ros(robot, run, with_node));
      (with_node ? beside : alone).push_back(measured.latency_s);
      if (with_node) {
        shares.push_back(measured.processor_share);
        rates.push_back(measured.messages_per_s);
      }
    }
    ratios.push_back(beside.back() / alone.back());
  }
  figures.add("bench.ros.processor_percent", 1e2 * median(shares), kRosPercent);
  figures.add("bench.ros.messages_per_s", median(rates));
  figures.add("bench.ros.alone_latency_p50_us", 1e6 * median(alone));
  figures.add("bench.ros.latency_p50_us", 1e6 * median(beside));
  figures.add("bench.ros.latency_p50_ratio", median(ratios), kRosLatencyRatio);
  return Done{};
}

}  // namespace farrier::cli
