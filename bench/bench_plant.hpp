#pragma once

namespace farrier::bench {

/// Twelve hydraulic joints over the same inputs, ours against CVODE (Hindmarsh et al. 2005) at equal accuracy.
struct PlantBench {
  double ours_s_per_tick = 0.0;   ///< wall time for all twelve joints, one 1 ms tick
  double cvode_s_per_tick = 0.0;  ///< same, fastest of CVODE's configurations at the error nearest to ours
  double ours_error = 0.0;        ///< RMS over joints, ticks and states of the distance to the reference, in units of
                                  ///< stroke, velocity_scale() and supply pressure
  double cvode_error = 0.0;       ///< same
  const char* cvode_configuration = "";
  double effects_s_per_tick = 0.0;  ///< as ours_s_per_tick, the joints with friction, overlap and a supply that droops
};

/// Runs `ticks` (>= 1) of 1 ms: four legs of HyQ-like joints (one rotary motor, two cylinders each) under seeded
/// valve noise, loads switching between stance and swing at 2 Hz. The reference is a fourth-order Runge-Kutta
/// method of fixed 2.5 us steps.
PlantBench bench_plant(int ticks);

}  // namespace farrier::bench
