#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/fault.hpp"
#include "report/figures/recording_facts.hpp"
#include "tests/support/made_up_robot.hpp"
#include "tests/unit/web/client.hpp"
#include "tools/web/recorded_frames.hpp"

namespace farrier::web {
namespace recording_test {

using nlohmann::json;
using test::ScratchDirectory;

Result<RecordedFrames> read(const std::string& path) {
  return RecordedFrames::read(path);
}

class Recorded : public ::testing::Test {
 protected:
  static constexpr int kSeconds = 12;

  void SetUp() override {
    test::write_made_up_recording(path_, testing::hyq(), kSeconds);
    auto frames = read(path_);
    ASSERT_TRUE(frames.ok()) << frames.error().message;
    frames_ = std::make_shared<const RecordedFrames>(std::move(frames).value());
  }

  ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("run.mcap");
  std::shared_ptr<const RecordedFrames> frames_;
};

TEST_F(Recorded, HasTwentyFramesASecond) {
  EXPECT_EQ(frames_->count(), 20u * kSeconds + 1u);
  const json overview = json::parse(frames_->overview());
  EXPECT_NEAR(overview.at("duration_s").get<double>(), kSeconds, 0.1);
  EXPECT_EQ(overview.at("ending"), "");
}

TEST_F(Recorded, GivesTheSameFramesInAnyPieces) {
  const json all = json::parse(frames_->frames(0, frames_->count()));
  ASSERT_EQ(all.size(), frames_->count());
  json pieces = json::array();
  for (std::size_t from = 0; from < frames_->count(); from += 37) {
    for (json& frame : json::parse(frames_->frames(from, from + 37))) {
      pieces.push_back(std::move(frame));
    }
  }
  EXPECT_EQ(pieces, all);
}

TEST_F(Recorded, GivesOneFrameInSeveral) {
  const json all = json::parse(frames_->frames(0, frames_->count()));
  for (const std::size_t every : {2u, 7u, 100u, 130u, 1000u}) {
    json thinned = json::array();
    for (std::size_t i = 30; i < 235; i += every) {
      thinned.push_back(all.at(i));
    }
    EXPECT_EQ(json::parse(frames_->frames(30, 235, every)), thinned) << every;
  }
}

TEST_F(Recorded, OpensAtItsEnd) {
  const json overview = json::parse(frames_->overview());
  EXPECT_EQ(overview.at("opens_at_s"), overview.at("duration_s"));
}

TEST_F(Recorded, LosesNoSummary) {
  std::size_t summaries = 0;
  for (const json& frame : json::parse(frames_->frames(0, frames_->count()))) {
    summaries += frame.at("joints").at(3).at("s").size();
  }
  EXPECT_EQ(summaries, 50u * kSeconds);
}

TEST_F(Recorded, KnowsWhenWhichJointHadWhichFault) {
  const json faults = json::parse(frames_->overview()).at("faults");
  const std::uint16_t knee = testing::hyq().find("lf_kfe")->number;
  ASSERT_EQ(faults.at(knee).size(), 1u);
  EXPECT_NEAR(faults.at(knee).at(0).at(0).get<double>(), 6.0, 0.1);
  EXPECT_NEAR(faults.at(knee).at(0).at(1).get<double>(), 8.0, 0.1);
  EXPECT_EQ(faults.at(knee).at(0).at(2), static_cast<std::uint32_t>(Fault::kForceLost));
  EXPECT_TRUE(faults.at(0).empty());
}

TEST_F(Recorded, IsServedInPieces) {
  const auto server = WebServer::create({"127.0.0.1", 0, false}, RecordedFrames::site(frames_, testing::small_page()));
  ASSERT_TRUE(server.ok());
  httplib::Client client("127.0.0.1", server.value()->port());
  EXPECT_TRUE(json::parse(client.Get("/api/robot")->body).at("recorded").get<bool>());
  EXPECT_EQ(json::parse(client.Get("/api/recording")->body), json::parse(frames_->overview()));
  EXPECT_EQ(json::parse(client.Get("/api/frames?from=100&to=120")->body).size(), 20u);
  EXPECT_EQ(json::parse(client.Get("/api/frames?from=240&to=900")->body).size(), 1u);
  EXPECT_EQ(json::parse(client.Get("/api/frames?from=0&to=240&every=100")->body).size(), 3u);
  for (const char* nonsense : {"/api/frames?from=999", "/api/frames?from=20&to=10", "/api/frames?every=0",
                               "/api/frames?from=18446744073709551615"}) {
    EXPECT_EQ(client.Get(nonsense)->status, 400) << nonsense;
  }
}

TEST_F(Recorded, OfARecorderThatWasKilledSaysSo) {
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) * 3 / 4);
  const auto cut = read(path_);
  ASSERT_TRUE(cut.ok()) << cut.error().message;
  EXPECT_LT(cut.value().count(), frames_->count());
  EXPECT_NE(json::parse(cut.value().overview()).at("ending"), "");
}

