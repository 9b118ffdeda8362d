#pragma once

#include <array>
#include <cstddef>

#include "control/model/discretise.hpp"
#include "control/law/force_controller.hpp"

namespace farrier::control {

/// What a joint will measure when a current that is asked for now begins to act, where valve and bus let it wait: the
/// gains' own model runs over the currents that are on their way, so that a design without that delay is one for the
/// delay (Manitius and Olbrot 1979). The state it begins at is the model's of a tick ago, corrected by what is measured
/// with fixed shares; what the joint does beside its model is found likewise and expected again, so that the force that
/// is measured and not that of the model settles on its reference. Default: no delay.
///
/// A delay is n ticks and a share f of one: over a tick act 1 - f of the one current and f of the one before it.
class DelayPredictor {
 public:
  static constexpr std::size_t kMostTicks = 40;

  DelayPredictor() = default;
  /// `delay_s` >= 0 beyond `loop_delay_ticks`, which the gains' own design knows; both together end at kMostTicks.
  DelayPredictor(double delay_s, double period_s, int loop_delay_ticks) noexcept;

  bool active() const noexcept { return active_; }

  /// Once per period, before sent(). Values that are not finite empty the memory and come back as they are.
  Measurement predict(const DiscreteModel& model, const Measurement& now) noexcept;
  /// Likewise: the reference when that current acts, if it goes on changing as it did of late.
  double predict(double reference) noexcept;
  /// What was asked for of the valve after predict().
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
