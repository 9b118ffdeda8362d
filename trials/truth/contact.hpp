#pragma once

#include "trials/truth/machine.hpp"

namespace farrier::truth {

/// Force of a dry contact with its bristles bent by z, sliding at v, `off_middle` from mid-stroke; `dz` gets z'.
///   F = s0 z + s1 z',   z' = v - s0 |v| z / g(v),   g(v) = F_c + (F_s - F_c) exp(-(v / v_s)^2)
double rub(const Contact& contact, double off_middle, double v, double z, double& dz);

}  // namespace farrier::truth
