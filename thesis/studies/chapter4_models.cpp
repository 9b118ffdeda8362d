// Hubacher (2014), Figs 4.2 to 4.5: transfer functions of the three linear models of Table A.1's joint.

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/model/model_analysis.hpp"
#include "thesis/rig/bode.hpp"
#include "thesis/studies/registry.hpp"
#include "plant/nominal.hpp"

namespace farrier::thesis {
namespace chapter4_models_studies {
namespace {

using control::responses;
using plant::Output;
using plant::Volumes;

constexpr int kPoints = 400;
const std::vector<double>& grid() {
  static const std::vector<double> frequencies = control::logarithmic_grid(0.01, 1000.0, kPoints);
  return frequencies;
}

const plant::ActuatorParams& cylinder() {
  static const plant::ActuatorParams params = plant::nominal_cylinder();
  return params;
}

Response full(const plant::ChamberPoint& point, Output output, Volumes volumes = Volumes::kMoving) {
  return responses<4>(control::full_system(cylinder(), plant::nominal_load(), point, output, volumes), grid());
}
Response simple(const plant::OperatingPoint& point, Output output, Volumes volumes = Volumes::kMoving) {
  return responses<3>(control::load_pressure_system(cylinder(), plant::nominal_load(), point, output, volumes), grid());
}
Response load_cell(const plant::OperatingPoint& point, Output output, Volumes volumes = Volumes::kMoving) {
  return responses<3>(control::load_cell_system(cylinder(), plant::nominal_load(), point, output, volumes), grid());
}

/// Slope in dB per decade between two frequencies.
double slope(const Response& response, double from_Hz, double to_Hz) {
  return (magnitude_dB_near(grid(), response, to_Hz) - magnitude_dB_near(grid(), response, from_Hz)) /
         std::log10(to_Hz / from_Hz);
}

/// Returns by how much the lowest magnitude within [from, to] lies below the lower of the ends.
double dent_dB(const Response& response, double from_Hz, double to_Hz) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < grid().size(); ++i) {
    if (grid()[i] >= from_Hz && grid()[i] <= to_Hz) {
      lowest = std::min(lowest, control::decibel(response[i]));
    }
  }
  return std::min(magnitude_dB_near(grid(), response, from_Hz), magnitude_dB_near(grid(), response, to_Hz)) - lowest;
}

constexpr const char* kPosition =
    "The position transfer function has an integrator at the origin ... and only a small resonance peak followed by a "
    "quick roll-off.";
constexpr const char* kForce =
    "Note the steep slope at low frequencies, the dent around middle frequencies ..., and the sharp resonance peak at "
    "high frequencies ...";

constexpr const char* kTwoCauses =
    "the chamber pressures of Chapter 3 are not those of steady flow, (3.19) and (3.20), which the simplified models "
    "assume: "
    "0.53 dB at every frequency; near the resonance (3.51), with the piston's mass in one row alone, adds 0.13 dB";

constexpr ClaimSpec kOutputClaims[] = {
    {"4.2.position_integrates", "4.2", kPosition,
     "Distance of the position's slope from 0.01 to 0.1 Hz from -20 dB per decade.", "dB", Relation::kAtMost, 0.5},
    {"4.2.position_rolls_off", "4.2", kPosition,
     "Slope of the position from 500 to 1000 Hz, per decade: -40 dB or steeper.", "dB", Relation::kAtMost, -40.0},
    {"4.2.force_slope", "4.2", kForce, "Distance of the force's slope from 0.01 to 0.1 Hz from -20 dB per decade.",
     "dB", Relation::kAtMost, 0.5},
    {"4.2.force_dent", "4.2", kForce,
     "Depth of the force's dent between 0.1 Hz and its resonance below the lower of both.", "dB", Relation::kAtLeast,
     3.0},
    {"4.2.force_resonance", "4.2", kForce,
     "Frequency of the force's resonance: in the upper of the three decades 1 to 1000 Hz.", "Hz", Relation::kAtLeast,
     100.0},
    {"4.2.full_is_simple", "4.2.1", "As can be seen, all models give the same transfer function ...",
     "Largest difference of the full and the load-cell model over all three outputs.", "dB", Relation::kAtMost, 1.0}};

Result<StudyResult> run_outputs(const StudyContext&) {
  const plant::ChamberPoint chambers = plant::nominal_chamber_point(1.0);
  const plant::OperatingPoint point = plant::nominal_point(1.0);
  constexpr Output kOutputs[] = {Output::kPosition, Output::kVelocity, Output::kLoadCellForce};
  constexpr const char* kNames[] = {"position (m/A)", "velocity (m/s/A)", "load-cell force (N/A)"};
  std::vector<Response> of_full;
  std::vector<std::vector<Panel>> columns;
  double difference = 0.0;
  for (std::size_t i = 0; i < std::size(kOutputs); ++i) {
    of_full.push_back(full(chambers, kOutputs[i]));
    const Response of_cell = load_cell(point, kOutputs[i]);
    difference = std::max(difference, largest_difference_dB(grid(), of_full.back(), of_cell, 0.01, 1000.0));
    const Curve curves[] = {{"full", of_full.back(), 1}, {"load cell", of_cell, 3, -1.0, Style::kDashed}};
    columns.push_back(bode_panels(kNames[i], grid(), curves));
  }
  const auto resonance = control::resonance<4>(
      control::full_system(cylinder(), plant::nominal_load(), chambers, Output::kLoadCellForce), 10.0, 1000.0);
  const double peak_Hz = resonance ? resonance->frequency_Hz : std::numeric_limits<double>::quiet_NaN();
  StudyResult result;
  result.measured = {{"4.2.position_integrates", std::abs(slope(of_full[0], 0.01, 0.1) + 20.0), ""},
                     {"4.2.position_rolls_off", slope(of_full[0], 500.0, 1000.0), ""},
                     {"4.2.force_slope", std::abs(slope(of_full[2], 0.01, 0.1) + 20.0), ""},
                     {"4.2.force_dent", dent_dB(of_full[2], 0.1, peak_Hz), ""},
                     {"4.2.force_resonance", peak_Hz, ""},
                     {"4.2.full_is_simple", difference, ""}};
  result.pictures = {bode_picture("From valve current, nominal operating point", std::move(columns))};
  return result;
}

constexpr const char* kCoincide = "... all three transfer functions coincide for frequencies above 10^2 Hz ...";

constexpr ClaimSpec kForceClaims[] = {
    {"4.3.above_100_hydraulic", "4.2", kCoincide, "Largest difference of F_h and F_s from 100 Hz to 1000 Hz.", "dB",
     Relation::kAtMost, 1.0},
    {"4.3.above_100_total", "4.2", kCoincide, "Largest difference of F_t and F_s from 100 Hz to 1000 Hz.", "dB",
     Relation::kAtMost, 1.0},
    {"4.3.below_100", "4.2", "Their shape differs at frequencies below 10^2 Hz.",
     "Largest difference of F_t and F_s from 1 to 100 Hz.", "dB", Relation::kAtLeast, 6.0},
    {"4.3.total_zeros", "4.2", "... the total force transfer function u_v -> F_t has two zeros at the origin ...",
     "Larger modulus of its two smallest zeros.", "1/s", Relation::kAtMost, 1e-3},
    {"4.3.hydraulic_is_near", "4.2", "The other two transfer functions only differ slightly ...",
     "Largest difference of F_h and F_s over that of F_t and F_s, 0.1 to 100 Hz: a fifth.", "1", Relation::kAtMost,
     0.2}};

Result<StudyResult> run_forces(const StudyContext&) {
  const plant::OperatingPoint point = plant::nominal_point(1.0);
  const Response cell = load_cell(point, Output::kLoadCellForce);
  const Response hydraulic = load_cell(point, Output::kHydraulicForce);
  const Response total = load_cell(point, Output::kTotalForce);
  const auto zeros =
      control::zeros<3>(control::load_cell_system(cylinder(), plant::nominal_load(), point, Output::kTotalForce));
  std::vector<double> moduli;
  for (Eigen::Index i = 0; i < zeros.size(); ++i) {
    moduli.push_back(std::abs(zeros(i)));
  }
  std::ranges::sort(moduli);
  StudyResult result;
  result.measured = {{"4.3.above_100_hydraulic", largest_difference_dB(grid(), hydraulic, cell, 100.0, 1000.0), ""},
                     {"4.3.above_100_total", largest_difference_dB(grid(), total, cell, 100.0, 1000.0), ""},
                     {"4.3.below_100", largest_difference_dB(grid(), total, cell, 1.0, 100.0), ""},
                     {"4.3.total_zeros", moduli.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : moduli[1], ""},
                     {"4.3.hydraulic_is_near",
                      largest_difference_dB(grid(), hydraulic, cell, 0.1, 100.0) /
                          largest_difference_dB(grid(), total, cell, 0.1, 100.0),
                      ""}};
  const Curve curves[] = {{"load cell", cell, 1}, {"hydraulic", hydraulic, 2}, {"total", total, 3}};
  result.pictures = {bode_picture("Three forces, load-cell model, nominal operating point",
                                  {bode_panels("force (N/A)", grid(), curves)})};
  return result;
}

/// The three models' load-cell force in one column of Figs 4.4 and 4.5.
struct Column {
  Response full, simple, cell;
  std::vector<Panel> panels(const char* title) const {
    const Curve curves[] = {{"full", full, 1},
                            {"load pressure", simple, 3, -1.0, Style::kDashed},
                            {"load cell", cell, 2, -1.0, Style::kDashed}};
    return bode_panels(title, grid(), curves);
  }
  /// Largest difference of either simplified model to the full one.
  double simplified_dB(double from_Hz, double to_Hz) const {
    return std::max(largest_difference_dB(grid(), simple, full, from_Hz, to_Hz),
                    largest_difference_dB(grid(), cell, full, from_Hz, to_Hz));
  }
};

Column column_at(double velocity, double valve_share, Volumes volumes) {
  const double current_A = valve_share * cylinder().valve_current_max_A;
  plant::ChamberPoint chambers = plant::nominal_chamber_point(1.0);
  chambers.state.velocity = velocity;
  chambers.valve_current_A = current_A;
  plant::OperatingPoint point = plant::nominal_point(1.0);
  point.velocity = velocity;
  point.valve_current_A = current_A;
  return {full(chambers, Output::kLoadCellForce, volumes), simple(point, Output::kLoadCellForce, volumes),
          load_cell(point, Output::kLoadCellForce, volumes)};
}

constexpr double kLow_Hz = 10.0;    // "low frequency": below the dent of the nominal response
constexpr double kHigh_Hz = 100.0;  // and what lies above the "low to middle" ones

constexpr const char* kSame =
    "As can be seen, all models give the same transfer function, thus the assumptions appear to have no influence.";
constexpr const char* kNotCapture =
    "... the simple ... and simple F_s ... model are not able to capture the impact of the changed operating point ...";
constexpr const char* kOnlyLow = "However, in both cases they only differ in the low frequency range.";

constexpr ClaimSpec kValveClaims[] = {
    {"4.4.nominal_same", "4.2.1", kSame, "Largest difference of the three models at the nominal point.", "dB",
     Relation::kAtMost, 0.5, Refutation{kTwoCauses, 0.6, 0.8}},
    {"4.4.simplified_differ", "4.2.1", kNotCapture,
     "Valve at 30 %: largest difference of a simplified model to the full one below 10 Hz.", "dB", Relation::kAtLeast,
     1.0},
    {"4.4.only_low", "4.2.1", kOnlyLow, "The same above 100 Hz.", "dB", Relation::kAtMost, 1.0},
    {"4.4.constant_volume", "4.2.1",
     "... this assumption influences all three models not being able to completely capture the low frequency dynamics "
     "...",
     "Least, over the models, of the largest difference below 10 Hz of the one with constant volumes to the full model "
     "without.",
     "dB", Relation::kAtLeast, 1.0}};

constexpr ClaimSpec kVelocityClaims[] = {
    {"4.5.simplified_differ", "4.2.1",
     "The two simplified models are again not able to fully cope with the changed operating point ...",
     "1 m/s: largest difference of a simplified model to the full one below 10 Hz.", "dB", Relation::kAtLeast, 1.0,
     Refutation{"they follow: (3.24) holds the velocity, and the 0.53 dB that remain are those of the nominal point",
                0.4, 0.8}},
    {"4.5.only_low", "4.2.1", kOnlyLow, "The same above 100 Hz.", "dB", Relation::kAtMost, 1.0},
    {"4.5.constant_volume_is_nominal", "4.2.1",
     "... the transfer functions of column three look exactly like the ones from column one ...",
     "Largest difference of any model with constant volumes at 1 m/s to itself at the nominal point.", "dB",
     Relation::kAtMost, 1e-6},
    {"4.5.constant_volume", "4.2.1",
     "The influence of this \"constant volume\" assumption is even more severe when changing the velocity operating "
     "point ...",
     "Difference below 10 Hz of the full model with constant volumes to that without, 1 m/s over 30 % valve.", "1",
     Relation::kAtLeast, 1.0}};

struct Columns {
  Column nominal, moved, constant;
};

Columns columns_at(double velocity, double valve_share) {
  return {column_at(0.0, 0.0, Volumes::kMoving), column_at(velocity, valve_share, Volumes::kMoving),
          column_at(velocity, valve_share, Volumes::kConstant)};
}

Picture picture_of(const std::string& caption, const Columns& columns) {
  return bode_picture(caption, {columns.nominal.panels("nominal"), columns.moved.panels("moved"),
                                columns.constant.panels("moved, constant volumes")});
}

double full_lost_dB(const Columns& columns) {
  return largest_difference_dB(grid(), columns.constant.full, columns.moved.full, 0.01, kLow_Hz);
}

Result<StudyResult> run_valve_point(const StudyContext&) {
  const Columns c = columns_at(0.0, 0.3);
  StudyResult result;
  result.measured = {
      {"4.4.nominal_same", c.nominal.simplified_dB(0.01, 1000.0), ""},
      {"4.4.simplified_differ", c.moved.simplified_dB(0.01, kLow_Hz), ""},
      {"4.4.only_low", c.moved.simplified_dB(kHigh_Hz, 1000.0), ""},
      {"4.4.constant_volume",
       std::min({full_lost_dB(c), largest_difference_dB(grid(), c.constant.simple, c.moved.full, 0.01, kLow_Hz),
                 largest_difference_dB(grid(), c.constant.cell, c.moved.full, 0.01, kLow_Hz)}),
       ""}};
  result.pictures = {picture_of("Load-cell force, valve at 30 %", c)};
  return result;
}

Result<StudyResult> run_velocity_point(const StudyContext&) {
  const Columns c = columns_at(1.0, 0.0);
  const double to_nominal = std::max({largest_difference_dB(grid(), c.constant.full, c.nominal.full, 0.01, 1000.0),
                                      largest_difference_dB(grid(), c.constant.simple, c.nominal.simple, 0.01, 1000.0),
                                      largest_difference_dB(grid(), c.constant.cell, c.nominal.cell, 0.01, 1000.0)});
  StudyResult result;
  result.measured = {{"4.5.simplified_differ", c.moved.simplified_dB(0.01, kLow_Hz), ""},
                     {"4.5.only_low", c.moved.simplified_dB(kHigh_Hz, 1000.0), ""},
                     {"4.5.constant_volume_is_nominal", to_nominal, ""},
                     {"4.5.constant_volume", full_lost_dB(c) / full_lost_dB(columns_at(0.0, 0.3)), ""}};
  result.pictures = {picture_of("Load-cell force, piston at 1 m/s", c)};
  return result;
}

constexpr const char* kConditions =
    "Joint of Table A.1, positive valve sign; load-cell model (3.51) with the piston's mass in its row 2. Figs 4.4 and "
    "4.5 are "
    "drawn, as the text's, at points that are not steady. It has no random part.";

constexpr Study kStudies[] = {
    {"4.2", "Transfer functions to position, velocity and force", kOutputClaims, run_outputs, kConditions},
    {"4.3", "Load-cell, hydraulic and total force", kForceClaims, run_forces, kConditions},
    {"4.4", "Models at another valve opening, and with constant volumes", kValveClaims, run_valve_point, kConditions},
    {"4.5", "Models at another velocity, and with constant volumes", kVelocityClaims, run_velocity_point, kConditions}};

}  // namespace
}  // namespace chapter4_models_studies

std::span<const Study> chapter4_models() { return chapter4_models_studies::kStudies; }

}  // namespace farrier::thesis
