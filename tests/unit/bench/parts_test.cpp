// A measurement of several parts, of which some fail.

#include "bench/command/parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>

#include "tests/support/scratch_directory.hpp"

namespace farrier::cli {
namespace parts_test {

constexpr const char* kOrigin = "0.1.0 (git abc), 4000 ticks";

class Parts : public testing::Test {
 protected:
  /// Parts that count how often they are measured.
  std::vector<Part> parts() {
    return {{"plant", [this](report::Figures& figures) { return plant(figures); }},
            {"rls", [this](report::Figures& figures) { return rls(figures); }},
            {"control", [this](report::Figures& figures) {
               ++measured_["control"];
               figures.add("bench.control.allocations", 0.0, 0.0);
               figures.add("bench.control.step_ns", std::numeric_limits<double>::quiet_NaN());
               return Result<Done>(Done{});
             }}};
  }

  report::Outcome run(bool go_on = false, const std::string& origin = kOrigin) {
    PartsRun run(path_, origin);
    taken_over_ = go_on ? run.take_over() : std::vector<std::string>{};
    report::Outcome outcome;
    outcome.command = "bench";
    run.run(parts(), outcome, [this] { return stop_; });
    return outcome;
  }

  Result<Done> plant(report::Figures& figures) {
    ++measured_["plant"];
    figures.add("bench.plant.speedup", 30.1, 20.0);
    return Done{};
  }
  Result<Done> rls(report::Figures& figures) {
    ++measured_["rls"];
    figures.add("bench.rls.ns_per_update", 80.0);
    if (throws_) {
      throw std::runtime_error("no memory");
    }
    if (refuses_) {
      return Error{"sim_bridge (pid 7) ended with exit status 137, killed by Killed"};
    }
    return Done{};
  }

