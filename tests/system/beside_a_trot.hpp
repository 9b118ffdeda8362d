#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <thread>

#include "farrier_command.hpp"

namespace farrier::test {

/// Tests beside one trot of both vendors, which runs while the suite does.
class BesideATrot : public testing::Test {
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

  /// "--domain" as the trot has it, and "--dds" with this vendor.
  static std::vector<std::string> beside(const std::string& vendor) {
    return {"--domain", std::to_string(trot_->domain()), "--dds", vendor};
  }

  /// Calls `test` with each vendor of the tested command, both at the same time: the trot takes processors meanwhile.
  template <class Test>
  static void for_both_vendors(Test&& test) {
    const auto with = [&](const char* vendor) {
      SCOPED_TRACE(vendor);
      test(vendor);
    };
    std::thread other(with, "fast");
    with("cyclone");
    other.join();
  }

  /// In lock-step the trot takes all of the processors that others leave: the nice value of a third of their share.
  static constexpr int kBehindOthers = 5;

  static inline std::unique_ptr<ScratchDirectory> scratch_;
  static inline std::unique_ptr<FarrierCommand> trot_;
};

/// Tests with one vendor of the tested command at a time, which is the parameter.
class BesideATrotByVendor : public BesideATrot, public testing::WithParamInterface<const char*> {
 protected:
  static std::vector<std::string> beside() { return BesideATrot::beside(GetParam()); }
};

}  // namespace farrier::test
