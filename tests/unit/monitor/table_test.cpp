#include "monitor/poles_text.hpp"
#include "tools/monitor/terminal_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/fault.hpp"
#include "feed.hpp"

namespace farrier::display {
namespace table_test {

using namespace monitor::testing;

std::vector<std::string> order(const monitor::Frame& frame, const TableView& view) {
  std::vector<std::string> names;
  for (const JointRow& row : joint_rows(frame, hyq(), view)) {
    names.push_back(row.joint->name);
  }
  return names;
}

class Table : public testing::Test {
 protected:
  Table() { walk_for_a_second(feed_); }

  std::string text(const TableView& view = {}) {
    const monitor::Frame frame = feed_.frame();
    return text_of(terminal_table(frame, hyq(), frame.events, view));
  }

  Feed feed_;
};

TEST_F(Table, ShowsTheRunItsJointsItsProcessesAndEvents) {
  const std::string shown = text();
  for (const robot::Joint& joint : hyq().joints) {
    EXPECT_NE(shown.find('\n' + joint.name), std::string::npos) << shown;
  }
  for (const char* part : {"hyq  armed  tick 1020 (1.02 s)  latency p50 450 us, p99 900 us  lost 3  missed periods 3",
                           "tracking  stance", "10 N", "10 Nm", "0.050", "5 kgm2", "6 kg", " 1000 ", "joint_node_lf",
                           "90 us", "error    supervisor lf_kfe: design refused"}) {
    EXPECT_NE(shown.find(part), std::string::npos) << part << "\n" << shown;
  }
}

TEST_F(Table, SaysThatNothingWasHeardOrIsHeardNoMore) {
  Feed silent;
  const monitor::Frame before = silent.frame();
  EXPECT_NE(text_of(terminal_table(before, hyq(), {}, {})).find("nothing heard yet"), std::string::npos);
  feed_.pass(7.0);
  EXPECT_NE(text().find("SILENT for 7 s"), std::string::npos);
}

TEST_F(Table, SortsByAnyColumnAndLeavesTheUnknownLast) {
  feed_.walk(1020, 1, [](signals::JointSummary& s) {
    s.force_error_rms_N_or_Nm = s.joint == 4 ? 500.0 : 10.0 - s.joint;
    s.tick = s.joint == 7 ? kNoTick : s.tick;
  });
  TableView view;
  view.sorted_by = Column::kMass;
  view.reversed = true;
  EXPECT_EQ(order(feed_.frame(), view).front(), hyq().joints.back().name);
  view.sorted_by = Column::kError;
  EXPECT_EQ(order(feed_.frame(), view).front(), hyq().joints[4].name);
  view.reversed = false;
  EXPECT_EQ(order(feed_.frame(), view).back(), hyq().joints[4].name);
  Feed first;
  first.take(summary(7, 20));
  for (const bool reversed : {false, true}) {
    view = {};
    view.sorted_by = Column::kGeneration;
    view.reversed = reversed;
    EXPECT_EQ(order(first.frame(), view).front(), hyq().joints[7].name);
  }
}

TEST_F(Table, LeavesTheJointsThatHaveEveryWordOfTheFilter) {
  feed_.walk(1020, 1, [](signals::JointSummary& s) {
    s.faults = s.joint == 4 ? static_cast<std::uint32_t>(Fault::kGainsRefused) : 0;
  });
  const monitor::Frame frame = feed_.frame();
  TableView view;
  EXPECT_EQ(order(frame, view).size(), 12u);
  view.filter = "lf";
  EXPECT_EQ(order(frame, view), (std::vector<std::string>{"lf_haa", "lf_hfe", "lf_kfe"}));
  view.filter = "  KFE stance ";
  EXPECT_EQ(order(frame, view).size(), 4u);
  view.filter = "refused";
  EXPECT_EQ(order(frame, view), std::vector<std::string>{hyq().joints[4].name});
  view.filter = "lf refused";
  EXPECT_TRUE(order(frame, view).empty());
  view.filter = "";
  view.only_faulty = true;
  EXPECT_EQ(order(frame, view), std::vector<std::string>{hyq().joints[4].name});
}

TEST(JointRows, HaveTheToneOfTheFaultsSeverity) {
  for (const FaultInfo& info : kFaults) {
    Feed feed;
    feed.walk(0, 1, [&](signals::JointSummary& s) { s.faults = static_cast<std::uint32_t>(info.fault); });
    for (const JointRow& row : joint_rows(feed.frame(), hyq(), {})) {
      EXPECT_EQ(row.tone, info.severity >= FaultSeverity::kError ? Tone::kBad : Tone::kWarning) << info.name;
    }
  }
}

TEST_F(Table, FitsAnyTerminal) {
  const monitor::Frame frame = feed_.frame();
  for (const bool help : {false, true}) {
    for (int height = 1; height < 60; ++height) {
      for (const int width : {1, 20, 80, 200}) {
        TableView view;
        view.width = width;
        view.height = height;
        view.help = help;
        view.first_row = 50;
        const auto table = terminal_table(frame, hyq(), frame.events, view);
        EXPECT_LE(table.lines.size(), static_cast<std::size_t>(std::max(height, 2)));
        for (const Line& line : table.lines) {
          EXPECT_LE(line.text.size(), static_cast<std::size_t>(width));
        }
      }
    }
  }
}

TEST_F(Table, GivesUpOtherColumnsBeforeFaults) {
  feed_.walk(1020, 1, [](signals::JointSummary& s) { s.faults = static_cast<std::uint32_t>(Fault::kCommandStale); });
  const monitor::Frame frame = feed_.frame();
  TableView view;
  for (const int width : {40, 80, 110}) {
    view.width = width;
    const std::string shown = text_of(terminal_table(frame, hyq(), frame.events, view));
    EXPECT_NE(shown.find("command stale\n"), std::string::npos) << width << '\n' << shown;
    EXPECT_EQ(shown.find("poles") != std::string::npos, width > 80) << width << '\n' << shown;
  }
}

TEST_F(Table, ScrollsThroughJointsThatDoNotFitAndSaysHowMany) {
  const monitor::Frame frame = feed_.frame();
  TableView view;
  view.height = 14;
  const auto top = terminal_table(frame, hyq(), frame.events, view);
  EXPECT_EQ(top.rows, 12);
  EXPECT_EQ(top.shown, 6);
  EXPECT_TRUE(top.lines[3].text.starts_with("lf_haa")) << text_of(top);
  EXPECT_NE(top.lines.back().text.find("6 of 12"), std::string::npos);
  view.first_row = 2;
  EXPECT_TRUE(terminal_table(frame, hyq(), frame.events, view).lines[3].text.starts_with("lf_kfe"));
}

TEST_F(Table, ShowsTheNewestEventsAndNothingThatIsNoCharacter) {
  std::vector<monitor::EventFrame> events(40);
  for (std::size_t i = 0; i < events.size(); ++i) {
    events[i].text = "event " + std::to_string(i) + " \033[2J\n";
  }
  TableView view;
  view.height = 24;
  const std::string shown = text_of(terminal_table(feed_.frame(), hyq(), events, view));
  EXPECT_NE(shown.find("event 39 ?[2J?"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("event 1 "), std::string::npos);
  EXPECT_EQ(shown.find('\033'), std::string::npos);
}

TEST(TableView, DoesWhatItsHelpSays) {
  TableView view;
  view.press('s');
  EXPECT_EQ(view.sorted_by, Column::kState);
  view.press('S');
  view.press('S');
  EXPECT_EQ(view.sorted_by, Column::kFaults);
  view.press('r');
  EXPECT_TRUE(view.reversed);
  for (const char key : std::string("/lfq")) {
    view.press(key);
  }
  EXPECT_TRUE(view.typing);
  EXPECT_FALSE(view.ended);
  view.press(kKeyBackspace);
  view.press(kKeyUp);
  view.press(kKeyEnter);
  EXPECT_EQ(view.filter, "lf");
  EXPECT_FALSE(view.typing);
  view.press(kKeyEscape);
  EXPECT_EQ(view.filter, "");
  view.press(kKeyPageDown);
  view.press(kKeyUp);
  EXPECT_EQ(view.first_row, 9);
  view.press(kKeyHome);
  view.press(kKeyUp);
  EXPECT_EQ(view.first_row, 0);
  view.press('p');
  view.press('?');
  view.press('f');
  EXPECT_TRUE(view.paused && view.help && view.only_faulty);
  view.press('c');
  EXPECT_EQ(view.sorted_by, Column::kJoint);
  EXPECT_FALSE(view.reversed || view.only_faulty);
  view.press('q');
  EXPECT_TRUE(view.ended);
}

TEST(PolesText, ShowsAConjugatePairOnce) {
  EXPECT_EQ(monitor::poles_text({{{0.999, 0.0}, {0.5, 0.25}, {0.5, -0.25}}}), "0.999 0.500+-0.250i");
  EXPECT_EQ(monitor::poles_text({{{0.5, 0.25}, {0.5, -0.25}, {0.1, 0.0}}}), "0.500+-0.250i 0.100");
  EXPECT_EQ(monitor::poles_text({{{NAN, 0.0}, {0.5, 0.0}, {0.1, 0.0}}}), "-");
}

}  // namespace table_test
}  // namespace farrier::display
