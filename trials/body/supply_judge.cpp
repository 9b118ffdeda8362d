#include "trials/body/supply_judge.hpp"

namespace farrier::trials {

void SupplyJudge::observe(double now_s, const world::BodyWorld& body, double height_m, double pressure_Pa,
                          locomotion::SupplyDemand demand, bool dead_joint) noexcept {
  const double since_s = now_s - fault_s_;
  if (since_s < 0.0) {
    return;
  }
  const auto note = [since_s](std::optional<double>& first, bool is) {
    if (is && !first) {
      first = since_s;
    }
  };
  note(figures_.low_s, low_.step(pressure_Pa));
  note(figures_.sag_s, height_m_ - height_m >= deep_m_ && demand != locomotion::SupplyDemand::kLie && !dead_joint);
  note(figures_.slows_s, demand == locomotion::SupplyDemand::kSlow);
  note(figures_.acts_s, demand >= locomotion::SupplyDemand::kStand || dead_joint);
  note(figures_.lying_s, height_m <= lying_m_);
  figures_.largest_sinking_m_s = std::max(figures_.largest_sinking_m_s, -body.state().linear_velocity_m_s.z());
  figures_.recovers = pressure_Pa >= slow_Pa_;
  if (since_s >= kEnd_s) {
    if (!end_from_s_) {
      end_from_s_ = since_s;
      end_from_m_ = body.state().position_m;
    } else {
      figures_.end_speed_m_s = (body.state().position_m - end_from_m_).head<2>().norm() / (since_s - *end_from_s_);
    }
  }
  for (int leg = 0; leg < body.body().legs(); ++leg) {
    figures_.largest_foot_force_N = std::max(figures_.largest_foot_force_N, body.foot_force_N(leg).norm());
  }
}

}  // namespace farrier::trials
