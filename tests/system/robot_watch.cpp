#include "robot_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bus_factory/bus_factory.hpp"
#include "core/fault.hpp"
#include "robot/keys.hpp"

namespace farrier::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

bool in_state(const trace::TraceRow& row, signals::JointState state) { return row.state == state; }

}  // namespace

Result<std::vector<trace::TraceRow>> trace_after(DeployedProcesses& processes, const robot::Robot& robot) {
  EXPECT_EQ(processes.stop(), "");
  auto trace = trace::read_trace(processes.trace_path(), robot::joint_names(robot));
  if (trace && testing::Test::HasFailure()) {
    return Error{"the run ended early"};
  }
  return trace;
}

RobotWatch::RobotWatch(const robot::Robot& robot, const participant::ProcessOptions& seat) {
  const participant::Identity identity{.name = "watch",
                                       .robot = robot.name,
                                       .participants = seat.participants,
                                       .session = seat.session,
                                       .clock = seat.clock,
                                       .slow = seat.slow};
  auto bus = bus_factory::create_bus(seat.vendor, participant::network_of(seat));
  if (!bus) {
    ADD_FAILURE() << bus.error().message;
    return;
  }
  bus_ = std::move(bus).value();
  clock_ =
      bus::Subscription<signals::ClockTick>::create(*bus_, participant::endpoint_of(identity, bus::TopicId::kClockTick))
          .value();
  requests_ = bus::Publisher<signals::SystemRequest>::create(
                  *bus_, participant::endpoint_of(identity, bus::TopicId::kSystemRequest))
                  .value();
  monitor_ = run::RunMonitor::create(*bus_, identity).value();
  request_.session = seat.session;
  request_.request = signals::Request::kArm;
}

RobotWatch::~RobotWatch() = default;

Tick RobotWatch::now() {
  clock_->drain([&](const signals::ClockTick& clock) { newest_ = std::max(newest_, clock.tick); });
  monitor_->poll(newest_);
  return newest_;
}

void RobotWatch::arm() {
  request_.tick = now();
  ++request_.count;
  requests_->publish(request_);
}

Tick RobotWatch::until(Tick tick, std::chrono::seconds budget) {
  const auto end = Clock::now() + budget;
  for (;;) {
    const std::uint64_t before = bus_->arrivals();
    if (now() >= tick || Clock::now() >= end) {
      return newest_;
    }
    bus_->wait_for_arrivals(before + 1, 2ms);
  }
}

JointCourse::JointCourse(const robot::Robot& robot, const std::vector<trace::TraceRow>& trace,
                         std::vector<std::string> legs)
    : rows_(robot.joints.size()) {
  for (const robot::Joint& joint : robot.joints) {
    if (std::ranges::find(legs, robot.plan.legs[static_cast<std::size_t>(joint.leg)].name) != legs.end()) {
      joints_.push_back(joint.number);
    }
  }
  for (const trace::TraceRow& row : trace) {
    rows_[row.joint].push_back(row);
  }
  end_ = std::ssize(*std::ranges::min_element(rows_, {}, [](const auto& rows) { return rows.size(); }));
}

bool is_null(const trace::TraceRow& row) { return in_state(row, signals::JointState::kNull); }
bool is_tracking(const trace::TraceRow& row) { return in_state(row, signals::JointState::kTracking); }
bool is_silent(const trace::TraceRow& row) { return FaultSet(row.faults).has(Fault::kActuatorSilent); }
bool has_tripped(const trace::TraceRow& row) { return FaultSet(row.faults).has(Fault::kTripped); }

}  // namespace farrier::test
