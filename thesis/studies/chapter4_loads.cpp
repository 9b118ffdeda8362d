// Hubacher (2014), Figs 4.8 to 4.10 and A.2: how the load-cell force's transfer function changes with the load.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "control/model/model_analysis.hpp"
#include "thesis/rig/bode.hpp"
#include "thesis/rig/nominal_force.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace chapter4_loads_studies {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPeriod_s = 0.001;

using control::LoadParameter;

/// Responses over a range of one parameter of the load, drawn black to yellow with the nominal one in blue.
struct Sweep {
  std::vector<double> values;
  std::vector<Response> rows;
  Response nominal;

  /// Largest less smallest magnitude at a frequency, dB.
  double spread_dB(double frequency_Hz) const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Response& row : rows) {
      low = std::min(low, magnitude_dB_near(force_grid(), row, frequency_Hz));
      high = std::max(high, magnitude_dB_near(force_grid(), row, frequency_Hz));
    }
    return high - low;
  }
  Picture picture(const std::string& caption) const {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      curves.push_back({"", rows[i], 0, static_cast<double>(i) / static_cast<double>(rows.size() - 1)});
    }
    curves.push_back({"nominal", nominal, 1});
    return bode_picture(caption, {bode_panels("force (N/A)", force_grid(), curves)});
  }
};

Sweep sweep(LoadParameter parameter, std::vector<double> values) {
  const plant::OperatingPoint point = plant::nominal_point(1.0);
  auto rows = control::responses_to_load(plant::nominal_cylinder(), plant::nominal_load(), point, parameter, values,
                                         force_grid());
  return {std::move(values), std::move(rows), control::responses<3>(nominal_force(point), force_grid())};
}

/// Resonance with one parameter of the load at a value; NaN where there is none.
control::Resonance resonance_at(LoadParameter parameter, double value) {
  const auto found = control::resonance<3>(
      nominal_force(plant::nominal_point(1.0), control::with(plant::nominal_load(), parameter, value)), 10.0, 2000.0);
  return found ? *found : control::Resonance{kNaN, kNaN};
}

constexpr const char* kPeaks =
    "The resonance peak frequency is shifted from ~38 Hz for heavy mass up to 500 Hz for light mass.";
constexpr const char* kHeights =
    "... the magnitude of the response is altered from 160 dB for heavy mass down to 115 dB for very light mass.";

constexpr ClaimSpec kMassClaims[] = {
    {"4.8.heavy_resonance", "4.3.2", kPeaks, "Distance of the resonance at 127 kg from 38 Hz: a tenth of it.", "Hz",
     Relation::kAtMost, 3.8},
    {"4.8.light_resonance", "4.3.2", kPeaks, "Distance of the resonance at 1 kg from 500 Hz: a tenth of it.", "Hz",
     Relation::kAtMost, 50.0,
     Refutation{"an undamped resonance goes with one over the root of the mass: the text's own 38 Hz at 127 kg make "
                "374 Hz at 1 kg, the piston's 0.3 kg "
                "counted",
                110.0, 150.0}},
    {"4.8.heavy_magnitude", "4.3.2", kHeights, "Distance of the height of the resonance at 127 kg from 160 dB (N/A).",
     "dB", Relation::kAtMost, 5.0},
    {"4.8.light_magnitude", "4.3.2", kHeights, "Distance of the height of the resonance at 1 kg from 115 dB (N/A).",
     "dB", Relation::kAtMost, 5.0}};

std::string resonance_text(const control::Resonance& r) {
  return std::to_string(r.frequency_Hz) + " Hz, " + std::to_string(20.0 * std::log10(r.magnitude)) + " dB";
}

Result<StudyResult> run_mass(const StudyContext&) {
  const Sweep s = sweep(LoadParameter::kMass, log_space(control::kMassRange_kg.low, control::kMassRange_kg.high, 40));
  const control::Resonance heavy = resonance_at(LoadParameter::kMass, control::kMassRange_kg.high);
  const control::Resonance light = resonance_at(LoadParameter::kMass, control::kMassRange_kg.low);
  StudyResult result;
  result.measured = {
      {"4.8.heavy_resonance", std::abs(heavy.frequency_Hz - 38.0), resonance_text(heavy)},
      {"4.8.light_resonance", std::abs(light.frequency_Hz - 500.0), resonance_text(light)},
      {"4.8.heavy_magnitude", std::abs(20.0 * std::log10(heavy.magnitude) - 160.0), resonance_text(heavy)},
      {"4.8.light_magnitude", std::abs(20.0 * std::log10(light.magnitude) - 115.0), resonance_text(light)}};
  result.pictures = {s.picture("Load mass 1 kg (black) to 127 kg (yellow)")};
  return result;
}

constexpr const char* kFriction =
    "... the changes in friction coefficient mainly dampen the low frequency content of the system and only dampen the "
    "resonance peak slightly.";

