#pragma once

#include "locomotion/trot_controller.hpp"

namespace farrier::locomotion {

/// The mounts of HyQ's legs lf, rf, lh, rh (iit-DLSLab/hyq-description f95d651) with the defaults of everything else.
inline LocomotionParams hyq_locomotion() {
  constexpr double kHipX_m = 0.3735, kHipY_m = 0.207;
  constexpr double kFoldedHaa_rad = -0.28, kFoldedHfe_rad = 1.15, kFoldedKfe_rad = -2.3;
  LocomotionParams params;
  for (int leg = 0; leg < 4; ++leg) {
    const double front = leg < 2 ? 1.0 : -1.0;
    const double left = leg % 2 == 0 ? 1.0 : -1.0;
    params.mounts[leg] = {.hip_m = {front * kHipX_m, left * kHipY_m, 0.0},
                          .outward = left,
                          .folded_rad = {kFoldedHaa_rad, front * kFoldedHfe_rad, front * kFoldedKfe_rad}};
  }
  return params;
}

}  // namespace farrier::locomotion
