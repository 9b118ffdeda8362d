#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/result.hpp"
#include "estimation/estimator_params.hpp"

namespace farrier::thesis {

/// Hubacher (2014), Table 6.1: how an estimator does for each combination of the valve signal's frequencies and
/// amplitude, on the changes of load of Fig. 6.1 (walking_cycle.hpp).
struct Table61Cell {
  const char* method;  ///< "rls", "aff", "greybox", "greybox_wrong" or "greybox_finds"
  bool rich;           ///< white noise; else 5 and 10 Hz (C.1)
  bool high;           ///< 100 % of the nominal valve opening; else 5 %
  bool noisy;          ///< with the sensors of fc1d.yaml
  /// 60 ms after each of the three changes. Error of the discrete transfer function i_v -> F_s, 0.5 to 100 Hz, against
  /// the true linearisation at home, mean of both signs of the valve; infinite if there is none.
  std::array<double, 3> gain_error_dB;
  std::array<double, 3> phase_error_deg;
  std::array<double, 3> mass_error;  ///< relative; of linear models as 6.3.1 extracts it, infinite where that fails
};

/// Errors of the actuator that "greybox_wrong" and "greybox_finds" are given, as factors of the truth. The latter takes it
/// for uncertain by 20 % and estimates it.
inline constexpr double kWrongValveGain = 1.2;
inline constexpr double kWrongBulkModulus = 0.8;

/// All cells of all methods: 40 of them. The linear methods are as in 6.3: lambda 0.85 (aff: its own), the home pose
/// subtracted, no bias, normalised. The grey-box estimator has its defaults: with the true actuator, with a wrong one, and
/// with a wrong one that it estimates. Refuses nothing but a bug.
Result<std::vector<Table61Cell>> table_6_1(std::uint64_t seed);

}  // namespace farrier::thesis
