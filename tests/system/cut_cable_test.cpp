// The trot on three hosts in real time, in slow motion as farrier faults has it, while the cable of the front legs' host
// is pulled and put back: what the joints do is the table of docs/architecture.md.

#include <gtest/gtest.h>

#include <cstdio>

#include "deployed_robot.hpp"
#include "robot/keys.hpp"
#include "robot_watch.hpp"

namespace farrier::test {
namespace {

using namespace std::chrono_literals;

constexpr int kSlow = 3;
// All in ticks, of 1 ms in slow motion.
constexpr Tick kStanding = 500;
constexpr Tick kUndisturbed = 2500;
constexpr Tick kCuts[] = {300, 2000};
constexpr Tick kUntilArmed = 500;
constexpr Tick kAfterwards = 1000;
constexpr Tick kNulledWithin = 20;     // 5 without valve commands, and what the watch is behind
constexpr Tick kHeardAgainWithin = 50; // 150 ms of the machine's: DDS goes by its clock
constexpr Tick kTrackingWithin = 24;   // as docs/faults.md
/// A computer that others use stands still now and then.
constexpr double kMayNotTrack = 0.1;
constexpr auto kPatience = 60s;

/// When what was done to the cable; ticks of the clock, which may be some more by then.
struct Cut {
  Tick begin, end, armed;
};

bool is_heard(const record::TraceRow& row) { return !is_silent(row); }
bool is_not_null(const record::TraceRow& row) { return !is_null(row); }
bool is_not_tracking(const record::TraceRow& row) { return !is_tracking(row); }

class CutCable : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const std::string refusal = NetworkNamespaces::refusal(); !refusal.empty()) {
      GTEST_SKIP() << refusal;
    }
    const DeployedRun run{.dds = GetParam(), .clock = bus::ClockKind::kRealtime, .slow = kSlow};
    robot_.emplace(deployed_robot(run));
    const NetworkNamespaces network = network_of(*robot_);
    DeployedProcesses processes(*robot_, network, run);
    const NetworkNamespaces::Visit visit(network, "brain");
    RobotWatch watch(*robot_, processes.options_of("supervisor"));
    ASSERT_GE(watch.until(kUndisturbed, kPatience), kUndisturbed) << processes.output();
    for (const Tick lasts : kCuts) {
      Cut cut{.begin = watch.now(), .end = 0, .armed = 0};
      network.cut("front");
      cut.end = watch.until(cut.begin + lasts, kPatience);
      network.restore("front");
      cut.armed = watch.until(cut.end + kUntilArmed, kPatience);
      watch.arm();
      ASSERT_GE(watch.until(cut.armed + kAfterwards, kPatience), cut.armed + kAfterwards) << processes.output();
      cuts_.push_back(cut);
    }
    for (const signals::SystemEvent& event : watch.monitor().events()) {
      trips_ += signals::text_of(event.text).find("tripped, sensors stale, command stale") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(processes.stop(), "");
    const auto trace = record::read_trace(processes.trace_path(), robot::joint_names(*robot_));
    ASSERT_TRUE(trace) << trace.error().message;
    front_.emplace(*robot_, trace.value(), std::vector<std::string>{"lf", "rf"});
    hind_.emplace(*robot_, trace.value(), std::vector<std::string>{"lh", "rh"});
  }

  static double share(const JointCourse& legs, bool (*as)(const record::TraceRow&), Tick begin, Tick end) {
    return static_cast<double>(legs.count(as, begin, end)) / static_cast<double>(legs.joints() * (end - begin));
  }

  std::optional<robot::Robot> robot_;
  std::vector<Cut> cuts_;
  std::size_t trips_ = 0;  ///< events of them
  std::optional<JointCourse> front_, hind_;
};

TEST_P(CutCable, StopsTheLegsBehindItUntilTheyAreArmedAndNoOthers) {
  for (const JointCourse* legs : {&*front_, &*hind_}) {
    EXPECT_EQ(legs->count(has_tripped, kStanding, cuts_.front().begin), 0u);
    EXPECT_LE(share(*legs, is_not_tracking, kStanding, cuts_.front().begin), kMayNotTrack);
  }
  for (const Cut& cut : cuts_) {
    const auto silent = front_->first(is_silent, cut.begin, cut.end);
    const auto heard = front_->first(is_heard, cut.end, cut.armed);
    const auto tracking = front_->first(is_tracking, cut.armed, cut.armed + kAfterwards);
    ASSERT_TRUE(silent && heard && tracking) << cut.begin;
    std::printf("%s: cut for %ld ms: spools at null after %ld ms, heard again after %ld ms (%ld ms of the machine's), "
                "tracking %ld ms after the request to arm\n",
                GetParam(), cut.end - cut.begin, *silent - cut.begin, *heard - cut.end, kSlow * (*heard - cut.end),
                *tracking - cut.armed);
    EXPECT_LE(*silent - cut.begin, kNulledWithin);
    EXPECT_EQ(front_->count(is_not_null, *silent, cut.armed), 0u);
    EXPECT_LE(*heard - cut.end, kHeardAgainWithin);
    EXPECT_EQ(front_->count(has_tripped, *heard, *heard + 1), front_->joints());
    EXPECT_LE(*tracking - cut.armed, kTrackingWithin);
    EXPECT_LE(share(*front_, is_not_tracking, *tracking, cut.armed + kAfterwards), kMayNotTrack);
    EXPECT_EQ(front_->count(has_tripped, *tracking, cut.armed + kAfterwards), 0u);
    EXPECT_LE(share(*hind_, is_not_tracking, cut.begin, cut.armed), kMayNotTrack);
  }
  EXPECT_EQ(hind_->count(has_tripped, kStanding, hind_->end()), 0u);
  EXPECT_EQ(trips_, front_->joints() * cuts_.size()) << "an operator hears of every trip, once the cable is back";
}

INSTANTIATE_TEST_SUITE_P(Over, CutCable, testing::Values("cyclone", "fast", "mixed"),
                         [](const auto& dds) { return std::string(dds.param); });

}  // namespace
}  // namespace farrier::test
