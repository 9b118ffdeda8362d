#include "robot/checks/cross_check.hpp"

#include "control/law/low_pass.hpp"
#include "robot/checks/body_check.hpp"
#include "robot/checks/locomotion_check.hpp"
#include "robot/leg_inertia.hpp"

namespace farrier::robot {
namespace {

void check_stance_lead(const RobotFile& file, config::Problems& problems) {
  const double announced_s = file.gait.announce_ticks * file.period_s;
  if (file.safety.params.stance_lead_s >= announced_s) {
    problems.push_back(file.safety.place.problem(
        "stance_lead_s", "is " + config::number_text(file.safety.params.stance_lead_s) +
                             ", but a touchdown is announced " + config::number_text(announced_s) +
                             " s ahead: give less, or more gait.announce_ticks"));
  }
}

void check_varied_body(const RobotFile& file, config::Problems& problems) {
  const double mass_kg = file.variation.params.body_mass_kg;
  if (mass_kg == 0.0) {
    return;
  }
  if (!file.body) {
    problems.push_back(file.variation.place.problem("body_mass_kg", "is for a robot with a body: leave it out"));
    return;
  }
  const double legs_kg = static_cast<double>(file.legs.size()) * leg_mass_kg(*file.body);
  if (mass_kg <= legs_kg) {
    problems.push_back(file.variation.place.problem(
        "body_mass_kg", "is " + config::number_text(mass_kg) + ", but the legs alone weigh " +
                            config::number_text(legs_kg) + " kg: give the mass of the whole robot"));
  }
}

void check_filter(const SensorSection& sensors, const char* key, double cut_off_Hz, double rate_Hz,
                  config::Problems& problems) {
  const double most_Hz = control::kLargestCutOffShare * rate_Hz;
  if (cut_off_Hz > most_Hz) {
    problems.push_back(sensors.place.problem(
        key, "is " + config::number_text(cut_off_Hz) + ", but a filter sampled at " + config::number_text(rate_Hz) +
                 " Hz reaches up to " + config::number_text(most_Hz) + ": give less, or 0 for none"));
  }
}

void check_filters(const RobotFile& file, config::Problems& problems) {
  const double rate_Hz = 1.0 / file.period_s;
  for (const auto& [name, actuator] : file.actuators) {
    if (!actuator.cylinder || !actuator.cylinder->sensors) {
      continue;
    }
    const SensorSection& s = *actuator.cylinder->sensors;
    check_filter(s, "position_filter_Hz", s.position_filter_Hz, rate_Hz, problems);
    check_filter(s, "velocity_filter_Hz", s.velocity_filter_Hz, rate_Hz, problems);
    check_filter(s, "force_filter_Hz", s.force_filter_Hz, rate_Hz, problems);
    check_filter(s, "anti_alias_Hz", s.anti_alias_Hz, s.oversampling * rate_Hz, problems);
  }
}

}  // namespace

config::Problems check_between_sections(const RobotFile& file) {
  config::Problems problems = check_body(file);
  const config::Problems of_locomotion = check_locomotion(file);
  problems.insert(problems.end(), of_locomotion.begin(), of_locomotion.end());
  check_stance_lead(file, problems);
  check_varied_body(file, problems);
  check_filters(file, problems);
  return problems;
}

}  // namespace farrier::robot
