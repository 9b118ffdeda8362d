#pragma once

#include <cmath>

#include "plant/effects/effect.hpp"
#include "plant/refusals.hpp"

namespace farrier::plant {

/// Part of a load's mass that hangs on the rest by a spring and a damper. Share 0: none.
struct FlexibleParams {
  double share = 0.0;                    ///< of the load's mass; in [0, 1)
  double natural_frequency_rad_s = 1.0;  ///< of this part beside a load at rest; > 0
  double damping = 0.0;                  ///< of it, D; >= 0
};

inline Result<Done> validate(const FlexibleParams& flexible) {
  Refusals refusals("flexible part");
  refusals.require(flexible.share >= 0.0 && flexible.share < 1.0, "share", flexible.share, "within [0, 1)");
  refusals.positive("natural_frequency_rad_s", flexible.natural_frequency_rad_s);
  refusals.not_negative("damping", flexible.damping);
  return refusals.verdict();
}

/// The equation of plant::FlexibleLoad, integrated: states r, way of the part beside the load (m or rad), and u, its own
/// speed (m/s or rad/s). LoadEquations has the rest of the load's mass.
class FlexiblePart : public Effect<2> {
 public:
  FlexiblePart(const FlexibleParams& params, double load_mass, double length, double speed) noexcept
      : length_(length), speed_(speed) {
    set(params, load_mass);
  }

  void set(const FlexibleParams& params, double load_mass) noexcept {
    params_ = params;
    mass_ = params.share * load_mass;
  }

  bool active() const noexcept { return params_.share > 0.0; }
  double fastest_rate(double) const noexcept {
    // Against the rest of the load alone: w^2 / (1 - s) and 2 D w / (1 - s).
    const double rest = 1.0 - params_.share;
    const double omega = params_.natural_frequency_rad_s;
    return omega / std::sqrt(rest) + 2.0 * params_.damping * omega / rest;
  }
  X scale() const noexcept { return {length_, speed_}; }
  X rest(const RestPoint& point) const noexcept { return {0.0, point.velocity}; }
  void after_valve(Instant& now, const X& x, X& dx) const noexcept {
    const double omega = params_.natural_frequency_rad_s;
    dx[0] = x[1] - now.velocity;
    dx[1] = -omega * (omega * x[0] + 2.0 * params_.damping * dx[0]);
    now.load_force -= mass_ * dx[1];
  }

 private:
  FlexibleParams params_;
  double mass_ = 0.0;
  double length_, speed_;
};

}  // namespace farrier::plant
