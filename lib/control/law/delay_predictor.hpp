#pragma once

#include <array>
#include <cstddef>

#include "control/model/discretise.hpp"
#include "control/law/force_controller.hpp"

namespace farrier::control {

/// Predicts a joint's measurement at the time when a current that is asked for now begins to act, if valve and bus
/// delay it. The gains' own model runs over the currents on their way, so a design without that delay fits the delayed
/// joint (Manitius and Olbrot 1979). The initial state is the model's of a tick ago, corrected by the measurement with
/// fixed shares. The joint's deviation from its model is estimated the same way and expected again. The measured force,
/// and not the model's, therefore settles on its reference. Default: no delay.
///
/// A delay is n ticks and a share f of one: in a tick 1 - f of one current and f of the previous one act.
class DelayPredictor {
 public:
  static constexpr std::size_t kMostTicks = 40;

  DelayPredictor() = default;
  /// `delay_s` >= 0 beyond `loop_delay_ticks`, which the gains' own design knows; both together end at kMostTicks.
  DelayPredictor(double delay_s, double period_s, int loop_delay_ticks) noexcept;

  bool active() const noexcept { return active_; }

  /// Once per period, before sent(). Values that are not finite empty the memory and come back as they are.
  Measurement predict(const DiscreteModel& model, const Measurement& now) noexcept;
  /// Likewise: the reference when that current acts, if it keeps its recent rate of change.
  double predict(double reference) noexcept;
  /// The current that was asked of the valve after predict().
  void sent(double current_A) noexcept;

  /// Forgets currents and measurements.
  void reset() noexcept;

 private:
  using Vector = Eigen::Vector3d;
  /// Mean current over the tick that began `ticks_ago`, before this period's is sent; >= -(whole_ + loop_ticks_).
  double acting_A(std::ptrdiff_t ticks_ago) const noexcept;

  bool active_ = false;
  std::size_t whole_ = 0;
  double share_ = 0.0;
  std::size_t loop_ticks_ = 0;
  std::array<double, kMostTicks + 2> sent_A_{};      ///< newest first
  double flow_share_ = 0.0;
  bool has_last_ = false;
  Vector last_ = Vector::Zero();    ///< state a tick ago, as believed then
  Vector beside_ = Vector::Zero();  ///< change of the state in a tick that the model does not know of
  bool has_reference_ = false;
  double reference_ = 0.0;          ///< of the last tick
  double slope_ = 0.0;              ///< of the reference, per tick
};

}  // namespace farrier::control
