// Hubacher (2014), 10.2 and 10.3: what filtering the velocity costs the loop in margin and tracking, and what
// oversampling would give back. The study the text asks for.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "control/design/margins.hpp"
#include "robot/joint_model.hpp"
#include "robot/sensor_path.hpp"
#include "thesis/rig/filter_study.hpp"
#include "thesis/studies/registry.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::thesis {
namespace chapter10_studies {
namespace {

constexpr double kLength_s = 2.0;
constexpr double kRigFilter_Hz = 100.0;
constexpr double kAggressive_Hz = 50.0;
constexpr int kOrder = 2;

constexpr const char* kRobustness =
    "Because the state measurement signals were then filtered differently, the different phase delays reduced the "
    "robustness of the LQR drastically.";

constexpr ClaimSpec kClaims[] = {
    {"10.2.margin_lost", "10.2", kRobustness,
     "Disk margin with the force alone filtered at 100 Hz over that without filters, 2.5 kg, full state, xi = 14 of "
     "fc1d.yaml: at most a tenth.",
     "1", Relation::kAtMost, 0.1},
    {"10.2.margin_lost_thesis", "10.2", kRobustness,
     "The same with the xi = 6 of (7.11) and the filters of fc1d_real.yaml, 20 Hz on position and velocity, 100 Hz on "
     "the force: at most half.",
     "1", Relation::kAtMost, 0.5},
    {"10.2.alike", "10.2", kRobustness,
     "\"Differently\": the disk margin with position, velocity and force filtered alike at 100 Hz less that with the "
     "force alone, xi = 14, over that without filters: a quarter or more.",
     "1", Relation::kAtLeast, 0.25},
    proof({"10.2.alike_at_50", "10.2", kRobustness,
           "Disk margin with all three filtered alike at 50 Hz over that without, xi = 14: at most half.", "1",
           Relation::kAtMost, 0.5}),
    proof(
        {"10.2.velocity_alone", "10.2", kRobustness,
         "Disk margin with the velocity alone filtered at 100 Hz over that without, xi = 14: 0.8 or more, the gain on "
         "the force being the largest.",
         "1", Relation::kAtLeast, 0.8}),
    {"10.2.phase_margin_lost", "10.2, footnote 6",
     "The phase delay of the measurement essentially 'eats' up the phase margin of the LQR controller ...",
     "Phase margin with the velocity filtered at 50 Hz less that without, 2.5 kg, xi = 14: a degree less, at least.",
     "deg", Relation::kAtMost, -1.0},
    {"10.2.tracking_lost", "10.2",
     "... the filtering of the measurement signals has quite a high impact on the robustness and tracking capabilities "
     "of the LQR controller.",
     "Tracking error with the velocity filtered at 50 Hz over that without, the rig's own load: at least a quarter "
     "more.",
     "1", Relation::kAtLeast, 1.25},
    {"10.2.oversampling", "10.3",
     "Possible improvements may consist of adding an (analog) anti-aliasing filter before sampling the signals and to "
     "use oversampling ...",
     "Tracking error with eight conversions a tick behind 1.5 kHz over that with one, velocity not filtered, 50 kg: "
     "less.",
     "1", Relation::kBelow, 1.0}};

/// A run with the margins of its loop, the velocity filter inside. Conversions and the analog filter of an oversampled
/// sensor are not in them.
struct Row {
  thesis::FilterRow run;
  control::Margins margins;
};

const Row* find(const std::vector<Row>& rows, double cut_off_Hz, bool oversampled, double mass_kg) {
  const auto found = std::ranges::find_if(rows, [&](const Row& row) {
    const thesis::FilterCase& filter = row.run.filter;
    return filter.velocity_cut_off_Hz == cut_off_Hz && filter.oversampled == oversampled &&
           (cut_off_Hz == 0.0 || filter.order == kOrder) && row.run.load_mass_kg == mass_kg;
  });
  return found == rows.end() ? nullptr : &*found;
}

Result<std::vector<Row>> rows_of(const StudyContext& context, const robot::Robot& rig) {
  std::vector<Row> rows;
  const std::vector<thesis::FilterCase> cases = thesis::filter_cases();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!keep_going(context, static_cast<double>(i) / static_cast<double>(cases.size()))) {
      return stopped();
    }
    auto ran = FARRIER_TRY(thesis::filter_study(rig, {cases[i]}, kLength_s, context.seed));
    for (const thesis::FilterRow& run : ran) {
      const control::Gains gains = wire_gains::unpack_gains(run.gains);
      control::MeasurementFilters filters;
      filters.velocity = control::measurement_filter(run.velocity_filter);
      rows.push_back({run, control::margins(gains.model, gains, gains.delay_ticks, filters)});
    }
  }
  return rows;
}

Panel panel(const std::vector<Row>& rows, const std::string& title, const std::string& y_label,
            const std::vector<double>& masses, bool both, double (*value)(const Row&)) {
  Panel panel{title, "cut-off (Hz); 1000: none", y_label, true, false, false, {}};
  int colour = 1;
  for (const double mass : masses) {
    for (const bool oversampled : {false, true}) {
      if (oversampled && !both) {
        continue;
      }
      Series series{std::to_string(mass).substr(0, mass < 10.0 ? 3 : 2) + " kg" + (oversampled ? ", oversampled" : ""),
                    {},
                    {},
                    oversampled ? Style::kDashed : Style::kLine,
                    colour};
      for (const double cut_off_Hz : {50.0, 100.0, 200.0, 400.0, 0.0}) {
        if (const Row* row = find(rows, cut_off_Hz, oversampled, mass); row != nullptr) {
          series.x.push_back(cut_off_Hz > 0.0 ? cut_off_Hz : 1000.0);
          series.y.push_back(value(*row));
        }
      }
      panel.series.push_back(std::move(series));
    }
    ++colour;
  }
  return panel;
}

