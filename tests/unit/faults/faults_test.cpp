// The table of faults: its rows make sense on the shipped robot, and its judge is not to be deceived.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "core/fault.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/unit/robot/test_files.hpp"
#include "tools/faults/cells_file.hpp"
#include "tools/faults/fault_page.hpp"
#include "tools/faults/tick_times.hpp"

namespace farrier::faults {
namespace faults_test {

using signals::JointState;

const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_shipped("hyq");
  return robot;
}

TEST(FaultRows, HaveNamesOfTheirOwnAndFaultsThatCanBeRead) {
  std::set<std::string> names;
  for (const Row& row : rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(find_row(row.name), &row);
    EXPECT_NE(row.arrows.empty(), row.acts.empty()) << row.name << ": samples or processes, not both";
    EXPECT_EQ(row.member != nullptr, !row.arrows.empty()) << row.name;
    EXPECT_EQ(arrow_faults(hyq(), row, {10, 20}).size(), row.arrows.size()) << row.name;
  }
  EXPECT_EQ(find_row("no_such_row"), nullptr);
}

TEST(FaultRows, HappenInThePhaseOfTheHitJointsLeg) {
  const gait::Schedule schedule(hyq().plan, 1);
  const int leg = hit_joint(hyq()).leg;
  for (const Row& row : rows()) {
    for (const gait::Phase phase : {gait::Phase::kStance, gait::Phase::kSwing}) {
      const TickSpan span = place_of(hyq(), schedule, row, phase);
      EXPECT_EQ(schedule.phase(leg, span.begin), phase) << row.name;
      EXPECT_NEAR(static_cast<double>(span.end - span.begin) * hyq().period_s, row.lasts_s, 1e-9) << row.name;
    }
  }
}

TEST(FaultRows, OutlastALeaseOfTheComputersClockAtAnyPace) {
  EXPECT_EQ(paced(*find_row("clock_back"), 3).lasts_s * 3, find_row("clock_back")->lasts_s);
  EXPECT_EQ(paced(*find_row("sensors_cut"), 3).lasts_s, find_row("sensors_cut")->lasts_s);
}

TEST(TickTimes, GivesAllTicksThatMayHaveGoneOn) {
  const SteadyTime start{std::chrono::seconds(5)};
  const auto at = [&](int milliseconds) { return start + std::chrono::milliseconds(milliseconds); };
  TickTimes times;
  times.saw(10, at(0));
  times.saw(11, at(3));
  times.saw(11, at(5));
  times.saw(15, at(12));
  const auto between = [&](int begin, int end) {
    const TickSpan span = times.between(at(begin), at(end));
    return std::pair(span.begin, span.end);
  };
  EXPECT_EQ(between(3, 4), std::pair(Tick{11}, Tick{16}));
  EXPECT_EQ(between(1, 3), std::pair(Tick{10}, Tick{12}));
  EXPECT_EQ(between(-2, 0), std::pair(Tick{0}, Tick{11}));
  EXPECT_EQ(between(4, 13), std::pair(Tick{11}, std::numeric_limits<Tick>::max()));
}

std::vector<Heard> told_at(Tick tick, const std::vector<std::string>& texts) {
  std::vector<Heard> events;
  for (const std::string& text : texts) {
    events.push_back({text, tick});
  }
  return events;
}

/// A trace in which every joint tracks, to be changed.
class Trace {
 public:
  static constexpr Tick kTicks = 1000;

  Trace() {
    for (Tick tick = 0; tick < kTicks; ++tick) {
      for (const robot::Joint& joint : hyq().joints) {
        trace::TraceRow row;
        row.tick = tick;
        row.joint = joint.number;
        row.state = JointState::kTracking;
        rows_.push_back(row);
      }
    }
  }

  Trace& joint_is(std::uint16_t joint, JointState state, Tick begin, Tick end, FaultSet faults = {}) {
    for (trace::TraceRow& row : rows_) {
      if (row.joint == joint && row.tick >= begin && row.tick < end) {
        row.state = state;
        row.faults = faults.bits();
      }
    }
    return *this;
  }

  std::vector<Check> judged(const char* row, const std::vector<std::string>& events = {}, Tick armed = 600) const {
    std::vector<Heard> heard = told_at(410, events);
    for (const auto& fault : arrow_faults(hyq(), *find_row(row), {400, 500})) {
      heard.push_back({"fault on purpose: " + to_string(fault), 415});
    }
    return judge(hyq(), *find_row(row), {{400, 500}, armed, pauses_}, rows_, heard);
  }

  Trace& computer_stood_still(Tick begin, Tick end) {
    pauses_.push_back({begin, end});
    return *this;
  }

