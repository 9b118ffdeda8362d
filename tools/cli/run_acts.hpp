#pragma once

#include <optional>
#include <string>
#include <vector>

#include "participant/participant.hpp"
#include "tools/cli/child_process.hpp"

namespace farrier::cli {

/// What is done to a run while it goes, once its clock has begun tick `at`: a signal to a member's process, or what an
/// operator asks for.
struct Act {
  Tick at = 0;
  std::string member;  ///< empty: an operator's request
  int signal = 0;
  signals::Request request = signals::Request::kArm;
};

/// Does the acts of one run when they are due.
class RunActs {
 public:
  /// `acts` in the order of their ticks. An operator's ear at the supervisor is opened when one of them is a request.
  static Result<RunActs> create(std::vector<Act> acts, participant::Participant& participant);

  /// Does what is due at `tick`, the newest the clock has begun.
  void perform(Tick tick, std::vector<ChildProcess>& children);

  /// Ticks at which they were done, in their order.
  const std::vector<Tick>& performed() const noexcept { return performed_; }

 private:
  RunActs(std::vector<Act> acts, std::uint64_t session) : acts_(std::move(acts)), session_(session) {}

  std::vector<Act> acts_;
  std::uint64_t session_;
  std::optional<bus::Publisher<signals::SystemRequest>> requests_;
  std::uint32_t asked_ = 0;
  std::vector<Tick> performed_;
};

}  // namespace farrier::cli
