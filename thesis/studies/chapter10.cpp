// Hubacher (2014), 10.2 and 10.3: what filtering the velocity costs the loop in margin and tracking, and what
// oversampling would give back. The study the text asks for.

#include <algorithm>
#include <cmath>

#include "control/design/margins.hpp"
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
     "Disk margin with the force alone filtered at 100 Hz over that without filters, the rig's own load: at most a "
     "tenth.",
     "1", Relation::kAtMost, 0.1},
    proof({"10.2.margin_lost_less", "10.2", kRobustness, "The same with the force filtered at 150 Hz: at most half.", "1",
     Relation::kAtMost, 0.5}),
    proof({"10.2.alike", "10.2", kRobustness,
     "The same with position, velocity and force filtered alike at 100 Hz: half or more.", "1", Relation::kAtLeast,
     0.5}),
    proof({"10.2.alike_at_50", "10.2", kRobustness, "The same at 50 Hz: at most half.", "1", Relation::kAtMost, 0.5}),
    {"10.2.margin_lost_by_velocity", "10.2", kRobustness,
     "The same with the velocity alone filtered at 100 Hz: at most half.", "1", Relation::kAtMost, 0.5,
     Refutation{
         "the gain on the force is the largest: a filter of the velocity alone leaves the margin nearly as it is, "
         "one of the force alone takes it (10.2.margin_lost)",
         0.8, 1.0}},
    proof({"10.2.phase_margin_lost", "10.2, footnote 6",
     "The phase delay of the measurement essentially 'eats' up the phase margin of the LQR controller ...",
     "Phase margin with the velocity filtered at 50 Hz less that without, the rig's own load: less than zero.", "rad",
     Relation::kBelow, 0.0}),
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
  const auto margin_share = [&](double position_Hz, double velocity_Hz, double force_Hz) {
    robot::Joint joint = rig.value().joints[0];
    joint.sensors.position.cut_off_Hz = position_Hz;
    joint.sensors.velocity.cut_off_Hz = velocity_Hz;
    joint.sensors.force.cut_off_Hz = force_Hz;
    const auto filters = robot::measurement_filters(joint, rig.value().period_s);
    return control::margins(gains.model, gains, gains.delay_ticks, filters).disk / bare.margins.disk;
  };

  StudyResult result;
  result.measured = {{"10.2.margin_lost", margin_share(0.0, 0.0, kRigFilter_Hz),
                      "disk margin " + std::to_string(bare.margins.disk) + " without filters"},
                     {"10.2.margin_lost_less", margin_share(0.0, 0.0, 1.5 * kRigFilter_Hz), ""},
                     {"10.2.alike", margin_share(kRigFilter_Hz, kRigFilter_Hz, kRigFilter_Hz), ""},
                     {"10.2.alike_at_50", margin_share(kAggressive_Hz, kAggressive_Hz, kAggressive_Hz), ""},
                     {"10.2.margin_lost_by_velocity", filtered.margins.disk / bare.margins.disk, ""},
                     {"10.2.phase_margin_lost", aggressive.margins.phase_rad - bare.margins.phase_rad, ""},
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

constexpr Study kStudies[] = {
    {"10.2", "Velocity filters and oversampling: margin, tracking, noise at the valve", kClaims, run_filters}};

}  // namespace
}  // namespace chapter10_studies

std::span<const Study> chapter10() { return chapter10_studies::kStudies; }

}  // namespace farrier::thesis
