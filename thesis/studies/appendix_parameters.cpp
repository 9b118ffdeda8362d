// Hubacher (2014), Tables A.1 and A.2, Fig. A.1 and 9.3.3: entries that follow from others, and the model that the rig
// was compared with.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "control/model/model_analysis.hpp"
#include "robot/joint_model.hpp"
#include "thesis/rig/bode.hpp"
#include "thesis/rig/nominal_force.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace appendix_parameters_studies {
namespace {

constexpr double kBore_m = 0.016, kRod_m = 0.010, kPipe_m = 0.0038;  // Table A.1
constexpr double kFlow_m3_s = 7.5 / 60000.0, kDrop_Pa = 70e5, kNominal_A = 0.01;
constexpr double kRounding = 1e-3;  // tables have four or five digits

double disk_m2(double diameter_m) { return 0.25 * std::numbers::pi * diameter_m * diameter_m; }

/// Distance of a printed value from the computed one, over the computed one.
double off(double printed, double computed) { return std::abs(printed / computed - 1.0); }

constexpr ClaimSpec kNominalClaims[] = {
    {"A.1.area", "Table A.1", "A_p = pi D_p^2 / 4", "Distance of 2.0106e-4 m^2 from the formula, over it: rounding.",
     "1", Relation::kAtMost, kRounding},
    {"A.1.ring", "Table A.1", "A_r = pi D_p^2 / 4 - pi D_r^2 / 4", "The same of 1.2252e-4 m^2.", "1", Relation::kAtMost,
     kRounding},
    {"A.1.ratio", "Table A.1", "alpha = A_r / A_p", "The same of 0.6094.", "1", Relation::kAtMost, kRounding},
    {"A.1.pipe", "Table A.1", "V_pl = L_pl pi D_pl^2 / 4", "The same of 3.4023e-6 m^3 for 0.3 m.", "1",
     Relation::kAtMost, kRounding},
    {"A.1.valve", "Table A.1", "K_v = sqrt(2) q_n / (u_vn sqrt(dp_n))", "The same of 6.6815e-6.", "1",
     Relation::kAtMost, kRounding},
    {"A.1.spool", "Table A.1",
     "Cut-off frequency of the valve (MOOG data sheet page 14) [250 Hz] ... Valve spool angular frequency [1570 rad/s]",
     "The same of 1570 rad/s from 2 pi 250 Hz.", "1", Relation::kAtMost, kRounding},
    {"A.1.piston", "Table A.1", "m_p = A_p (alpha L_c + 0.15) rho_p", "The same of 0.3141 kg from its own formula.",
     "1", Relation::kAtMost, kRounding},
    {"A.1.piston_by_rod", "Table A.1", "The mass of the piston consists of the piston cylinder and rod ...",
     "The same of 0.3141 kg from the rod's section, (1 - alpha) A_p L_c, in the ring's place.", "1", Relation::kAtMost,
     kRounding,
     Refutation{"the rod's section is (1 - alpha) A_p and the ring's alpha A_p (docs/errata.md): 0.286 kg", 0.05,
                0.15}}};

Result<StudyResult> run_nominal(const StudyContext&) {
  const double area = disk_m2(kBore_m);
  const double ring = area - disk_m2(kRod_m);
  const double ratio = ring / area;
  constexpr double kStroke_m = 0.08, kBody_m = 0.15, kSteel_kg_m3 = 7860.0;
  StudyResult result;
  result.measured = {
      {"A.1.area", off(2.0106e-4, area), ""},
      {"A.1.ring", off(1.2252e-4, ring), ""},
      {"A.1.ratio", off(0.6094, ratio), ""},
      {"A.1.pipe", off(3.4023e-6, 0.3 * disk_m2(kPipe_m)), ""},
      {"A.1.valve", off(6.6815e-6, std::numbers::sqrt2 * kFlow_m3_s / (kNominal_A * std::sqrt(kDrop_Pa))), ""},
      {"A.1.spool", off(1570.0, 2.0 * std::numbers::pi * 250.0), ""},
      {"A.1.piston", off(0.3141, area * (ratio * kStroke_m + kBody_m) * kSteel_kg_m3), ""},
      {"A.1.piston_by_rod", off(0.3141, area * ((1.0 - ratio) * kStroke_m + kBody_m) * kSteel_kg_m3), ""}};
  return result;
}

constexpr ClaimSpec kRigClaims[] = {
    {"A.2.valve", "Table A.2", "K_v = (1/4) sqrt(2) q_n / (u_vn sqrt(dp_n))",
     "Distance of 1.6704e-6 from the formula, over it: rounding.", "1", Relation::kAtMost, kRounding},
    {"A.2.pipe", "Table A.2", "V_pl = L_pl pi D_pl^2 / 4", "The same of 1.0207e-5 m^3 for 0.6 m.", "1",
     Relation::kAtMost, kRounding,
     Refutation{"0.6 m of 3.8 mm line hold 6.8047e-6 m^3; the printed volume is that of 0.9 m (A.2.pipe_of_0_9_m)", 0.4,
                0.6}},
    proof({"A.2.pipe_of_0_9_m", "Table A.2", "V_pl = L_pl pi D_pl^2 / 4", "The same for 0.9 m.", "1", Relation::kAtMost,
           kRounding}),
    {"A.2.cart", "9.3.3", "... registering a total weight of m_l = 2580 gr.",
     "Distance of Table A.2's 2.5 kg from 2.58 kg, over it: a twentieth.", "1", Relation::kAtMost, 0.05},
    {"A.2.heaviest", "9.3.3",
     "... in increments of 5 kg. This brought the total possible weight of the cart up to 22.5 kg.",
     "Distance of 22.5 kg from 2.58 kg and four increments, over it: a hundredth.", "1", Relation::kAtMost, 0.01}};

Result<StudyResult> run_rig(const StudyContext&) {
  constexpr double kCart_kg = 2.58;
  StudyResult result;
  result.measured = {
      {"A.2.valve", off(1.6704e-6, 0.25 * std::numbers::sqrt2 * kFlow_m3_s / (kNominal_A * std::sqrt(kDrop_Pa))), ""},
      {"A.2.pipe", off(1.0207e-5, 0.6 * disk_m2(kPipe_m)), ""},
      {"A.2.pipe_of_0_9_m", off(1.0207e-5, 0.9 * disk_m2(kPipe_m)), ""},
      {"A.2.cart", off(2.5, kCart_kg), ""},
      {"A.2.heaviest", off(22.5, kCart_kg + 4 * 5.0), ""}};
  return result;
}

// Fig. A.1

constexpr ClaimSpec kModelClaims[] = {
    {"A.1.anti_resonance", "9.1.3", "... the anti-resonance around 10 Hz ...",
     "Distance from 10 Hz of the lowest magnitude between 1 and 60 Hz of the model of Table A.2: 5 Hz.", "Hz",
     Relation::kAtMost, 5.0},
    {"A.1.light_resonance", "10.2", "... clearly shows a resonance peak at high frequencies around 200 Hz.",
     "Distance from 200 Hz of the frequency of the poles of (3.51) for the 0.5 kg of Fig. 7.6: 20 Hz.", "Hz",
     Relation::kAtMost, 20.0}};

Result<StudyResult> run_model(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load(context, "fc1d.yaml"));
  const robot::Joint& joint = rig.joints[0];
  const plant::OperatingPoint home{.position = 0.5 * joint.actuator.stroke};
  const auto force_of = [&](double mass_kg) {
    plant::LoadParams load_of = joint.swing_load;
    load_of.mass = mass_kg;
    return control::load_cell_system(joint.actuator, load_of, home, plant::Output::kLoadCellForce);
  };
  const Response model = control::responses<3>(force_of(joint.swing_load.mass), force_grid());
  double lowest = HUGE_VAL, at_Hz = 0.0;
  for (std::size_t i = 0; i < force_grid().size(); ++i) {
    if (force_grid()[i] >= 1.0 && force_grid()[i] <= 60.0 && std::abs(model[i]) < lowest) {
      lowest = std::abs(model[i]);
      at_Hz = force_grid()[i];
    }
  }
  const control::SingleInOut<3> light = force_of(0.5);
  double poles_Hz = 0.0;
  for (const std::complex<double>& pole : control::poles(light)) {
    poles_Hz = std::max(poles_Hz, pole.imag() / (2.0 * std::numbers::pi));
  }
  const auto peak = control::resonance<3>(light, 50.0, 500.0);
  StudyResult result;
  result.measured = {{"A.1.anti_resonance", std::abs(at_Hz - 10.0), number_as("%.1f Hz", at_Hz)},
                     {"A.1.light_resonance", std::abs(poles_Hz - 200.0),
                      number_as("%.0f Hz", poles_Hz) +
                          (peak ? number_as("; the magnitude is highest at %.0f Hz", peak->frequency_Hz) : "")}};
  const Curve curves[] = {{"Tables A.1 and A.2, 2.5 kg", model, 1}};
  result.pictures = {bode_picture("The model's half of Fig. A.1; the measured half is lost",
                                  {bode_panels("force (N/A)", force_grid(), curves)})};
  return result;
}

constexpr Study kStudies[] = {
    {"A.1", "The model that the rig was compared with", kModelClaims, run_model,
     "Model (3.51) of fc1d.yaml, which has Table A.2, at mid-stroke."},
    {"TA.1", "Parameters of the nominal model", kNominalClaims, run_nominal, "Arithmetic on the entries of the table."},
    {"TA.2", "Parameters fitted to the rig", kRigClaims, run_rig, "Arithmetic on the entries of the table."}};

}  // namespace
}  // namespace appendix_parameters_studies

std::span<const Study> appendix_parameters() { return appendix_parameters_studies::kStudies; }

}  // namespace farrier::thesis
