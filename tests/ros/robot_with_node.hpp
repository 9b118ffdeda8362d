#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include "tests/system/farrier_command.hpp"

namespace farrier::test {

/// farrier trot, and farrier ros beside it, in a folder of their own.
class RobotWithNode {
 public:
  RobotWithNode() = default;
  RobotWithNode(const RobotWithNode&) = delete;
  RobotWithNode& operator=(const RobotWithNode&) = delete;
  /// Interrupts both, the node first.
  ~RobotWithNode() {
    if (ros_ != nullptr) {
      ros_->signal(SIGINT);
      EXPECT_EQ(ros_->wait(), 130);
    }
    if (trot_ != nullptr) {
      trot_->signal(SIGINT);
      trot_->wait();
    }
  }

  /// Starts trot and, after its first tick, the node, each with further arguments, and waits until the node `says` this.
  void start(std::vector<std::string> of_trot, std::vector<std::string> of_node, const std::string& says) {
    of_trot.insert(of_trot.begin(), {"trot", "--duration", "600", "--out", scratch_.file("out")});
    trot_ = std::make_unique<FarrierCommand>(of_trot);
    ASSERT_TRUE(trot_->says("trot: tick 0 of")) << trot_->output();
    of_node.insert(of_node.begin(), {"ros", "--domain", std::to_string(trot_->domain()), "--ros-address", "127.0.0.1"});
    ros_ = std::make_unique<FarrierCommand>(of_node);
    ASSERT_TRUE(ros_->says(says)) << ros_->output();
  }

  const ScratchDirectory& scratch() const noexcept { return scratch_; }
  FarrierCommand& ros() noexcept { return *ros_; }

 private:
  ScratchDirectory scratch_;
  std::unique_ptr<FarrierCommand> trot_, ros_;
};

}  // namespace farrier::test