  const test::ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("figures.json.parts");
  std::map<std::string, int> measured_;
  std::vector<std::string> taken_over_;
  bool refuses_ = false, throws_ = false, stop_ = false;
};

TEST_F(Parts, GiveTheirFiguresInTheirOrder) {
  const report::Outcome outcome = run();
  EXPECT_TRUE(outcome.passes());
  ASSERT_EQ(outcome.figures.all().size(), 4u);
  EXPECT_EQ(outcome.figures.all()[0].name, "bench.plant.speedup");
  EXPECT_EQ(outcome.figures.all()[0].bound, 20.0);
  EXPECT_EQ(outcome.figures.all()[1].name, "bench.rls.ns_per_update");
  EXPECT_EQ(outcome.figures.all()[2].name, "bench.control.allocations");
}

TEST_F(Parts, ThatFailCostTheOthersNothing) {
  for (const bool throws : {false, true}) {
    throws_ = throws;
    refuses_ = !throws;
    const report::Outcome outcome = run();
    EXPECT_FALSE(outcome.passes());
    ASSERT_EQ(outcome.failures.size(), 1u);
    EXPECT_EQ(outcome.failures[0], throws ? "rls: no memory"
                                          : "rls: sim_bridge (pid 7) ended with exit status 137, killed by Killed");
    EXPECT_NE(outcome.figures.find("bench.plant.speedup"), nullptr);
    EXPECT_NE(outcome.figures.find("bench.rls.ns_per_update"), nullptr) << "it was measured before the part failed";
    EXPECT_NE(outcome.figures.find("bench.control.step_ns"), nullptr);
  }
}

TEST_F(Parts, AreKeptAndOnlyTheFailedIsMeasuredAgain) {
  refuses_ = true;
  static_cast<void>(run());
  refuses_ = false;
  const report::Outcome outcome = run(true);
  EXPECT_EQ(taken_over_, (std::vector<std::string>{"plant", "control"}));
  EXPECT_EQ(measured_, (std::map<std::string, int>{{"plant", 1}, {"rls", 2}, {"control", 1}}));
  EXPECT_TRUE(outcome.passes());
  ASSERT_EQ(outcome.figures.all().size(), 4u);
  EXPECT_EQ(outcome.figures.all()[0].name, "bench.plant.speedup");
  EXPECT_EQ(outcome.figures.all()[0].value, 30.1) << "the same number, to the last digit";
  EXPECT_EQ(outcome.figures.all()[0].bound, 20.0) << "and it is still judged";
  EXPECT_TRUE(std::isnan(outcome.figures.find("bench.control.step_ns")->value));
  static_cast<void>(run(true));
  EXPECT_EQ(taken_over_.size(), 3u) << "the part measured again is kept as well";
}

TEST_F(Parts, AreKeptAsTheyCome) {
  PartsRun run(path_, kOrigin);
  std::vector<std::string> before_the_third;
  std::vector<Part> all = parts();
  all.resize(2);
  all.push_back({"riccati", [&](report::Figures&) {
                   before_the_third = PartsRun(path_, kOrigin).take_over();
                   return Result<Done>(Done{});
                 }});
  report::Outcome outcome;
  run.run(all, outcome, [] { return false; });
  EXPECT_EQ(before_the_third, (std::vector<std::string>{"plant", "rls"}));
  EXPECT_FALSE(std::filesystem::exists(path_ + ".part"));
}

TEST_F(Parts, OfAProgramThatWasKilledAreKept) {
  const auto killed = [this] {
    std::vector<Part> all = parts();
    all[1].measure = [](report::Figures&) -> Result<Done> {
      ::raise(SIGKILL);
      return Done{};
    };
    report::Outcome outcome;
    PartsRun(path_, kOrigin).run(all, outcome, [] { return false; });
  };
  EXPECT_EXIT(killed(), testing::KilledBySignal(SIGKILL), "");
  const report::Outcome outcome = run(true);
  EXPECT_EQ(taken_over_, (std::vector<std::string>{"plant"}));
  EXPECT_EQ(measured_, (std::map<std::string, int>{{"rls", 1}, {"control", 1}}));
  EXPECT_TRUE(outcome.passes());
}

TEST_F(Parts, OfAnotherOriginAreMeasuredAgain) {
  static_cast<void>(run());
  static_cast<void>(run(true, "0.1.0 (git def), 4000 ticks"));
  EXPECT_TRUE(taken_over_.empty());
  EXPECT_EQ(measured_["plant"], 2);
}

TEST_F(Parts, AfterAStopAreNotBegun) {
  static_cast<void>(run());
  std::filesystem::remove(path_);
  stop_ = true;
  const report::Outcome outcome = run(true);
  EXPECT_TRUE(outcome.figures.all().empty());
  ASSERT_EQ(outcome.failures.size(), 3u);
  EXPECT_EQ(outcome.failures[0], "plant: not measured, interrupted");
  EXPECT_EQ(measured_["plant"], 1);
}

TEST_F(Parts, OfAFileThatIsNotOneOfThisFormAreNotTakenOver) {
  for (const char* text : {"", "{", "[]", "{\"origin\": 7, \"parts\": {}}",
                           R"({"origin": "0.1.0 (git abc), 4000 ticks", "parts": [{"name": "plant"}]})",
                           R"({"origin": "0.1.0 (git abc), 4000 ticks", "parts": [{"name": "plant", "figures":
                              [{"name": "bench.of.nobody", "value": 1.0}]}]})",
                           R"({"origin": "0.1.0 (git abc), 4000 ticks", "parts": [{"name": "plant", "figures":
                              [{"name": "bench.plant.error", "value": 1.0, "bound": 2.0}]}]})"}) {
    std::ofstream(path_) << text;
    EXPECT_TRUE(PartsRun(path_, kOrigin).take_over().empty()) << text;
  }
}

TEST_F(Parts, ThatCannotBeKeptAreStillPrintedAndSayWhy) {
  std::filesystem::create_directory(path_);
  const report::Outcome outcome = run();
  EXPECT_EQ(outcome.figures.all().size(), 4u);
  ASSERT_EQ(outcome.failures.size(), 1u);
  EXPECT_NE(outcome.failures[0].find("parts are not kept: cannot write " + path_), std::string::npos)
      << outcome.failures[0];
}

}  // namespace parts_test
}  // namespace farrier::cli
