#pragma once

// Decides which of several supervisors leads:
//
//   modes of another, what all processes have heard of, time ──▶ Succession ──▶ take over, write again, stand down

#include <cstdint>

#include "core/time.hpp"

namespace farrier::supervisor {

/// Action a supervisor must take now.
enum class Duty {
  kNone,
  kTakeOver,   ///< it leads from now on: write every order under authority()
  kRewrite,    ///< write every order again: some reader may have filtered it for a stronger writer
  kStandDown,  ///< another has taken over meanwhile: write nothing more
};

/// One supervisor's place in the succession. Leadership passes to a supervisor that stands by when the modes that the
/// leader repeats have failed to come for kSilence. Each leader has an authority one above the highest that any process
/// knows. A replaced leader that was paused is recognised by its lower authority. No clock, no I/O.
class Succession {
 public:
  /// The lease of topics that carry authority: readers turn to a weaker writer after it, not at once.
  static constexpr Nanoseconds kSilence = std::chrono::milliseconds(20);
  /// Duration and period of writing orders again: readers notice the silence at other moments than this supervisor.
  static constexpr Nanoseconds kRewriteFor = std::chrono::milliseconds(60);
  static constexpr Nanoseconds kRewritePeriod = std::chrono::milliseconds(10);

  /// With `stands_by` it does not lead a robot that has no leader yet, but waits for one.
  explicit Succession(bool stands_by) noexcept : stands_by_(stands_by) {}

  /// A mode of this authority has come.
  void heard(std::uint32_t authority, SteadyTime now) noexcept;

  /// Argument `newest`: the highest authority that any process of the run knows, 0 for none.
  Duty step(std::uint32_t newest, SteadyTime now) noexcept;

  bool leads() const noexcept { return leads_; }
  /// Its own when it leads, else the newest it knows; 0: none.
  std::uint32_t authority() const noexcept { return authority_; }

 private:
  bool stands_by_;
  bool leads_ = false;
  std::uint32_t authority_ = 0;
  SteadyTime heard_{};  ///< of the leader, while following one
  SteadyTime rewrite_until_{};
  SteadyTime next_rewrite_{};
};

}  // namespace farrier::supervisor
