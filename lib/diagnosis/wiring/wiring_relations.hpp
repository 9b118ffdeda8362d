#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "diagnosis/wiring/box_regression.hpp"
#include "diagnosis/wiring/wiring_signals.hpp"

namespace farrier::diagnosis {

/// A channel as it was recorded: `factor` times its true value, `late` samples late (negative: early).
struct ChannelChange {
  double factor = 1.0;
  int late = 0;
  bool operator==(const ChannelChange&) const = default;
};

/// Changes of all channels; by default each is as it should be.
struct WiringHypothesis {
  std::array<ChannelChange, kWiredChannels> changes{};
  bool pressures_exchanged = false;

  ChannelChange& of(WiredChannel channel) noexcept { return changes[static_cast<std::size_t>(channel)]; }
  const ChannelChange& of(WiredChannel channel) const noexcept { return changes[static_cast<std::size_t>(channel)]; }
};

/// Laws that tie channels of a joint to each other, whatever physical effect it has. The motion of load and oil is that
/// of the position or that of the velocity.
enum class WiringLaw {
  kKinematics,      ///< v = x' - t v'
  kLoadByPosition,  ///< F = m a + d v + C x + dry friction - t F'
  kLoadByVelocity,
  /// Oil: u = (K_h v + d_p a + m_p a' + F') / (S K_v root), after a delay. Drive with a spring: N K u = T + D w + J w' with
  /// w = v + T'/k. Rigid drive: N K u = T + t T'.
  kActuatorByPosition,
  kActuatorByVelocity,
  kCell,   ///< F = g (A_a p_a - A_b p_b) - e A_b p_b - d_p v - m_p a - dry friction - t F'
  kLevels  ///< p_a + p_b = p_s
};
inline constexpr std::size_t kWiringLaws = 7;

/// Share of a law's left side that it leaves unexplained, mean squares. Its numbers are free in what effects of
/// docs/effects.md can make of them. Not a number for a law whose channels were not recorded.
using Unexplained = std::array<double, kWiringLaws>;

/// Numbers with which a law fits a recording best.
struct LawFit {
  BoxRegression::Result regression;
  int delay = 0;  ///< of the input, samples; of the laws of the actuator alone
};

/// A law by sample as recorded: the channel on its left side, and what its right side says that it should be.
struct LawLine {
  std::vector<std::size_t> at;
  std::vector<double> left, right;
};

/// Judges hypotheses by the laws.
class WiringJudge {
 public:
  static constexpr int kMostLate = 50;  ///< samples

  WiringJudge(const Recording& recording, const robot::Joint& joint);

  /// Laws of the channels that the hypothesis changes; the others are as without a fault.
  Unexplained judge(const WiringHypothesis& hypothesis) const;
  const Unexplained& without_fault() const noexcept { return none_; }

  /// Fit of a law under a hypothesis, and the law's two sides under one with the numbers of a fit. The law's channels were
  /// recorded. kLevels has neither.
  LawFit fit(WiringLaw law, const WiringHypothesis& hypothesis) const;
  LawLine line(WiringLaw law, const WiringHypothesis& hypothesis, const LawFit& fit) const;

  /// Sum of the logarithms of unexplained over the laws that show best by how many samples `channel` lags. Sensors have no
  /// lag of their own in it, so that a lag of samples is not taken for one of a filter. kPressureA: of both pressures.
  double misfit_of_lag(WiredChannel channel, const WiringHypothesis& hypothesis) const;

  /// Root mean square of a channel about its mean (of the position: of its derivative), and about as large as the other
  /// channels say that it should be; not a number where none does.
  double seen(WiredChannel channel) const noexcept;
  double expected(WiredChannel channel) const;

  /// Largest lag that is tried, samples.
  int most_late() const noexcept { return most_late_; }
  /// Samples of the longest physical delay of an input.
  int longest_delay() const noexcept { return longest_delay_; }

 private:
  struct Motion;

  double law(WiringLaw law, const WiringHypothesis& hypothesis) const;
  BoxRegression::Result kinematics(const WiringHypothesis& h, double longest_lag_s) const;
  BoxRegression::Result load(const WiringHypothesis& h, const Motion& motion, double longest_lag_s,
                             double motion_lag_s = 0.0) const;
  BoxRegression::Result cell(const WiringHypothesis& h, double longest_lag_s) const;
  /// The current by motion and force: oil or drive.
  LawFit actuator_law(const WiringHypothesis& h, const Motion& motion) const;
  LawFit oil(const WiringHypothesis& h, const Motion& motion) const;
  LawFit drive(const WiringHypothesis& h, const Motion& motion) const;
  /// Delays of the input that are tried, samples: the current of an earlier sample acts now.
  std::vector<int> input_delays(const ChannelChange& current) const;
  double levels(const WiringHypothesis& h) const;
  Motion by_position(const WiringHypothesis& h) const;
  Motion by_velocity(const WiringHypothesis& h, double lag_s, bool quick) const;
  double force_lag(const WiringHypothesis& h) const;

  // Points of the laws at every `stride`-th sample, add(i, y, r): y is the left side, r the regressors of the right one.
  // Those of the actuator have the left side without a delay.
  template <class Add>
  void kinematics_points(const WiringHypothesis& h, std::size_t stride, Add&& add) const;
  template <class Add>
  void load_points(const WiringHypothesis& h, const Motion& motion, double motion_lag_s, std::size_t stride,
                   Add&& add) const;
  template <class Add>
  void cell_points(const WiringHypothesis& h, std::size_t stride, Add&& add) const;
  template <class Add>
  void oil_points(const WiringHypothesis& h, const Motion& motion, std::size_t stride, Add&& add) const;
  template <class Add>
  void drive_points(const WiringHypothesis& h, const Motion& motion, std::size_t stride, Add&& add) const;
  /// Motion of the law, from the position or from the velocity.
  Motion motion_of(WiringLaw law, const WiringHypothesis& h) const;
  /// Lag of the velocity's sensor.
  double velocity_lag_s(const WiringHypothesis& h) const;
  const std::vector<double>& current_of(const WiringHypothesis& h) const noexcept;

  template <class Add>
  void each(std::size_t stride, Add&& add) const {
    for (std::size_t i = margin_; i + margin_ < signals_.size(); i += stride) {
      add(i);
    }
  }

  WiringSignals signals_;
  plant::ActuatorParams actuator_;
  plant::LoadParams load_;
  std::optional<plant::ElectricParams> electric_;
  struct {
    double inertia = 0.0, damping = 0.0, coulomb = 0.0;
  } rotor_;  ///< of a rigid drive, which moves with the load
  double period_s_;
  int most_late_, longest_delay_;
  std::size_t margin_, stride_;
  bool load_known_throughout_ = true;
  bool load_ever_known_ = true;
  double force_rms_ = 0.0, speed_rms_ = 0.0, travel_rms_ = 0.0, current_rms_ = 0.0;
  double level_a_ = 0.0, level_b_ = 0.0;  ///< medians over the supply pressure
  Unexplained none_{};
};

}  // namespace farrier::diagnosis
