// Hubacher (2014), 10.2 and 10.3: what filtering the velocity costs the loop in margin and tracking, and what
// oversampling would give back. The study the text asks for.

#include <algorithm>
#include <cmath>

#include "control/margins.hpp"
#include "joint_node/gains_decoding.hpp"
#include "lab/filter_study.hpp"
#include "lab/studies/registry.hpp"

namespace farrier::studies {
namespace {

constexpr double kLength_s = 2.0;
constexpr double kRigFilter_Hz = 100.0;
constexpr double kAggressive_Hz = 50.0;
constexpr int kOrder = 2;

constexpr ClaimSpec kClaims[] = {
    {"10.2.margin_lost", "10.2",
     "Because the state measurement signals were then filtered differently, the different phase delays reduced the "
     "robustness of the LQR drastically.",
     "Disk margin with the velocity filtered at 100 Hz over that without, the worse of both loads: at most half.", "1",
     Relation::kAtMost, 0.5},
    {"10.2.delay_margin_lost", "10.2, footnote 6",
     "The phase delay of the measurement essentially 'eats' up the phase margin of the LQR controller ...",
     "Phase margin with the velocity filtered at 50 Hz less that without, the rig's own load: less than zero.", "rad",
     Relation::kBelow, 0.0},
    {"10.2.tracking_lost", "10.2",
     "... the filtering of the measurement signals has quite a high impact on the robustness and tracking capabilities "
     "of the LQR controller.",
     "Tracking error with the velocity filtered at 50 Hz over that without, the rig's own load: at least a quarter more.",
     "1", Relation::kAtLeast, 1.25},
    {"10.2.noise_amplified", "10.2",
     "The corresponding velocity gain is quite high ... hence the noise is amplified, resulting in a noisy controller "
     "output. We used a rather aggressive filter to get rid of the noise ...",
     "RMS of the valve current's steps with the velocity filtered at 50 Hz over that without, the rig's own load: at "
     "most half.",
     "1", Relation::kAtMost, 0.5},
    {"10.3.oversampling", "10.3",
     "Possible improvements may consist of adding an (analog) anti-aliasing filter before sampling the signals and to "
     "use oversampling ...",
     "RMS of the valve current's steps with eight conversions a tick behind 1.5 kHz, velocity not filtered, over that "
     "with one, the rig's own load: at most 0.6.",
     "1", Relation::kAtMost, 0.6}};

/// A run with the margins of its loop, the velocity filter inside. Conversions and the analog filter of an oversampled
/// sensor are not in them.
struct Row {
  lab::FilterRow run;
  control::Margins margins;
};

const Row* find(const std::vector<Row>& rows, double cut_off_Hz, bool oversampled, double mass_kg) {
  const auto found = std::ranges::find_if(rows, [&](const Row& row) {
    const lab::FilterCase& filter = row.run.filter;
    return filter.velocity_cut_off_Hz == cut_off_Hz && filter.oversampled == oversampled &&
           (cut_off_Hz == 0.0 || filter.order == kOrder) && row.run.load_mass_kg == mass_kg;
  });
  return found == rows.end() ? nullptr : &*found;
}

Result<std::vector<Row>> rows_of(const StudyContext& context, const robot::Robot& rig) {
  std::vector<Row> rows;
  const std::vector<lab::FilterCase> cases = lab::filter_cases();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!keep_going(context, static_cast<double>(i) / static_cast<double>(cases.size()))) {
      return stopped();
    }
    auto ran = lab::filter_study(rig, {cases[i]}, kLength_s, context.seed);
    if (!ran) {
      return ran.error();
    }
    for (const lab::FilterRow& run : ran.value()) {
      const control::Gains gains = joint_node::unpack_gains(run.gains);
      control::MeasurementFilters filters;
      filters.velocity = control::measurement_filter(run.velocity_filter);
      rows.push_back({run, control::margins(gains.model, gains, gains.delay_ticks, filters)});
    }
  }
  return rows;
}

Panel panel(const std::vector<Row>& rows, const std::string& title, const std::string& y_label,
            const std::vector<double>& masses, bool both, double (*value)(const Row&)) {
  Panel panel{title, "cut-off of the velocity filter (Hz); 1000: none", y_label, true, false, false, {}};
  int colour = 1;
  for (const double mass : masses) {
    for (const bool oversampled : {false, true}) {
      if (oversampled && !both) {
        continue;
      }
      Series series{std::to_string(mass).substr(0, mass < 10.0 ? 3 : 2) + " kg" + (oversampled ? ", oversampled" : ""),
                    {}, {}, oversampled ? Style::kDashed : Style::kLine, colour};
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
  const auto made = rows_of(context, rig.value());
  if (!made) {
    return made.error();
  }
  const std::vector<Row>& rows = made.value();
  const double light = rig.value().joints[0].swing_load.mass;
  const double heavy = rig.value().joints[0].stance_load.mass;
  const auto at = [&](double cut_off_Hz, bool oversampled, double mass) -> const Row& {
    const Row* row = find(rows, cut_off_Hz, oversampled, mass);
    static const Row kNone{{.nrmse = NAN, .current_step_rms_A = NAN}, {.disk = NAN, .phase_rad = NAN}};
    return row != nullptr ? *row : kNone;
  };
  const Row& bare = at(0.0, false, light);
  const auto disk_ratio = [&](double mass) {
    return at(kRigFilter_Hz, false, mass).margins.disk / at(0.0, false, mass).margins.disk;
  };
  const Row& aggressive = at(kAggressive_Hz, false, light);

  StudyResult result;
  result.measured = {
      {"10.2.margin_lost", std::min(disk_ratio(light), disk_ratio(heavy)),
       "light " + std::to_string(disk_ratio(light)) + ", heavy " + std::to_string(disk_ratio(heavy))},
      {"10.2.delay_margin_lost", aggressive.margins.phase_rad - bare.margins.phase_rad, ""},
      {"10.2.tracking_lost", aggressive.run.nrmse / bare.run.nrmse, ""},
      {"10.2.noise_amplified", aggressive.run.current_step_rms_A / bare.run.current_step_rms_A, ""},
      {"10.3.oversampling", at(0.0, true, light).run.current_step_rms_A / bare.run.current_step_rms_A, ""}};
  const std::vector<double> masses{light, heavy};
  result.pictures = {
      {"What a velocity filter of second order costs the rig's LQR, and what it spares the valve; gains for the load in "
       "question",
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

std::span<const Study> chapter10() { return kStudies; }

}  // namespace farrier::studies
