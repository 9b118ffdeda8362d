#pragma once

// Which of several supervisors leads:
//
//   modes of another, what all processes have heard of, time ──▶ Succession ──▶ take over, write again, stand down

#include <cstdint>

#include "core/time.hpp"

namespace farrier::supervisor {

/// What a supervisor must do now about who leads.
enum class Duty {
  kNone,
  kTakeOver,   ///< it leads from now on: write every order under authority()
  kRewrite,    ///< write every order again: some reader may have filtered it for a stronger writer
  kStandDown,  ///< another has taken over meanwhile: write nothing more
};

/// One supervisor's place in the succession. Leadership passes to whoever stands by when the modes that the leader
/// repeats have failed to come for kSilence; each leader has an authority one above all that any process has heard of,
/// so one that was replaced while it stood still is known by its own. No clock, no I/O.
class Succession {
 public:
  /// The lease of topics that carry authority: readers turn to a weaker writer after it, not at once.
  static constexpr Nanoseconds kSilence = std::chrono::milliseconds(20);
  /// For how long and how often orders are written again: readers notice the silence at other moments than this one.
  static constexpr Nanoseconds kRewriteFor = std::chrono::milliseconds(60);
  static constexpr Nanoseconds kRewritePeriod = std::chrono::milliseconds(10);

  /// `stands_by`: does not lead a robot that has no leader yet, but waits for one.
  explicit Succession(bool stands_by) noexcept : stands_by_(stands_by) {}

  /// A mode of this authority has come.
  void heard(std::uint32_t authority, SteadyTime now) noexcept;

  /// `newest`: the highest authority that any process of the run has heard of, 0 for none.
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