  const std::vector<trace::TraceRow>& rows() const { return rows_; }

 private:
  std::vector<TickSpan> pauses_;
  std::vector<trace::TraceRow> rows_;
};

/// Keys of the checks that do not hold.
std::set<std::string> wrong(const std::vector<Check>& checks) {
  std::set<std::string> keys;
  for (const Check& check : checks) {
    if (!check.holds()) {
      keys.insert(check.key);
    }
  }
  return keys;
}

using Keys = std::set<std::string>;
const std::vector<std::string> kStale{"tracking -> null: sensors stale"};

TEST(FaultJudge, HoldsWhatIsInTime) {
  const std::uint16_t hit = hit_joint(hyq()).number;
  const auto checks = Trace().joint_is(hit, JointState::kNull, 405, 510).judged("sensors_cut", kStale);
  EXPECT_EQ(wrong(checks), Keys{});
  EXPECT_NEAR(checks[0].measured_s, 0.005, 1e-12);
}

TEST(FaultJudge, RefusesWhatIsLateLeavesOrStays) {
  const std::uint16_t hit = hit_joint(hyq()).number;
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 412, 510).judged("sensors_cut", kStale)), Keys{"reaction"});
  EXPECT_EQ(wrong(Trace().judged("sensors_cut", kStale)), Keys{"reaction"});
  EXPECT_EQ(wrong(Trace()
                      .joint_is(hit, JointState::kNull, 405, 510)
                      .joint_is(hit, JointState::kDamping, 450, 451)
                      .judged("sensors_cut", kStale)),
            Keys{"left"});
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 405, 540).judged("sensors_cut", kStale)), Keys{"recovery"});
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 405, 1000).judged("sensors_cut", kStale)), Keys{"recovery"});
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 405, 510).judged("sensors_cut")), Keys{"event"});
}

TEST(FaultJudge, RefusesOthersThatLeaveTrackingAndTrips) {
  const std::uint16_t hit = hit_joint(hyq()).number;
  const auto other = static_cast<std::uint16_t>(hit + 1);
  FaultSet tripped;
  tripped.set(Fault::kTripped);
  EXPECT_EQ(wrong(Trace()
                      .joint_is(hit, JointState::kNull, 405, 510)
                      .joint_is(other, JointState::kDamping, 700, 701)
                      .judged("sensors_cut", kStale)),
            Keys{"others"});
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 405, 510, tripped).judged("sensors_cut", kStale)),
            Keys{"tripped"});
  EXPECT_EQ(wrong(Trace().joint_is(other, JointState::kDamping, 700, 701).judged("clock_forward")), Keys{"others"});
}

TEST(FaultJudge, ExcusesOtherJointsAfterThePauseOfTheComputer) {
  const auto other = static_cast<std::uint16_t>(hit_joint(hyq()).number + 1);
  const auto untracked = [&](Tick begin, Tick end) { return Trace().joint_is(other, JointState::kNull, begin, end); };
  EXPECT_EQ(wrong(untracked(705, 724).computer_stood_still(700, 704).judged("clock_forward")), Keys{});
  EXPECT_EQ(wrong(untracked(705, 725).computer_stood_still(700, 704).judged("clock_forward")), Keys{"others"});
  EXPECT_EQ(wrong(untracked(699, 700).computer_stood_still(700, 704).judged("clock_forward")), Keys{"others"});
  const Tick unknown = std::numeric_limits<Tick>::max();
  EXPECT_EQ(wrong(untracked(955, 975).computer_stood_still(950, unknown).judged("clock_forward")), Keys{});
}

TEST(FaultJudge, ExcusesOnlyOthersAndNotMostOfARun) {
  const std::uint16_t hit = hit_joint(hyq()).number;
  EXPECT_EQ(wrong(Trace()
                      .joint_is(hit, JointState::kNull, 412, 510)
                      .computer_stood_still(405, 412)
                      .judged("sensors_cut", kStale)),
            Keys{"reaction"});
  EXPECT_EQ(wrong(Trace().computer_stood_still(400, 800).judged("clock_forward")), Keys{"excused"});
}

TEST(FaultJudge, WantsTheEventInTimeAndNotOneOfBefore) {
  const std::string event = "leads with authority 2";
  const auto judged_with = [&](Tick tick) {
    return wrong(
        judge(hyq(), *find_row("supervisor_replaced"), {{400, 500}, 600, {}}, Trace().rows(), told_at(tick, {event})));
  };
  EXPECT_EQ(judged_with(445), Keys{});
  EXPECT_EQ(judged_with(455), Keys{"event"});
  EXPECT_EQ(judged_with(300), Keys{"event"});
}

