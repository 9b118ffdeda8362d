#pragma once

#include "config/visitor.hpp"
#include "estimation/estimator_params.hpp"

// Settings of the methods and gates of an estimator. Declared beside the structs, where the visitor finds them.
namespace farrier::estimation {

void declare(config::Visitor& v, AdaptiveForgettingParams& aff);
void declare(config::Visitor& v, RandomWalkParams& kalman);
void declare(config::Visitor& v, VariableDirectionParams& vdf);
void declare(config::Visitor& v, SubspaceParams& sift);
void declare(config::Visitor& v, GreyBoxParams& grey_box);
void declare(config::Visitor& v, ValveFlowParams& valve_flow);
void declare(config::Visitor& v, PersistenceParams& pe);
void declare(config::Visitor& v, SpectrumParams& fft);

}  // namespace farrier::estimation
