// Hubacher (2014), 4.3: sentences about the operating point and the load that no figure shows.

#include <algorithm>
#include <cmath>
#include <complex>

#include "control/model/model_analysis.hpp"
#include "thesis/rig/bode.hpp"
#include "thesis/rig/nominal_force.hpp"
#include "thesis/studies/registry.hpp"
#include "thesis/study/mean.hpp"

namespace farrier::thesis {
namespace section4_sensitivity_studies {
namespace {

constexpr std::size_t kSteps = 9;
constexpr double kVelocityRange_m_s = 1.2;  // (3.9)
constexpr double kPeriod_s = 1e-3;

constexpr ClaimSpec kClaims[] = {
    {"S4.3.opening_most", "4.3.1",
     "... varying the operating point of the valve results in the most dramatic change. The individual influence of "
     "the other three "
     "operating points is smaller.",
     "Largest spread of the magnitude, 1 to 1000 Hz, over the valve's full range less that over the position's, the "
     "velocity's and the "
     "load pressure's, the largest: above 0.",
     "dB", Relation::kAtLeast, 0.5},
    {"S4.3.stiffness_less", "4.3.2", "Variations in the spring stiffness, shown in figure A.2, are even less severe.",
     "Mean spread of the magnitude in dB, 1 to 1000 Hz, over the stiffness's range over that over the friction's: "
     "below 1.",
     "1", Relation::kBelow, 1.0},
    {"S4.3.zeros", "4.3.2", "... since the location of zeros is only slightly affected.",
     "Largest way of a zero in the z-plane over the ranges of mass and friction, over that of a pole: a quarter.", "1",
     Relation::kAtMost, 0.25,
     Refutation{"the zeros of (4.1) are the roots of m_l s^2 + d_l s + C: with 1 kg and 2000 Ns/m one lies at s = "
                "-2000 / s, which is z = 0.14, "
                "with 127 kg both lie by z = 1",
                0.6, 1.2}}};

/// Spreads of the magnitude over a family of responses, at each frequency from 1 Hz on.
std::vector<double> spreads_dB(const std::vector<Response>& family) {
  std::vector<double> spreads;
  for (std::size_t i = 0; i < force_grid().size(); ++i) {
    if (force_grid()[i] < 1.0) {
      continue;
    }
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Response& response : family) {
      const double value = control::decibel(response[i]);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    spreads.push_back(high - low);
  }
  return spreads;
}

/// Responses with one value of the operating point varied over its range.
std::vector<Response> family_of(double plant::OperatingPoint::*value, double low, double high) {
  std::vector<Response> family;
  for (const double at : linear_space(low, high, kSteps)) {
    plant::OperatingPoint point = plant::nominal_point(0.0);
    point.*value = at;
    if (value == &plant::OperatingPoint::valve_current_A) {
      point.valve_sign = at < 0.0 ? -1.0 : 1.0;
    }
    family.push_back(control::responses<3>(nominal_force(point), force_grid()));
  }
  return family;
}

std::vector<Response> family_of(control::LoadParameter parameter, control::Range range) {
  return control::responses_to_load(plant::nominal_cylinder(), plant::nominal_load(), plant::nominal_point(1.0),
                                    parameter, linear_space(range.low, range.high, kSteps), force_grid());
}

/// Largest distance of any of a load's poles or zeros from the nearest of the nominal load.
double way(const control::SmallSpectrum& values, const control::SmallSpectrum& nominal) {
  double largest = 0.0;
  for (const std::complex<double>& value : values) {
    largest = std::max(largest, (nominal.array() - value).abs().minCoeff());
  }
  return largest;
}

Result<StudyResult> run(const StudyContext&) {
  const plant::ActuatorParams cylinder = plant::nominal_cylinder();
  const auto largest = [](const std::vector<Response>& family) { return std::ranges::max(spreads_dB(family)); };
  using Point = plant::OperatingPoint;
  const double pressure = cylinder.area_b / cylinder.area_a * cylinder.supply_pressure_Pa;
  const std::vector<Response> openings =
      family_of(&Point::valve_current_A, -cylinder.valve_current_max_A, cylinder.valve_current_max_A);
  const double opening = largest(openings);
  const double position = largest(family_of(&Point::position, 0.05 * cylinder.stroke, 0.95 * cylinder.stroke));
  const double velocity = largest(family_of(&Point::velocity, -0.9 * kVelocityRange_m_s, 0.9 * kVelocityRange_m_s));
  const double load_pressure = largest(family_of(&Point::load_pressure_Pa, -0.9 * pressure, 0.9 * pressure));
  const auto stiffness = family_of(control::LoadParameter::kStiffness, control::kStiffnessRange_N_m);
  const auto friction = family_of(control::LoadParameter::kDamping, control::kDampingRange_Ns_m);
  const auto sampled_of = [&](double mass, double damping) {
    plant::LoadParams load = plant::nominal_load();
    load.mass = mass;
    load.damping = damping;
    return control::sampled(nominal_force(plant::nominal_point(1.0), load), kPeriod_s);
  };
  const auto nominal = sampled_of(plant::nominal_load().mass, plant::nominal_load().damping);
  double zeros = 0.0, poles = 0.0;
  for (const double mass : log_space(control::kMassRange_kg.low, control::kMassRange_kg.high, kSteps)) {
    for (const double damping :
         linear_space(control::kDampingRange_Ns_m.low, control::kDampingRange_Ns_m.high, kSteps)) {
      const auto system = sampled_of(mass, damping);
      zeros = std::max(zeros, way(control::zeros(system), control::zeros(nominal)));
      poles = std::max(poles, way(control::poles(system), control::poles(nominal)));
    }
  }
  StudyResult result;
  result.measured = {
      {"S4.3.opening_most", opening - std::max({position, velocity, load_pressure}),
       number_as("opening %.1f, ", opening) + number_as("position %.1f, ", position) +
           number_as("velocity %.1f, ", velocity) + number_as("load pressure %.1f dB", load_pressure)},
      {"S4.3.stiffness_less", mean(spreads_dB(stiffness)) / mean(spreads_dB(friction)),
       number_as("%.2f dB, ", mean(spreads_dB(stiffness))) + number_as("%.2f dB", mean(spreads_dB(friction)))},
      {"S4.3.zeros", zeros / poles, number_as("zeros %.2f, ", zeros) + number_as("poles %.2f", poles)}};
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < openings.size(); ++i) {
    curves.push_back({"", openings[i], 0, static_cast<double>(i) / static_cast<double>(openings.size())});
  }
  result.pictures = {
      bode_picture("Load-cell force over the valve's opening, full negative (black) to full positive (yellow)",
                   {bode_panels("force (N/A)", force_grid(), curves)})};
  return result;
}

constexpr Study kStudies[] = {{"S4.3", "Operating point, stiffness and zeros", kClaims, run,
                               "Model (3.51) of Table A.1, continuous; zeros and poles sampled with 1 ms."}};

}  // namespace
}  // namespace section4_sensitivity_studies

std::span<const Study> section4_sensitivity() { return section4_sensitivity_studies::kStudies; }

}  // namespace farrier::thesis
