// Hubacher (2014), Figs 4.6 and 4.7: how the load-cell force's transfer function changes with the operating point.

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/model/model_analysis.hpp"
#include "thesis/rig/bode.hpp"
#include "thesis/rig/nominal_force.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace chapter4_points_studies {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kVelocityRange_m_s = 1.2;  // (3.9)

/// Nominal, and the valve full open either way.
struct Family {
  Response shut, extending, retracting;
};

Family family() {
  const auto at = [](double share, double sign) {
    plant::OperatingPoint point = plant::nominal_point(sign);
    point.valve_current_A = share * plant::nominal_cylinder().valve_current_max_A;
    return control::responses<3>(nominal_force(point), force_grid());
  };
  return {at(0.0, 1.0), at(1.0, 1.0), at(-1.0, -1.0)};
}

constexpr ClaimSpec kValveClaims[] = {
    {"4.6.negative_is_lower", "4.3.1",
     "The response magnitude of the fully negative open valve ... is less than that of the positive open valve ...",
     "Largest magnitude of the negative one less the positive one, 0.1 to 1000 Hz: below zero.", "dB", Relation::kBelow,
     0.0,
     Refutation{
         "below 2 Hz it is higher: the part of (3.24) that the open valve adds changes its sign with the valve's", 6.0,
         12.0}},
    proof(
        {"4.6.negative_is_lower_above_3_Hz", "4.3.1",
         "The response magnitude of the fully negative open valve ... is less than that of the positive open valve ...",
         "The same from 3 Hz on.", "dB", Relation::kBelow, 0.0}),
    {"4.6.resonance_is_damped", "4.3.1", "The valve operating point ... dominate[s] the resonance peak significantly.",
     "Drop of the magnitude at the nominal resonance with the valve full open, the smaller of both signs.", "dB",
     Relation::kAtLeast, 6.0},
    fails(
        "each sign against the shut valve of that sign, openings of 5 to 100 % and each of 5, 7 and 10 Hz: 12.9 to "
        "15.9 dB. The shut valve's own magnitude decreases by 13 dB",
        {"4.6.ten_dB_less", "9.2.3",
         "... the system's force response mutates from the blue curve to something in between the green and red curve "
         "... The magnitude of the force response decreases by about 10 dB ...",
         "Distance from 10 dB of the magnitude of the shut valve at 1 Hz less that of the open one, mean of both signs "
         "and over 5 to 10 Hz: 3 dB.",
         "dB", Relation::kAtMost, 3.0})};

/// Magnitude of the shut valve at 1 Hz less that of the full open one, mean of both signs and over 5 to 10 Hz.
double loss_dB(const Family& f) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < force_grid().size(); ++i) {
    if (force_grid()[i] >= 5.0 && force_grid()[i] <= 10.0) {
      sum += 0.5 * (control::decibel(f.extending[i]) + control::decibel(f.retracting[i]));
      count += 1.0;
    }
  }
  return magnitude_dB_near(force_grid(), f.shut, 1.0) - sum / count;
}

Result<StudyResult> run_valve(const StudyContext&) {
  const Family f = family();
  double highest = -std::numeric_limits<double>::infinity();
  double highest_above = highest;
  for (std::size_t i = 0; i < force_grid().size(); ++i) {
    const double excess = control::decibel(f.retracting[i]) - control::decibel(f.extending[i]);
    highest = std::max(highest, excess);
    highest_above = force_grid()[i] >= 3.0 ? std::max(highest_above, excess) : highest_above;
  }
  const auto peak = control::resonance<3>(nominal_force(plant::nominal_point(1.0)), 10.0, 1000.0);
  const double peak_Hz = peak ? peak->frequency_Hz : kNaN;
  const double drop = magnitude_dB_near(force_grid(), f.shut, peak_Hz) -
                      std::max(magnitude_dB_near(force_grid(), f.extending, peak_Hz),
                               magnitude_dB_near(force_grid(), f.retracting, peak_Hz));
  StudyResult result;
  result.measured = {{"4.6.negative_is_lower", highest, ""},
                     {"4.6.negative_is_lower_above_3_Hz", highest_above, ""},
                     {"4.6.resonance_is_damped", drop, ""},
                     {"4.6.ten_dB_less", std::abs(loss_dB(f) - 10.0), number_as("it loses %.1f dB", loss_dB(f))}};
  const Curve curves[] = {
      {"shut", f.shut, 1}, {"full open, extending", f.extending, 3}, {"full open, retracting", f.retracting, 2}};
  result.pictures = {
      bode_picture("Load-cell force, valve shut and full open", {bode_panels("force (N/A)", force_grid(), curves)})};
  return result;
}

