#pragma once

#include <vector>

#include "diagnosis/judge/judgement.hpp"

namespace farrier::diagnosis {

/// Effects that the recording cannot show: no channel of theirs was recorded, or one of a usual size (where its fits
/// begin, a fifth of a nominal parameter) beside `model` would change a channel by less than shows: `least_reduction`
/// of what is left of it, or of its sensors' noise where that is more. In the order of the effects; those that the
/// model has are judged.
std::vector<plant::EffectId> not_judged(const Bench& bench, const Model& model,
                                        const std::array<Remainder, kChannels>& left, double least_reduction);

}  // namespace farrier::diagnosis