TEST(FaultJudge, RejectsAFaultThatNoEventReports) {
  const Row& row = *find_row("loss_1");
  const auto judged_with = [&](const std::vector<std::string>& texts) {
    return wrong(judge(hyq(), row, {{400, 500}, 500, {}}, Trace().rows(), told_at(410, texts)));
  };
  const std::string sensors = "fault on purpose: joint/sensors:loss=0.01@400..500";
  EXPECT_EQ(judged_with({}), Keys{"acts"});
  EXPECT_EQ(judged_with({sensors}), Keys{"acts"}) << "it has a second";
  EXPECT_EQ(judged_with({sensors, "fault on purpose: joint/command:loss=0.01@400..500"}), Keys{});
}

TEST(FaultJudge, WantsALatchedJointToStayUntilItIsArmed) {
  const std::uint16_t hit = hit_joint(hyq()).number;
  FaultSet tripped;
  tripped.set(Fault::kTripped);
  const std::vector<std::string> events{"damping -> null: tripped"};
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 452, 610, tripped).judged("command_cut_long", events)),
            Keys{});
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 452, 510, tripped).judged("command_cut_long", events)),
            Keys{"left"});
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 452, 700, tripped).judged("command_cut_long", events)),
            Keys{"recovery"});
}

TEST(FaultJudge, LetsAJointStutterThatMay) {
  const std::uint16_t hit = hit_joint(hyq()).number;
  EXPECT_EQ(wrong(Trace()
                      .joint_is(hit, JointState::kNull, 420, 430)
                      .joint_is(hit, JointState::kDamping, 450, 460)
                      .judged("loss_20")),
            Keys{});
  EXPECT_EQ(wrong(Trace().joint_is(hit, JointState::kNull, 420, 600).judged("loss_20")), Keys{"recovery"});
}

TEST(FaultPage, HasTheWorstOfEveryRowAndTheCellsThatDidNotHold) {
  Cell good{
      .row = "sensors_cut", .phase = "stance", .vendor = "fast", .seed = 1, .repeats = 0, .error = {}, .checks = {}};
  good.checks.push_back({"reaction", "null after", 0.007, 0.004});
  Cell bad = good;
  bad.seed = 2;
  bad.checks[0].measured_s = 0.009;
  Cell broken = good;
  broken.checks.clear();
  broken.error = "supervisor ended with exit status 1";
  const std::vector<Cell> cells{good, bad, broken};
  EXPECT_EQ(worst_checks(cells, "sensors_cut").at(0).measured_s, 0.009);
  const std::string page = fault_page_markdown(cells, {4, 2});
  EXPECT_NE(page.find("clock, in slow motion by 2; where a process starts, in slow motion by 6."), std::string::npos)
      << page;
  EXPECT_NE(fault_page_markdown(cells, {4, 1}).find("clock; where a process starts, in slow motion by 3."),
            std::string::npos);
  EXPECT_NE(page.find("1 of 4 cells held, 1 were not run"), std::string::npos);
  EXPECT_EQ(why_not(bad), "null after 9 ms of 7 ms");
  EXPECT_EQ(why_not(broken), "supervisor ended with exit status 1");
  EXPECT_NE(page.find("null after 9 ms of 7 ms **not held**"), std::string::npos) << page;
  EXPECT_NE(page.find("| `sensors_cut` | stance | fast | 2 |"), std::string::npos);
  EXPECT_NE(page.find("supervisor ended with exit status 1"), std::string::npos);
  EXPECT_FALSE(broken.holds());
}

TEST(CellsFile, GivesBackCellsOfItsOriginAlsoBehindALineThatWasCutOff) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("cells.jsonl");
  const CellsOrigin origin{"abc", "0123", 3};
  const Cell cell{"sensors_cut", "stance", "fast", 1, 2, "", {{"reaction", "null after", 0.007, 0.005}}};
  EXPECT_TRUE(read_cells(path, origin).empty());
  ASSERT_TRUE(append_cell(path, origin, cell).ok());
  ASSERT_TRUE(append_cell(path, {"def", "0123", 3}, cell).ok());
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 9);
  ASSERT_TRUE(append_cell(path, origin, cell).ok());
  const std::vector<Cell> cells = read_cells(path, origin);
  ASSERT_EQ(cells.size(), 2u) << "the second was cut off, as by the death of the program";
  EXPECT_EQ(cells[1].row, "sensors_cut");
  EXPECT_EQ(cells[1].repeats, 2);
  EXPECT_TRUE(cells[1].holds());
  EXPECT_FALSE(append_cell(scratch.file("nowhere/cells.jsonl"), origin, cell).ok());
}

}  // namespace faults_test
}  // namespace farrier::faults