constexpr ClaimSpec kFrictionClaims[] = {
    {"4.9.low_frequencies", "Fig. 4.9", kFriction,
     "Spread of the magnitude over all frictions, the largest below 50 Hz.", "dB", Relation::kAtLeast, 6.0},
    {"4.9.resonance_less", "Fig. 4.9", kFriction,
     "Spread at the nominal resonance over the largest below 50 Hz: a half. The text gives no number for \"slightly\".",
     "1", Relation::kAtMost, 0.5}};

double largest_spread_below(const Sweep& s, double limit_Hz) {
  double largest = 0.0;
  for (const double f : force_grid()) {
    largest = f < limit_Hz ? std::max(largest, s.spread_dB(f)) : largest;
  }
  return largest;
}

Result<StudyResult> run_friction(const StudyContext&) {
  const Sweep s = sweep(LoadParameter::kDamping,
                        linear_space(control::kDampingRange_Ns_m.low, control::kDampingRange_Ns_m.high, 41));
  const double peak_Hz = resonance_at(LoadParameter::kDamping, plant::nominal_load().damping).frequency_Hz;
  const double low = largest_spread_below(s, 50.0);
  StudyResult result;
  result.measured = {{"4.9.low_frequencies", low, ""},
                     {"4.9.resonance_less", s.spread_dB(peak_Hz) / low,
                      "at the resonance " + std::to_string(s.spread_dB(peak_Hz)) + " dB"}};
  result.pictures = {s.picture("Friction 0 (black) to 2000 Ns/m (yellow)")};
  return result;
}

constexpr const char* kStiffness =
    "The changes in spring stiffness mainly affect the low frequency content of the system and leave the resonance "
    "peak unchanged.";

constexpr ClaimSpec kStiffnessClaims[] = {
    {"A.2.low_frequencies", "Fig. A.2", kStiffness,
     "Spread of the magnitude over all stiffnesses, the largest below 50 Hz.", "dB", Relation::kAtLeast, 6.0},
    {"A.2.resonance_height", "Fig. A.2", kStiffness, "Spread at the nominal resonance.", "dB", Relation::kAtMost, 1.0},
    {"A.2.resonance_frequency", "Fig. A.2", kStiffness,
     "Change of the resonance from the least to the largest stiffness, over it.", "1", Relation::kAtMost, 0.05}};

Result<StudyResult> run_stiffness(const StudyContext&) {
  const Sweep s = sweep(LoadParameter::kStiffness,
                        log_space(control::kStiffnessRange_N_m.low, control::kStiffnessRange_N_m.high, 40));
  const double soft_Hz = resonance_at(LoadParameter::kStiffness, control::kStiffnessRange_N_m.low).frequency_Hz;
  const double stiff_Hz = resonance_at(LoadParameter::kStiffness, control::kStiffnessRange_N_m.high).frequency_Hz;
  StudyResult result;
  result.measured = {
      {"A.2.low_frequencies", largest_spread_below(s, 50.0), ""},
      {"A.2.resonance_height",
       s.spread_dB(resonance_at(LoadParameter::kStiffness, plant::nominal_load().stiffness).frequency_Hz), ""},
      {"A.2.resonance_frequency", std::abs(stiff_Hz / soft_Hz - 1.0), ""}};
  result.pictures = {s.picture("Spring stiffness 10 (black) to 35000 N/m (yellow)")};
  return result;
}

constexpr ClaimSpec kLociClaims[] = {
    {"4.10.friction_pulls_inward", "4.3.2",
     "... increasing the friction coefficient effectively pulls the poles closer to the origin ...",
     "Share of steps to a larger friction over which every pole comes closer to the origin: all.", "1",
     Relation::kAtLeast, 1.0,
     Refutation{"one of the three poles stays at z = 1 whatever the load, because C k_1 + A_p k_2 = 0 at the nominal "
                "point",
                0.0, 0.0}},
    {"4.10.friction_damps_the_pair", "4.3.2",
     "... increasing the friction coefficient effectively pulls the poles closer to the origin ...",
     "The same of the complex pair alone, where there is one before and after the step.", "1", Relation::kAtLeast, 1.0},
    {"4.10.mass_pushes_outward", "4.3.2", "Increasing mass shifts the poles closer to the edge of the unit circle ...",
     "Share of steps to a larger mass over which the complex pair comes closer to it, where there is one before and "
     "after.",
     "1", Relation::kAtLeast, 1.0},
    fails("the masses and frictions of 4.3.2 from end to end, (3.51) as printed but for its row 2; other masses were "
          "not tried, "
          "and the bound, two thirds of the half disc, stays as it was chosen",
          {"4.10.across_the_disc", "4.3.2", "The changes in mass ... getting shifted almost all across the unit disc.",
           "Range of the angles of complex poles above the real axis: 120 degrees or more.", "deg", Relation::kAtLeast,
           120.0})};

