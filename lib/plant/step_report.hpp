#pragma once

namespace farrier::plant {

/// Report of one step. The error is that of the whole state: local errors of the fourth-order solution (the fifth is
/// kept), relative to stroke, velocity_scale() and supply pressure, added over states and substeps. It is given in each
/// unit. States are coupled, so that one whose own estimate vanishes by chance still errs by its neighbours'. Substeps
/// striding over a void's start or a port's laminar range count 30 times. On HyQ cylinders against a 2 us reference the
/// true error of a step is typically a twentieth of this, and below it in over 99.5 % of steps. It is at most 6 times
/// it (a substep that grazes a void between its stages).
struct StepReport {
  double error_position = 0.0;     ///< m or rad
  double error_velocity = 0.0;     ///< m/s or rad/s
  double error_pressure_Pa = 0.0;  ///< either chamber; 0 where there is none
  int substeps = 0;                ///< accepted ones; at most 2 period / kShortestSubstep_s
  int rejected = 0;                ///< substeps tried and repeated smaller
  bool bound_hit = false;          ///< a substep was taken above tolerance, being the shortest allowed
  bool cavitated = false;          ///< a chamber held a void
  bool at_stop = false;            ///< the piston or the load pressed on an end stop
  bool input_refused = false;      ///< an input was not finite or out of range and its substitute acted
};

}  // namespace farrier::plant
