#pragma once

#include <array>
#include <vector>

#include "diagnosis/judge/judgement.hpp"

namespace farrier::diagnosis {

/// An effect that explains what another one does to a recording.
struct LikeEffect {
  plant::EffectId id;
  std::vector<double> fitted;  ///< numbers with which it explains most
  double left;  ///< largest rms on a channel that it leaves of the other one's change, over the noise that is expected
};

/// Change that one effect makes beside a model, and the effects that explain it as well.
struct EffectVisibility {
  plant::EffectId id;
  std::vector<double> size;        ///< numbers of the effect that is looked at
  double change = 0.0;             ///< largest rms change of a channel that the model's numbers cannot follow, likewise
  double deviations = 0.0;         ///< by which its first number is expected to lie outside its neutral band
  bool shows = false;              ///< the change is enough to name the effect by, and so are the deviations
  double shows_from = 0.0;         ///< first number of `size` from which it would be, if the change grew in proportion
  std::vector<LikeEffect> rivals;  ///< that the recording does not tell from it, the most alike first
};

/// An effect of a set, beside the others of the set.
struct MemberVisibility {
  EffectVisibility beside;
  bool recorded = true;  ///< a recorded column may show it
  std::vector<plant::EffectId>
      hidden_by;  ///< effects of the set that follow its change: it would show without one of them
  Model without;  ///< the rest of the set, or that with a rival, with the numbers that explain most

  bool separable() const noexcept { return beside.shows && beside.rivals.empty(); }
};

/// The effect at a usual size: the start of its fits, a fifth of a nominal parameter. Empty where its fits have no start.
std::vector<double> usual_size(const Simulator& simulator, plant::EffectId id);

/// Finds for each effect whether a recording shows it beside `model`, and which effects explain the same.
///
/// An effect of usual size changes the simulated channels. The model's constants and each other effect, within their ranges,
/// follow that change by the linear least squares step from the starts of their fits. An effect does not show if the
/// constants alone leave less than `rules` ask of a name. Another one is its rival if it leaves less than a clear lead.
///
/// `expected` is the rms by channel of the sensors' noise in residuals, N | m/s. The order is that of the effects; those
/// without a start are left out.
std::vector<EffectVisibility> effect_visibilities(const Bench& bench, const Model& model,
                                                  const std::array<double, kChannels>& expected, const Rules& rules,
                                                  const ForEach& for_each);

/// Finds for each effect of a set of these sizes whether a recording of a joint with the whole set shows it and tells it from
/// others. The same rules hold for each beside the rest of the set as for one effect alone. The constants and the numbers of
/// the others, from their own sizes, follow its change, and then each effect outside the set does too. It must also change a
/// channel by as much of the whole set's change as a further effect must explain.
///
/// It fits no number. Measurements are the trajectory along which changes are simulated. `set` has no effect twice, and none
/// that the joint's file has. One with an empty size is not simulated and does not show. The order is that of `set`.
std::vector<MemberVisibility> member_visibilities(const Bench& bench, const std::vector<Model::Effect>& set,
                                                  const std::array<double, kChannels>& expected, const Rules& rules,
                                                  const ForEach& for_each);

}  // namespace farrier::diagnosis