/// The modulus of the pair; NaN where all poles are real.
double pair_modulus(const control::PolesOfLoad& load) {
  for (const std::complex<double> z : load.poles) {
    if (z.imag() > 1e-9) {
      return std::abs(z);
    }
  }
  return kNaN;
}

/// True if every pole of `after` is closer to the origin than its counterpart of `before`, by rank of modulus.
bool all_closer(const control::PolesOfLoad& before, const control::PolesOfLoad& after) {
  const auto moduli = [](const control::PolesOfLoad& load) {
    std::vector<double> values;
    for (const std::complex<double> z : load.poles) {
      values.push_back(std::abs(z));
    }
    std::ranges::sort(values);
    return values;
  };
  constexpr double kRounding = 1e-9;
  return std::ranges::equal(moduli(before), moduli(after), [](double b, double a) { return a < b - kRounding; });
}

/// Counts of steps, and of those that do as they should.
struct Steps {
  double done = 0.0, all = 0.0;
  void count(bool counts, bool does) {
    all += counts ? 1.0 : 0.0;
    done += counts && does ? 1.0 : 0.0;
  }
  double share() const { return done / all; }
};

Result<StudyResult> run_loci(const StudyContext&) {
  const std::vector<double> masses = log_space(control::kMassRange_kg.low, control::kMassRange_kg.high, 25);
  const std::vector<double> frictions =
      linear_space(control::kDampingRange_Ns_m.low, control::kDampingRange_Ns_m.high, 21);
  const auto loci = control::pole_loci(plant::nominal_cylinder(), plant::nominal_load(), plant::nominal_point(1.0),
                                       masses, frictions, kPeriod_s);
  const auto at = [&](std::size_t mass, std::size_t friction) -> const control::PolesOfLoad& {
    return loci[mass * frictions.size() + friction];
  };
  const auto both = [](double a, double b) { return std::isfinite(a) && std::isfinite(b); };
  Steps inward, pair_inward, outward;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    for (std::size_t j = 0; j < frictions.size(); ++j) {
      const double here = pair_modulus(at(i, j));
      if (j + 1 < frictions.size()) {
        const double next = pair_modulus(at(i, j + 1));
        inward.count(true, all_closer(at(i, j), at(i, j + 1)));
        pair_inward.count(both(here, next), next < here);
      }
      if (i + 1 < masses.size()) {
        const double next = pair_modulus(at(i + 1, j));
        outward.count(both(here, next), next > here);
      }
    }
  }
  double least = 180.0, most = 0.0;
  Series by_mass{"", {}, {}, Style::kPoints, 0};
  Series by_friction = by_mass;
  for (const control::PolesOfLoad& one : loci) {
    for (const std::complex<double> z : one.poles) {
      const double angle = std::arg(z) * 180.0 / std::numbers::pi;
      if (z.imag() > 1e-9) {
        least = std::min(least, angle);
        most = std::max(most, angle);
      }
      for (Series* series : {&by_mass, &by_friction}) {
        series->x.push_back(z.real());
        series->y.push_back(z.imag());
      }
      by_mass.shade.push_back(std::log(one.mass / masses.front()) / std::log(masses.back() / masses.front()));
      by_friction.shade.push_back(one.damping / frictions.back());
    }
  }
  StudyResult result;
  result.measured = {{"4.10.friction_pulls_inward", inward.share(), ""},
                     {"4.10.friction_damps_the_pair", pair_inward.share(), ""},
                     {"4.10.mass_pushes_outward", outward.share(), ""},
                     {"4.10.across_the_disc", most - least, ""}};
  result.pictures = {{"Poles sampled at 1 ms, masses and frictions of 4.3.2",
                      2,
                      {{.title = "colour: mass",
                        .x_label = "Re z",
                        .y_label = "Im z",
                        .unit_circle = true,
                        .series = {std::move(by_mass)}},
                       {.title = "colour: friction",
                        .x_label = "Re z",
                        .y_label = "Im z",
                        .unit_circle = true,
                        .series = {std::move(by_friction)}}}}};
  return result;
}

constexpr const char* kConditions =
    "Joint of Table A.1 at the nominal point; load-cell model (3.51) with the piston's mass in its row 2. Ranges of "
    "4.3.2. "
    "It has no random part.";

constexpr Study kStudies[] = {
    {"4.8", "Load-cell force over the load's mass", kMassClaims, run_mass, kConditions},
    {"4.9", "Load-cell force over the load's friction", kFrictionClaims, run_friction, kConditions},
    {"4.10", "Poles over mass and friction", kLociClaims, run_loci, kConditions},
    {"A.2", "Load-cell force over the spring's stiffness", kStiffnessClaims, run_stiffness, kConditions}};

}  // namespace
}  // namespace chapter4_loads_studies

std::span<const Study> chapter4_loads() { return chapter4_loads_studies::kStudies; }

}  // namespace farrier::thesis
