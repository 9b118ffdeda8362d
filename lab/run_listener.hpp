#pragma once

#include <memory>

#include "participant/application.hpp"
#include "participant/participant.hpp"

namespace farrier::lab {

/// The launcher's part in a run: it hears the clock and, in lock-step, is one of those whom the clock waits for, so that
/// nothing of a tick escapes who listens beside it.
class RunListener : public participant::Application {
 public:
  /// `ticks` 0: until told to stop.
  static Result<std::unique_ptr<RunListener>> create(participant::Participant& participant, Tick ticks);

  /// Ticks that the clock has begun so far.
  virtual Tick tick() const = 0;
};

}  // namespace farrier::lab
