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

/// An act on a run at the time when its clock begins tick `at` or would have begun it. It is a signal to a member's
/// process, another act of run::ProcessAct, or a request of an operator.
struct Act {
  Tick at = 0;
  std::string member;  ///< empty: an operator's request
  int signal = 0;      ///< run::ProcessAct::signal
  signals::Request request = signals::Request::kArm;
};

/// Does the acts of one run when they are due.
class RunActs {
 public:
  /// `acts` in the order of their ticks. Opens a publisher of requests to the supervisor if one of them is a request.
  /// `clock`: the one that acts set; nothing if none does.
  static Result<RunActs> create(std::vector<Act> acts, participant::Participant& participant,
                                std::optional<HostClock> clock);

  /// Starts the process of a member; `name`: of this start, for its log and the list of children.
  using Start = std::function<Result<ChildProcess>(const std::string& member, const std::string& name)>;

  /// Does the acts that are due at `due`; `tick` is the newest that the clock has begun. Refuses if a process does not
  /// start.
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
