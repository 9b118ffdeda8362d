// Hubacher (2014), Fig. 4.1: the nonlinear joint of Table A.1 against its three linear models after a small step.

#include <algorithm>
#include <cmath>

#include "control/model/model_analysis.hpp"
#include "thesis/studies/registry.hpp"
#include "thesis/study/mean.hpp"
#include "plant/hydraulic_joint.hpp"
#include "plant/nominal.hpp"

namespace farrier::thesis {
namespace chapter4_step_studies {
namespace {

constexpr double kPeriod_s = 1e-4;  // fine enough to show the resonance; the input is constant over it
constexpr double kOn_s = 0.001;
constexpr double kOff_s = 0.05;
constexpr double kEnd_s = 0.1;
constexpr double kShare = 0.01;  // of the nominal valve opening

double current_A(double t) {
  return t >= kOn_s && t < kOff_s ? kShare * plant::nominal_cylinder().valve_current_max_A : 0.0;
}

/// Deviations from the operating point, a value a period.
struct Track {
  std::vector<double> force_N, position_m, pressure_a_Pa, load_pressure_Pa;
};

std::vector<double> times() {
  std::vector<double> values;
  for (double t = 0.0; t < kEnd_s; t += kPeriod_s) {
    values.push_back(t);
  }
  return values;
}

Result<Track> simulate() {
  const plant::ActuatorParams cylinder = plant::nominal_cylinder();
  const plant::State start = plant::nominal_chamber_point(1.0).state;
  auto joint = FARRIER_TRY(plant::HydraulicJoint::create(cylinder, plant::nominal_load(), start));
  const double alpha = cylinder.area_b / cylinder.area_a;
  Track track;
  for (const double t : times()) {
    const plant::State& s = joint.state();
    track.force_N.push_back(joint.load_cell_force());
    track.position_m.push_back(s.position - start.position);
    track.pressure_a_Pa.push_back(s.pressure_a_Pa - start.pressure_a_Pa);
    track.load_pressure_Pa.push_back(s.pressure_a_Pa - alpha * s.pressure_b_Pa);
    joint.step(current_A(t), 0.0, kPeriod_s);
  }
  return track;
}

/// Output of a sampled linear model, rows of `c` for force, position and load pressure; the pressure of chamber a where
/// it is a state.
template <int N>
Track respond(const plant::StateSpace<N>& model, const Eigen::Matrix<double, 1, N>& force,
              const Eigen::Matrix<double, 1, N>& load_pressure, int pressure_a_state) {
  const control::SingleInOut<N> system = control::sampled<N>({model.a, model.b, force}, kPeriod_s);
  Eigen::Matrix<double, N, 1> x = Eigen::Matrix<double, N, 1>::Zero();
  Track track;
  for (const double t : times()) {
    track.force_N.push_back(force * x);
    track.position_m.push_back(x(0));
    track.load_pressure_Pa.push_back(load_pressure * x);
    if (pressure_a_state >= 0) {
      track.pressure_a_Pa.push_back(x(pressure_a_state));
    }
    x = system.a * x + system.b * current_A(t);
  }
  return track;
}

double rms(const std::vector<double>& values, std::size_t from = 0) {
  double sum = 0.0;
  for (std::size_t i = from; i < values.size(); ++i) {
    sum += values[i] * values[i];
  }
  return std::sqrt(sum / static_cast<double>(values.size() - from));
}

double relative_error(const std::vector<double>& model, const std::vector<double>& truth) {
  std::vector<double> error(truth.size());
  std::ranges::transform(model, truth, error.begin(), std::minus<>());
  return rms(error) / rms(truth);
}

/// RMS of the oscillation that remains half of the time after the valve has shut.
double ringing(const std::vector<double>& force_N) {
  const std::size_t from = force_N.size() * 3 / 4;
  std::vector<double> rest(force_N.begin() + static_cast<std::ptrdiff_t>(from), force_N.end());
  std::ranges::for_each(rest, [middle = mean(rest)](double& f) { f -= middle; });
  return rms(rest);
}

constexpr const char* kForce =
    "... all linear models are able to accurately reproduce the force compared to the response of the nonlinear model.";
constexpr const char* kLoadPressure =
    "... where the load pressure ... is shown, the response of all three systems is again nearly identical.";

constexpr ClaimSpec kClaims[] = {
    {"4.1.force_full", "4.1", kForce, "RMS error over RMS of the force, full model: a tenth.", "1", Relation::kAtMost,
     0.1},
    {"4.1.force_load_pressure", "4.1", kForce, "The same, load-pressure model.", "1", Relation::kAtMost, 0.1},
    {"4.1.force_load_cell", "4.1", kForce, "The same, load-cell model.", "1", Relation::kAtMost, 0.1},
    {"4.1.ringing", "4.1",
     "The force response of the linear models seems to be less damped than the nonlinear response.",
     "RMS of the oscillation left over the last quarter of the time, full model over nonlinear.", "1",
     Relation::kAtLeast, 1.0},
    {"4.1.position_full", "4.1", "The full model almost exactly reproduces the position signal ...",
     "RMS error over RMS of the position: a twentieth.", "1", Relation::kAtMost, 0.05},
    {"4.1.position_simplified", "4.1", "... while the two simplified models do not fully reproduce the position.",
     "Position error of the better simplified model over that of the full one: twice or more.", "1", Relation::kAtLeast,
     2.0},
    {"4.1.simplified_alike", "4.1", "However, these two models are almost indistinguishable.",
     "RMS difference of their positions over RMS: a fiftieth.", "1", Relation::kAtMost, 0.02},
    {"4.1.pressure_offset", "4.1",
     "... is not able to reproduce the whole pressure dynamics existing in the chambers and a pressure offset results.",
     "Error of the full model's pressure in chamber a at the end, over the largest deviation it has: a tenth or more.",
     "1", Relation::kAtLeast, 0.1},
    {"4.1.load_pressure_full", "4.1", kLoadPressure, "RMS error over RMS of the load pressure, full model: a tenth.",
     "1", Relation::kAtMost, 0.1},
    {"4.1.load_pressure_simple", "4.1", kLoadPressure, "The same, load-pressure model.", "1", Relation::kAtMost, 0.1},
    {"4.1.load_pressure_load_cell", "4.1", kLoadPressure, "The same, load-cell model.", "1", Relation::kAtMost, 0.1}};

Result<StudyResult> run_step(const StudyContext&) {
  const auto made = FARRIER_TRY(simulate());
  const Track& truth = made;
  const plant::ActuatorParams cylinder = plant::nominal_cylinder();
  const plant::LoadParams load = plant::nominal_load();
  const double alpha = cylinder.area_b / cylinder.area_a;
  const plant::OperatingPoint point = plant::nominal_point(1.0);
  using plant::Output;
  const Track full = respond<4>(plant::linearise_full(cylinder, load, plant::nominal_chamber_point(1.0)),
                                plant::full_output(Output::kLoadCellForceWithInertia, cylinder, load),
                                Eigen::RowVector4d(0.0, 0.0, 1.0, -alpha), 2);
  const Track simple = respond<3>(plant::linearise_load_pressure(cylinder, load, point),
                                  plant::load_pressure_output(Output::kLoadCellForceWithInertia, cylinder, load),
                                  Eigen::RowVector3d(0.0, 0.0, 1.0), -1);
  // p_l = (F_s + d_p v) / A_p, (3.3)
  const Track cell =
      respond<3>(plant::linearise_load_cell_force(cylinder, load, point), Eigen::RowVector3d(0.0, 0.0, 1.0),
                 Eigen::RowVector3d(0.0, cylinder.piston_damping, 1.0) / cylinder.area_a, -1);

  const double full_error = relative_error(full.position_m, truth.position_m);
  const double simple_error = relative_error(simple.position_m, truth.position_m);
  const double cell_error = relative_error(cell.position_m, truth.position_m);
  double largest_Pa = 0.0;
  for (const double p : truth.pressure_a_Pa) {
    largest_Pa = std::max(largest_Pa, std::abs(p));
  }
  StudyResult result;
  result.measured = {
      {"4.1.force_full", relative_error(full.force_N, truth.force_N), ""},
      {"4.1.force_load_pressure", relative_error(simple.force_N, truth.force_N), ""},
      {"4.1.force_load_cell", relative_error(cell.force_N, truth.force_N), ""},
      {"4.1.ringing", ringing(full.force_N) / ringing(truth.force_N), ""},
      {"4.1.position_full", full_error, ""},
      {"4.1.position_simplified", std::min(simple_error, cell_error) / full_error, ""},
      {"4.1.simplified_alike", relative_error(cell.position_m, simple.position_m), ""},
      {"4.1.pressure_offset", std::abs(full.pressure_a_Pa.back() - truth.pressure_a_Pa.back()) / largest_Pa, ""},
      {"4.1.load_pressure_full", relative_error(full.load_pressure_Pa, truth.load_pressure_Pa), ""},
      {"4.1.load_pressure_simple", relative_error(simple.load_pressure_Pa, truth.load_pressure_Pa), ""},
      {"4.1.load_pressure_load_cell", relative_error(cell.load_pressure_Pa, truth.load_pressure_Pa), ""}};
  const std::vector<double> t = times();
  const auto panel = [&](const char* label, std::vector<double> Track::*member, double per_unit) {
    Panel one{.title = "", .x_label = "time (s)", .y_label = label};
    const Track* const tracks[] = {&truth, &full, &simple, &cell};
    constexpr const char* kNames[] = {"nonlinear", "full", "load pressure", "load cell"};
    for (std::size_t i = 0; i < std::size(tracks); ++i) {
      std::vector<double> values = tracks[i]->*member;
      if (!values.empty()) {
        std::ranges::for_each(values, [&](double& value) { value *= per_unit; });
        one.series.push_back(
            {kNames[i], t, std::move(values), i == 0 ? Style::kLine : Style::kDashed, static_cast<int>(i)});
      }
    }
    return one;
  };
  result.pictures = {
      {"Valve 1 % open from 0.001 s to 0.05 s; deviations from the operating point",
       2,
       {panel("load-cell force (N)", &Track::force_N, 1.0), panel("position (mm)", &Track::position_m, 1e3),
        panel("pressure a (bar)", &Track::pressure_a_Pa, 1e-5),
        panel("load pressure (bar)", &Track::load_pressure_Pa, 1e-5)}}};
  return result;
}

constexpr Study kStudies[] = {
    {"4.1", "Nonlinear joint and three linear models after a step", kClaims, run_step,
     "Joint of Table A.1 at the nominal point, without friction and spool. The load-cell model is (3.51): the piston's "
     "mass is in its row 2 alone. It has no random part."}};

}  // namespace
}  // namespace chapter4_step_studies

std::span<const Study> chapter4_step() { return chapter4_step_studies::kStudies; }

}  // namespace farrier::thesis
