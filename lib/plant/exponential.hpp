#pragma once

#include "core/portable_math.hpp"

namespace farrier::plant {

using portable_math::exponential_decay;

}  // namespace farrier::plant
