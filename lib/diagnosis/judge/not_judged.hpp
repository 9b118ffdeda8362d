#pragma once

#include <vector>

#include "diagnosis/judge/judgement.hpp"

namespace farrier::diagnosis {

/// Effects that the recording cannot show: none of their channels was recorded, or their change of a channel would be
/// too small. An effect of usual size (the start of its fits, a fifth of a nominal parameter) is added to `model`. Its
/// change is too small below `least_reduction` of the channel's remainder, or of its sensors' noise if that is larger.
/// In the order of the effects; those that the model has, or that are known, are judged.
std::vector<plant::EffectId> not_judged(const Bench& bench, const Model& model,
                                        const std::array<Remainder, kChannels>& left, double least_reduction);

}  // namespace farrier::diagnosis
