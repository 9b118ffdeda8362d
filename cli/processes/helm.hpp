#pragma once

#include <functional>

#include "cli/processes/dds_run.hpp"
#include "participant/participant.hpp"

namespace farrier::cli {

/// The launcher's part in a run that an operator steers: it publishes commands and hears what the body does.
class Helm {
 public:
  /// `steers` as DdsRun has it. `participant` outlives it.
  static Result<Helm> create(participant::Participant& participant,
                             std::function<Steered(Tick, const signals::BodyState&)> steers);

  /// Call often, with the newest tick that the clock has begun. True when the run is to end.
  bool steer(Tick tick);

 private:
  Helm(std::uint64_t session, bus::Subscription<signals::BodyState> states,
       bus::Publisher<signals::BodyCommand> commands, bus::Publisher<signals::SystemRequest> requests,
       std::function<Steered(Tick, const signals::BodyState&)> steers)
      : session_(session),
        states_(std::move(states)),
        commands_(std::move(commands)),
        requests_(std::move(requests)),
        steers_(std::move(steers)) {}

  std::uint64_t session_;
  bus::Subscription<signals::BodyState> states_;
  bus::Publisher<signals::BodyCommand> commands_;
  bus::Publisher<signals::SystemRequest> requests_;
  std::function<Steered(Tick, const signals::BodyState&)> steers_;
  signals::BodyState newest_;
  std::uint32_t count_ = 0;
};

}  // namespace farrier::cli