Result<StudyResult> run_filters(const StudyContext& context) {
  const auto rig = load(context, "fc1d.yaml");
  if (!rig) {
    return rig.error();
  }
  const auto made = FARRIER_TRY(rows_of(context, rig.value()));
  const std::vector<Row>& rows = made;
  const double light = rig.value().joints[0].swing_load.mass;
  const double heavy = rig.value().joints[0].stance_load.mass;
  Row none;  // a case that was not run measures nothing
  none.run.nrmse = none.margins.disk = none.margins.phase_rad = std::nan("");
  const auto at = [&](double cut_off_Hz, bool oversampled, double mass) -> const Row& {
    const Row* row = find(rows, cut_off_Hz, oversampled, mass);
    return row != nullptr ? *row : none;
  };
  const Row& bare = at(0.0, false, light);
  const Row& filtered = at(kRigFilter_Hz, false, light);
  const control::Gains gains = wire_gains::unpack_gains(filtered.run.gains);
  const Row& aggressive = at(kAggressive_Hz, false, light);
  // The disk margin behind filters of second order at these cut-offs over that without.
  struct CutOffs {
    double position_Hz, velocity_Hz, force_Hz;
  };
  const auto margin_share = [&](const control::Gains& of, const CutOffs& cut_offs) {
    robot::Joint joint = rig.value().joints[0];
    const auto disk = [&] {
      return control::margins(of.model, of, of.delay_ticks, robot::measurement_filters(joint, rig.value().period_s))
          .disk;
    };
    const double without = disk();
    joint.sensors.position.cut_off_Hz = cut_offs.position_Hz;
    joint.sensors.velocity.cut_off_Hz = cut_offs.velocity_Hz;
    joint.sensors.force.cut_off_Hz = cut_offs.force_Hz;
    return disk() / without;
  };
  const robot::Joint& nominal = rig.value().joints[0];
  const auto thesis_gains =
      control::design_lqr(robot::model_of(nominal, nominal.swing_load, rig.value().period_s), control::LqrWeights{},
                          nominal.normalisation, control::Form::kFullState, 0);
  if (!thesis_gains) {
    return Error{std::string("10.2: no gains for 2.5 kg: ") + control::to_string(thesis_gains.error())};
  }
  const double force_alone = margin_share(gains, {0.0, 0.0, kRigFilter_Hz});

  StudyResult result;
  result.measured = {
      {"10.2.margin_lost", force_alone,
       number_as("disk margin %.2f without filters", bare.margins.disk) +
           number_as("; force at 150 Hz: %.2f of it", margin_share(gains, {0.0, 0.0, 1.5 * kRigFilter_Hz}))},
      {"10.2.margin_lost_thesis", margin_share(thesis_gains.value(), {20.0, 20.0, kRigFilter_Hz}),
       number_as("force alone at 100 Hz: %.2f", margin_share(thesis_gains.value(), {0.0, 0.0, kRigFilter_Hz}))},
      {"10.2.alike", margin_share(gains, {kRigFilter_Hz, kRigFilter_Hz, kRigFilter_Hz}) - force_alone, ""},
      {"10.2.alike_at_50", margin_share(gains, {kAggressive_Hz, kAggressive_Hz, kAggressive_Hz}), ""},
      {"10.2.velocity_alone", filtered.margins.disk / bare.margins.disk, ""},
      {"10.2.phase_margin_lost", (aggressive.margins.phase_rad - bare.margins.phase_rad) * 180.0 / std::numbers::pi,
       ""},
      {"10.2.tracking_lost", aggressive.run.nrmse / bare.run.nrmse, ""},
      {"10.2.oversampling", at(0.0, true, heavy).run.nrmse / at(0.0, false, heavy).run.nrmse, ""}};
  const std::vector<double> masses{light, heavy};
  result.pictures = {
      {"What a velocity filter of second order costs the rig's LQR; gains for the load in question",
       3,
       {panel(rows, "disk margin", "disk margin", masses, false, [](const Row& row) { return row.margins.disk; }),
        panel(rows, "tracking error", "NRMSE", masses, true, [](const Row& row) { return row.run.nrmse; }),
        panel(rows, "what noise does to the valve", "RMS step of the current (mA)", masses, true,
              [](const Row& row) { return 1000.0 * row.run.current_step_rms_A; })}}};
  return result;
}

constexpr Study kStudies[] = {{"10.2", "Velocity filters and oversampling: margin, tracking, noise at the valve",
                               kClaims, run_filters,
                               "fc1d.yaml: perfect valve, no dry friction, no lines, noise of good sensors. Full-state "
                               "LQR, xi = 14 unless a claim says 6."}};

}  // namespace
}  // namespace chapter10_studies

std::span<const Study> chapter10() { return chapter10_studies::kStudies; }

}  // namespace farrier::thesis
