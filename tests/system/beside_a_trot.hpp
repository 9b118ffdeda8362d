#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <memory>

#include "farrier_command.hpp"

namespace farrier::test {

/// Tests beside one trot of both vendors, which runs while the suite does. The parameter is the vendor of the tested
/// command.
class BesideATrot : public testing::TestWithParam<const char*> {
 protected:
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<ScratchDirectory>();
    trot_ = std::make_unique<FarrierCommand>(std::vector<std::string>{
        "trot", "--world", "bench", "--dds", "mixed", "--duration", "600", "--out", scratch_->file("out")});
    ASSERT_TRUE(trot_->says("trot: tick 0 of")) << trot_->output();
    trot_->renice(kBehindOthers);
  }
  static void TearDownTestSuite() {
    trot_->renice(0);
    trot_->signal(SIGINT);
    EXPECT_EQ(trot_->wait(std::chrono::seconds(20)), 130);
    trot_.reset();
    scratch_.reset();
  }

  /// "--domain" and "--dds" as the trot and the parameter say.
  static std::vector<std::string> beside() {
    return {"--domain", std::to_string(trot_->domain()), "--dds", GetParam()};
  }

  /// In lock-step the trot takes all of the processors that others leave: the nice value of a third of their share.
  static constexpr int kBehindOthers = 5;

  static inline std::unique_ptr<ScratchDirectory> scratch_;
  static inline std::unique_ptr<FarrierCommand> trot_;
};

}  // namespace farrier::test