TEST_F(Recorded, CanBeInterrupted) {
  EXPECT_FALSE(RecordedFrames::read(path_, [](double) { return false; }).ok());
}

TEST(RecordedFrames, OpenWhereEveryJointHasBeenHeard) {
  const ScratchDirectory scratch;
  const std::string path = scratch.file("two_runs.mcap");
  auto file = recording::RunFileWriter::create(path, report::recording_facts(testing::hyq()));
  ASSERT_TRUE(file.ok());
  test::MadeUpRobot made_up(testing::hyq(), [&](const recording::Sample& sample) { file.value().write(sample); });
  std::uint64_t time_ns = 1'700'000'000'000'000'000;
  made_up.begin(7, time_ns);
  for (int step = 0; step < 100; ++step) {
    made_up.step(time_ns += 20'000'000);
  }
  made_up.begin(8, time_ns += 3'000'000'000);  // a second run, of which the recording has no summary
  made_up.set_faults(0, 0, time_ns += 1'000'000'000);
  ASSERT_TRUE(file.value().finish({}).ok());
  const auto frames = read(path);
  ASSERT_TRUE(frames.ok()) << frames.error().message;
  const json overview = json::parse(frames.value().overview());
  EXPECT_NEAR(overview.at("duration_s").get<double>(), 6.0, 0.1);
  const double opens_at_s = overview.at("opens_at_s").get<double>();
  EXPECT_NEAR(opens_at_s, 2.0, 0.1);
  for (const json& frame : json::parse(frames.value().frames(0, frames.value().count()))) {
    if (frame.at("t").get<double>() == opens_at_s) {
      EXPECT_TRUE(std::ranges::none_of(frame.at("joints"), [](const json& joint) { return joint.at("state").is_null(); }));
    }
  }
}

TEST(RecordedFrames, RefusesWhatIsNoRecordingOfSummaries) {
  const ScratchDirectory scratch;
  EXPECT_FALSE(read(scratch.file("nothing.mcap")).ok());
  test::write_made_up_recording(scratch.file("empty.mcap"), testing::hyq(), 0);
  const auto empty = read(scratch.file("empty.mcap"));
  ASSERT_FALSE(empty.ok());
  EXPECT_NE(empty.error().message.find("lf/joint/summary"), std::string::npos);
}

TEST(PageFiles, RefusesAPageWithoutItsCharts) {
  const ScratchDirectory scratch;
  EXPECT_FALSE(read_page(scratch.file("nothing")).ok());
  std::filesystem::create_directory(scratch.file("page"));
  std::ofstream(scratch.file("page/index.html")) << "page";
  const auto bare = read_page(scratch.file("page"));
  ASSERT_FALSE(bare.ok());
  EXPECT_NE(bare.error().message.find("npm"), std::string::npos);
  std::ofstream(scratch.file("page/uPlot.esm.js")) << "charts";
  const auto whole = read_page(scratch.file("page"));
  ASSERT_TRUE(whole.ok());
  EXPECT_EQ(whole.value().at("/").bytes, "page");
}

}  // namespace recording_test
}  // namespace farrier::web
