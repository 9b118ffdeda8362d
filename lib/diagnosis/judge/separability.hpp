#pragma once

#include <array>
#include <optional>
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
  std::vector<double> size;  ///< numbers of the effect that is looked at: its usual size
  double change = 0.0;       ///< largest rms change of a channel that the model's constants cannot follow, likewise
  bool shows = false;        ///< the change would be enough to name an effect by
  double shows_from = 0.0;   ///< first number of `size` from which it would be, if the change grew in proportion
  std::vector<LikeEffect> rivals;  ///< that the recording does not tell from it, the most alike first
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

}  // namespace farrier::diagnosis