constexpr const char* kCaptured =
    "... the whole range of transfer functions can be captured by the three (or even two) transfer functions shown "
    "above in figure 4.6.";

constexpr ClaimSpec kPointClaims[] = {
    {"4.7.same_character", "4.3.1",
     "... the fundamental characteristic of the transfer functions remains approximately the same ...",
     "Share of 2400 operating points whose response beyond their resonances, 1 to 3 kHz, falls as the nominal one "
     "does, within 6 dB per decade.",
     "1", Relation::kAtLeast, 0.95},
    {"4.7.damped_more_or_less", "4.3.1",
     "... the resonance peak is damped more or less, depending on the operating point.",
     "Spread of the magnitude at the nominal resonance over the points.", "dB", Relation::kAtLeast, 6.0},
    {"4.7.captured", "4.3.1", kCaptured,
     "Share of all points' magnitudes, 1 to 1000 Hz, within 6 dB of the range that the three of Fig. 4.6 span.", "1",
     Relation::kAtLeast, 0.9}};

/// Per decade, from 1 to 3 kHz.
double slope_dB(const plant::OperatingPoint& point) {
  const control::SingleInOut<3> system = nominal_force(point);
  return (control::decibel(control::response<3>(system, 3000.0)) -
          control::decibel(control::response<3>(system, 1000.0))) /
         std::log10(3.0);
}

Result<StudyResult> run_points(const StudyContext& context) {
  constexpr int kCount = 2400;
  constexpr double kNear_dB = 6.0;
  const auto points = control::operating_points(plant::nominal_cylinder(), kVelocityRange_m_s, kCount, context.seed);
  const auto rows =
      control::responses_at_points(plant::nominal_cylinder(), plant::nominal_load(), points, force_grid());
  const Family f = family();
  const auto peak = control::resonance<3>(nominal_force(plant::nominal_point(1.0)), 10.0, 1000.0);
  const double peak_Hz = peak ? peak->frequency_Hz : kNaN;
  double alike = 0.0, inside = 0.0, all = 0.0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const double nominal_slope = slope_dB(plant::nominal_point(1.0));
  for (const plant::OperatingPoint& point : points) {
    alike += std::abs(slope_dB(point) - nominal_slope) <= kNear_dB ? 1.0 : 0.0;
  }
  for (const Response& row : rows) {
    const double at_peak = magnitude_dB_near(force_grid(), row, peak_Hz);
    low = std::min(low, at_peak);
    high = std::max(high, at_peak);
    for (std::size_t i = 0; i < force_grid().size(); ++i) {
      if (force_grid()[i] >= 1.0) {
        const auto [least, most] = std::minmax(
            {control::decibel(f.shut[i]), control::decibel(f.extending[i]), control::decibel(f.retracting[i])});
        const double value = control::decibel(row[i]);
        inside += value >= least - kNear_dB && value <= most + kNear_dB ? 1.0 : 0.0;
        all += 1.0;
      }
    }
  }
  StudyResult result;
  result.measured = {{"4.7.same_character", alike / kCount, ""},
                     {"4.7.damped_more_or_less", high - low, ""},
                     {"4.7.captured", inside / all, ""}};
  std::vector<Curve> curves;
  constexpr std::size_t kDrawEvery = 24;  // a hundred lines
  for (std::size_t i = 0; i < rows.size(); i += kDrawEvery) {
    curves.push_back({"", rows[i], 5});
  }
  curves.push_back({"nominal", f.shut, 1});
  curves.push_back({"full open, extending", f.extending, 3});
  curves.push_back({"full open, retracting", f.retracting, 2});
  result.pictures = {
      bode_picture("A hundred of 2400 operating points (grey)", {bode_panels("force (N/A)", force_grid(), curves)})};
  return result;
}

constexpr Study kStudies[] = {
    {"4.6", "Load-cell force with the valve shut and full open", kValveClaims, run_valve,
     "Joint of Table A.1, load-cell model (3.51), shut valve and 10 mA. It has no random part."},
    {"4.7", "Load-cell force at 2400 operating points", kPointClaims, run_points,
     "The same joint at 2400 points drawn from the ranges of 4.3.1; the end of a range counts in place of a percentage "
     "of zero."}};

}  // namespace
}  // namespace chapter4_points_studies

std::span<const Study> chapter4_points() { return chapter4_points_studies::kStudies; }

}  // namespace farrier::thesis
