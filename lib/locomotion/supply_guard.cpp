#include "locomotion/supply_guard.hpp"

#include <algorithm>

namespace farrier::locomotion {

void SupplyGuard::judge(const SupplyReading& reading) noexcept {
  low_s_ = low_.step(reading.pressure_Pa) ? low_s_ + period_s_ : 0.0;
  empty_ = !(reading.pressure_Pa >= params_.lie_Pa) || !(reading.pump_flow_m3_s >= params_.least_pump_flow_m3_s);
  empty_s_ = empty_ ? empty_s_ + period_s_ : 0.0;
  if (!(reading.pressure_Pa >= params_.slow_Pa)) {
    speed_ = std::max(params_.slowest, speed_ - params_.slowing_1_s * period_s_);
  } else if (reading.pressure_Pa >= params_.recovered_Pa) {
    speed_ = std::min(1.0, speed_ + params_.quickening_1_s * period_s_);
  }
  if (empty_s_ > params_.lie_after_s) {
    demand_ = SupplyDemand::kLie;
  } else if (low_s_ > params_.stand_after_s) {
    demand_ = std::max(demand_, SupplyDemand::kStand);
  }
}

MotionCommand SupplyGuard::step(const MotionCommand& asked, const std::optional<SupplyReading>& reading) noexcept {
  if (reading) {
    judge(*reading);
  }
  const Request most = demand_ == SupplyDemand::kLie     ? Request::kLie
                       : demand_ == SupplyDemand::kStand ? Request::kStand
                                                         : Request::kTrot;
  if (asked.request > most) {
    return {.request = most, .height_m = asked.height_m, .at_once = most == Request::kLie, .weak_supply = true};
  }
  if (!low_.on() && !empty_) {
    demand_ = SupplyDemand::kNone;
  }
  MotionCommand slower = asked;
  slower.forward_m_s *= speed_;
  slower.left_m_s *= speed_;
  slower.yaw_rate_rad_s *= speed_;
  slower.weak_supply = demand() != SupplyDemand::kNone;
  return slower;
}

}  // namespace farrier::locomotion
