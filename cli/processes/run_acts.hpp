#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "participant/participant.hpp"
#include "cli/processes/child_process.hpp"
#include "cli/processes/host_clock.hpp"
#include "run/process_act.hpp"

namespace farrier::cli {

/// What is done to a run while it goes, once its clock has begun tick `at` or would have: a signal to a member's process
/// or another of run::ProcessAct, or what an operator asks for.
struct Act {
  Tick at = 0;
  std::string member;  ///< empty: an operator's request
  int signal = 0;      ///< run::ProcessAct::signal
  signals::Request request = signals::Request::kArm;
};

/// Does the acts of one run when they are due.
class RunActs {
 public:
  /// `acts` in the order of their ticks. An operator's ear at the supervisor is opened when one of them is a request.
  /// `clock`: the one that acts set; nothing where none does.
  static Result<RunActs> create(std::vector<Act> acts, participant::Participant& participant,
                                std::optional<HostClock> clock);

  /// Starts the process of a member; `name`: of this start, for its log and the list of children.
  using Start = std::function<Result<ChildProcess>(const std::string& member, const std::string& name)>;

  /// Does what is due at `due`; `tick` is the newest that the clock has begun. Refuses when a process does not start.
  Result<Done> perform(Tick due, Tick tick, std::vector<ChildProcess>& children, const Start& start);

  /// Newest ticks that the clock had begun when they were done, in their order.
  const std::vector<Tick>& performed() const noexcept { return performed_; }

 private:
  RunActs(std::vector<Act> acts, std::uint64_t session, std::optional<HostClock> clock)
      : acts_(std::move(acts)), session_(session), clock_(std::move(clock)) {}

  std::vector<Act> acts_;
  std::uint64_t session_;
  std::optional<HostClock> clock_;
  std::optional<bus::Publisher<signals::SystemRequest>> requests_;
  std::uint32_t asked_ = 0;
  std::vector<Tick> performed_;
};

}  // namespace farrier::cli
