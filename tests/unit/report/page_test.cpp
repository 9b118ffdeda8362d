#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "run.hpp"
#include "report/trot/html_report.hpp"
#include "report/page/html_tables.hpp"
#include "report/trot/joint_poles.hpp"

namespace farrier::report {
namespace page_test {

using testing::hyq;
using testing::kSeed;

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class Page : public testing::OwnFolder {
 protected:
  // Measures and writes the report of a run of this many strides.
  Result<std::string> write(int strides) {
    const Tick ticks = schedule_.lead_in_ticks() + strides * schedule_.stride_ticks();
    const auto rows = testing::rows_of(robot_, schedule_, ticks, testing::lagging_forces(robot_, schedule_));
    Outcome outcome{.command = "trot", .figures = {}, .run = run_info(robot_, kSeed), .failures = {}};
    add_tracking(outcome.figures, robot_, track(robot_, schedule_, rows, 0), Judgement::kLockstep);
    FARRIER_ENSURE(add_spectral_radii(outcome.figures, robot_, 0).ok(), "HyQ has controllers");
    return write_report(path_, {outcome, robot_, schedule_, rows, 0});
  }

  robot::Robot robot_ = hyq();
  gait::Schedule schedule_{robot_.plan, kSeed};
};

/// Takes the PATH away for one test.
class PageWithoutGnuplot : public Page {
 protected:
  void SetUp() override {
    Page::SetUp();
    const char* path = std::getenv("PATH");
    old_path_ = path == nullptr ? "" : path;
    ::setenv("PATH", "/nonexistent", 1);
  }
  void TearDown() override {
    ::setenv("PATH", old_path_.c_str(), 1);
    Page::TearDown();
  }

 private:
  std::string old_path_;
};

TEST(Html, EscapesWhatTextMayNotHold) {
  EXPECT_EQ(escape_html("<a href=\"x\">R&D's</a>"), "&lt;a href=&quot;x&quot;&gt;R&amp;D&#39;s&lt;/a&gt;");
}

TEST(Html, HasNoImageWithoutAPath) {
  EXPECT_EQ(image_html("pictures/a.svg", "\"A\""), "<img src=\"pictures/a.svg\" alt=\"&quot;A&quot;\">\n");
  EXPECT_EQ(captioned_image_html("a.svg", "A&B"),
            "<figure><img src=\"a.svg\" alt=\"A&amp;B\"><figcaption>A&amp;B</figcaption></figure>\n");
  EXPECT_EQ(image_html("", "A"), "");
  EXPECT_EQ(captioned_image_html("", "A"), "");
}

TEST_F(Page, ShowsEveryPictureItNames) {
  const auto start = std::chrono::steady_clock::now();
  const auto page = write(7);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  RecordProperty("run_and_report_s", std::to_string(taken.count()));
  ASSERT_TRUE(page.ok()) << page.error().message;
  const std::string html = text_of(page.value());
  int pictures = 0;
  for (std::size_t at = 0; (at = html.find("<img src=\"", at)) != std::string::npos; ++pictures) {
    at += std::string("<img src=\"").size();
    const std::string name = html.substr(at, html.find('"', at) - at);
    EXPECT_NE(text_of(path_ + "/" + name).find("</svg>"), std::string::npos) << name;
  }
  EXPECT_EQ(pictures, 3 * static_cast<int>(robot_.joints.size()));
}

TEST_F(Page, RefersToNothingElsewhere) {
  const auto page = write(7);
  ASSERT_TRUE(page.ok()) << page.error().message;
  const std::string html = text_of(page.value());
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST_F(Page, SaysWhenTheRunWasTooShort) {
  const auto page = write(1);
  ASSERT_TRUE(page.ok()) << page.error().message;
  const std::string html = text_of(page.value());
  EXPECT_NE(html.find("ended before its judged part began"), std::string::npos);
  EXPECT_NE(html.find("class=\"verdict fail\""), std::string::npos);
}

TEST_F(PageWithoutGnuplot, IsRefusedWithTheRemedy) {
  const auto page = write(1);
  ASSERT_FALSE(page.ok());
  EXPECT_NE(page.error().message.find("gnuplot is not on the PATH; install it"), std::string::npos)
      << page.error().message;
}

TEST_F(PageWithoutGnuplot, IsRefusedInTheWordsOfAGnuplotThatFails) {
  std::ofstream(path_ + "/gnuplot") << "#!/bin/sh\necho no such terminal >&2\nexit 3\n";
  std::filesystem::permissions(path_ + "/gnuplot", std::filesystem::perms::owner_all);
  ::setenv("PATH", path_.c_str(), 1);
  const auto page = write(1);
  ASSERT_FALSE(page.ok());
  EXPECT_NE(page.error().message.find("status 3: no such terminal"), std::string::npos) << page.error().message;
}

}  // namespace page_test
}  // namespace farrier::report
