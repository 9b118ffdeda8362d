#pragma once

// Result of `farrier compare bandwidth`.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"
#include "trials/force_bandwidth.hpp"

namespace farrier::report {

/// A valve, and what the node was told of it.
struct BandwidthDesign {
  const char* name;   ///< in figures
  const char* title;  ///< for people
  double valve_gain;  ///< of the simulated valve, over the file's
  bool knows;         ///< the node has the true gain
};
inline constexpr std::array kBandwidthDesigns{BandwidthDesign{"as_filed", "gain 1", 1.0, false},
                                              BandwidthDesign{"gain_50_fixed", "0.5 fixed", 0.5, false},
                                              BandwidthDesign{"gain_50_adapted", "0.5 adapted", 0.5, true},
                                              BandwidthDesign{"gain_175_fixed", "1.75 fixed", 1.75, false},
                                              BandwidthDesign{"gain_175_adapted", "1.75 adapted", 1.75, true}};

/// A joint in a pose with sines of one amplitude.
struct BandwidthRow {
  std::string joint;
  double angle_rad;
  double amplitude_Nm;
  bool typical;                    ///< the home pose and the middle amplitude: its figures are written
  std::optional<double> spool_Hz;  ///< where the spool alone lags by 90 degrees
  double full_flow_Hz;             ///< of the file's valve
  std::array<trials::ForceBandwidth, kBandwidthDesigns.size()> of;  ///< in the order of the designs
};

/// Adds compare.bandwidth.* of the typical rows.
void add_bandwidth(Figures& figures, std::span<const BandwidthRow> rows);

/// Table for people: frequencies of -3 dB and of -90 degrees of every row and design.
std::string bandwidth_text(std::span<const BandwidthRow> rows);

}  // namespace farrier::report
