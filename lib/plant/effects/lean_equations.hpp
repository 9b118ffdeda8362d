#pragma once

#include "plant/effects/equations_with_effects.hpp"
#include "plant/runge_kutta.hpp"

namespace farrier::plant {

/// The joint's equations with lean effects. In a substep in which the piston slides one way the force of its seals is a
/// function of the way and no state: as exact, and not stiff.
class LeanEquations : public EquationsWithEffects<LeanEffects, OpeningInput> {
 public:
  using Base = EquationsWithEffects<LeanEffects, OpeningInput>;

  /// All outlive this; `sliding` are the same effects.
  LeanEquations(const JointEquations& joint, const LeanEffects& effects, SlidingEffects& sliding) noexcept
      : Base(joint, effects), sliding_(sliding), while_sliding_(joint, sliding) {}

  TrialStep<State> step(const OpeningInput& input, const State& s, const State& k1, double h) const noexcept {
    const auto& seal = effects().get<SealFriction>();
    if (seal.slides(s.velocity) && slides_on(s, s.velocity + h * k1.velocity)) {
      sliding_.change<SlidingSeal>().start(s.position, s.velocity, s.x[kSeal]);
      const auto trial = dormand_prince_step(while_sliding_, input, without_seal(s), without_seal(k1), h);
      if (slides_on(s, trial.state.velocity)) {
        State end = with_seal(trial.state, sliding_.get<SlidingSeal>().force(trial.state.position));
        State rate = with_seal(trial.end_derivative, seal.contact().rate(end.x[kSeal], end.velocity));
        return {end, rate, with_seal(trial.error, 0.0)};
      }
    }
    return dormand_prince_step<Base, State>(*this, input, s, k1, h);
  }

 private:
  static constexpr std::size_t kSeal = LeanEffects::at<SealFriction>();
  using SlidingState = EffectState<SlidingEffects>;

  bool slides_on(const State& s, double velocity) const noexcept {
    return s.velocity * velocity > 0.0 && effects().get<SealFriction>().slides(velocity);
  }
  static SlidingState without_seal(const State& s) noexcept { return {s, SlidingEffects::out_of<LeanEffects>(s.x)}; }
  static State with_seal(const SlidingState& s, double seal) noexcept {
    State all{s, {}};
    SlidingEffects::put_into<LeanEffects>(all.x, s.x);
    all.x[kSeal] = seal;
    return all;
  }

  SlidingEffects& sliding_;
  EquationsWithEffects<SlidingEffects, OpeningInput> while_sliding_;
};

}  // namespace farrier::plant
