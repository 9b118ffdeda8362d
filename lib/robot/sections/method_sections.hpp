#pragma once

#include "config/visitor.hpp"
#include "estimation/estimator_params.hpp"

// What a method or a gate of an estimator is told. Beside the structs, where the visitor looks for them.
namespace farrier::estimation {

void declare(config::Visitor& v, AdaptiveForgettingParams& aff);
void declare(config::Visitor& v, RandomWalkParams& kalman);
void declare(config::Visitor& v, VariableDirectionParams& vdf);
void declare(config::Visitor& v, SubspaceParams& sift);
void declare(config::Visitor& v, GreyBoxParams& grey_box);
void declare(config::Visitor& v, PersistenceParams& pe);
void declare(config::Visitor& v, SpectrumParams& fft);

}  // namespace farrier::estimation
