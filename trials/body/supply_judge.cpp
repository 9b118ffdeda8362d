#include "trials/body/supply_judge.hpp"

namespace farrier::trials {

void SupplyJudge::observe(double now_s, const world::BodyWorld& body, double height_m, double pressure_Pa,
                          locomotion::SupplyDemand demand) noexcept {
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
  note(figures_.sag_s, height_m_ - height_m >= deep_m_ && demand != locomotion::SupplyDemand::kLie);
  note(figures_.acts_s, demand != locomotion::SupplyDemand::kNone);
  note(figures_.lying_s, height_m <= lying_m_);
  figures_.largest_sinking_m_s = std::max(figures_.largest_sinking_m_s, -body.state().linear_velocity_m_s.z());
  for (int leg = 0; leg < body.body().legs(); ++leg) {
    figures_.largest_foot_force_N = std::max(figures_.largest_foot_force_N, body.foot_force_N(leg).norm());
  }
}

}  // namespace farrier::trials
