#pragma once

#include "core/portable_math.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Play between piston and load, behind the load cell: in the play the cell carries nothing and the piston moves alone.
/// Flanks in touch give way by the force over their stiffness. Stepped (on_play), the piston stands where it is pushed to
/// within the play and its mass is left out: Nordin and Gutman (2002), 2.3. Integrated (on_oil), a compliance in its
/// place, piston - load = (b / 2) tanh(F / F_0) + F / k, with F_0 a two-hundredth of the actuator's force, their 2.2.
/// Neutral at 0.
template <class T>
class Backlash {
 public:
  static constexpr std::array kParameters{
      Parameter{"play_m",
                "play_rad",
                "m",
                "rad",
                Scale::kLength,
                false,
                0.0,
                0.2,
                {0.003, 0.02},
                "Whole width of the play, b."},
      Parameter{"contact_stiffness_N_m",
                "contact_stiffness_Nm_rad",
                "N/m",
                "Nm/rad",
                Scale::kStiffness,
                true,
                1e-5,
                2e-3,
                {1e-5, 1e-5},
                "Stiffness of its flanks, k; an electric joint has that of its gear."}};
  static constexpr EffectInfo kInfo{"backlash", Side::kValveAndOil, false,
                                    false,      kParameters,        "There is play between piston and load."};

  Backlash(const T* fitted, const Scales& scales, double) noexcept
      : half_play_(0.5 * fitted[0] * scales.of(Scale::kLength)),
        compliance_(fitted[1] / scales.of(Scale::kStiffness)),
        inverse_force_(200.0 / scales.of(Scale::kForce)) {}

  void on_oil(OilMoment<T>& now) noexcept {
    const double bent = portable::tanh(now.hydraulic_force * inverse_force_);
    now.play_slope += half_play_ * ((1.0 - bent * bent) * inverse_force_) + compliance_;
  }

  void on_play(PlayMoment<T>& now) noexcept {
    if (!started_) {
      place_ = compliance_ * now.drive + (now.drive > 0.0 ? half_play_ : T(-half_play_));
      started_ = true;
    }
    // (to - place) resistance = drive - (to -+ b / 2) / compliance, without its last term amid the play.
    const T resistance = now.damping / now.step_s + now.stiffness;
    const T pushed = now.drive + resistance * place_;
    T to = pushed / resistance;
    if (to > half_play_) {
      to = (half_play_ + compliance_ * pushed) / (1.0 + compliance_ * resistance);
    } else if (to < -half_play_) {
      to = (compliance_ * pushed - half_play_) / (1.0 + compliance_ * resistance);
    }
    now.moved = to - place_;
    drag_ = now.damping * now.moved / now.step_s;
    place_ = to;
  }
  void on_piston(PistonMoment<T>& now) noexcept { now.force -= drag_; }

 private:
  bool started_ = false;
  T place_ = T(0.0);  ///< of the piston within the play
  T drag_ = T(0.0);   ///< of the oil on the piston that moves in it
  T half_play_, compliance_;
  double inverse_force_;
};

}  // namespace farrier::plant
