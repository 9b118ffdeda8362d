#include "trials/body/plant_rows.hpp"

#include <array>

#include "config/visitor.hpp"

namespace farrier::trials {
namespace {

// 0.3 l/min at 100 bar.
constexpr double kWornSeal_m3_s_Pa = 5e-13;
constexpr double kDrift_s = 30.0;

const std::array kRows{
    PlantRow{.name = "nominal", .sentence = "as in the robot file"},
    PlantRow{.name = "gain_85", .sentence = "valve gain 0.85", .first = {.valve_gain = 0.85}},
    PlantRow{.name = "gain_70", .sentence = "valve gain 0.7", .first = {.valve_gain = 0.7}},
    PlantRow{.name = "gain_50", .sentence = "valve gain 0.5", .first = {.valve_gain = 0.5}, .decides = true},
    PlantRow{.name = "gain_130", .sentence = "valve gain 1.3", .first = {.valve_gain = 1.3}},
    PlantRow{.name = "gain_175", .sentence = "valve gain 1.75", .first = {.valve_gain = 1.75}, .decides = true},
    PlantRow{.name = "soft_oil", .sentence = "bulk modulus 0.25", .first = {.bulk_modulus = 0.25}},
    PlantRow{.name = "stiff_oil", .sentence = "bulk modulus 1.5", .first = {.bulk_modulus = 1.5}},
    PlantRow{.name = "seals", .sentence = "seal friction 5", .first = {.seal_friction = 5.0}},
    PlantRow{.name = "viscous", .sentence = "viscosity 4", .first = {.viscosity = 4.0}},
    PlantRow{.name = "leakage",
             .sentence = "0.3 l/min at 100 bar past each piston",
             .first = {.leakage_m3_s_Pa = kWornSeal_m3_s_Pa}},
    PlantRow{.name = "overlap_3", .sentence = "overlap of 3 %", .first = {.overlap_A = 3e-4}},
    PlantRow{.name = "overlap_0", .sentence = "no overlap", .first = {.overlap_A = 0.0}},
    PlantRow{.name = "one_leg",
             .sentence = "valve gain 0.5 in the first leg",
             .first = {.valve_gain = 0.5},
             .first_leg = true},
    PlantRow{.name = "payload", .sentence = "20 kg on the trunk", .payload_kg = 20.0},
    PlantRow{.name = "cold",
             .sentence = "valve gain 0.7, viscosity 4, seal friction 3",
             .first = {.valve_gain = 0.7, .viscosity = 4.0, .seal_friction = 3.0}},
    PlantRow{.name = "hot_air",
             .sentence = "bulk modulus 0.4, leakage 0.2 l/min, valve gain 0.8, overlap of 0.3 %",
             .first = {.valve_gain = 0.8,
                       .bulk_modulus = 0.4,
                       .leakage_m3_s_Pa = kWornSeal_m3_s_Pa * 2.0 / 3.0,
                       .overlap_A = 3e-5}},
    PlantRow{.name = "worn",
             .sentence = "valve gain 1.3, leakage 0.3 l/min, overlap of 0.2 %",
             .first = {.valve_gain = 1.3, .leakage_m3_s_Pa = kWornSeal_m3_s_Pa, .overlap_A = 2e-5}},
    PlantRow{.name = "coil_lost",
             .sentence = "valve gain 1, then 0.5 at once",
             .later = body::ActuatorChange{.valve_gain = 0.5},
             .decides = true},
    PlantRow{.name = "gain_rises",
             .sentence = "valve gain 1, then 1.75 at once",
             .later = body::ActuatorChange{.valve_gain = 1.75},
             .decides = true},
    PlantRow{.name = "drift_gain",
             .sentence = "valve gain from 1 to 0.5 in 30 s",
             .later = body::ActuatorChange{.duration_s = kDrift_s, .valve_gain = 0.5}},
    PlantRow{.name = "drift_oil",
             .sentence = "oil from 20 to 70 degrees in 30 s: viscosity 2.6 to 0.4, bulk modulus 1.05 to 0.85",
             .first = {.bulk_modulus = 1.05, .viscosity = 2.6},
             .later = body::ActuatorChange{.duration_s = kDrift_s, .bulk_modulus = 0.85, .viscosity = 0.4}},
    PlantRow{.name = "drift_wear",
             .sentence = "valve gain 1 to 1.3, leakage 0 to 0.3 l/min, overlap 0.6 to 0.2 % in 30 s",
             .later = body::ActuatorChange{
                 .duration_s = kDrift_s, .valve_gain = 1.3, .leakage_m3_s_Pa = kWornSeal_m3_s_Pa, .overlap_A = 2e-5}}};

bool changes_something(const body::ActuatorChange& change) {
  return change.valve_gain || change.bulk_modulus || change.viscosity || change.seal_friction ||
         change.leakage_m3_s_Pa || change.overlap_A;
}

std::string change_of(const std::string& joint, const body::ActuatorChange& change, double start_s) {
  std::string text = "{joint: " + joint + ", start_s: " + config::number_text(start_s);
  const auto add = [&text](const char* key, const std::optional<double>& value) {
    text += value ? std::string(", ") + key + ": " + config::number_text(*value) : "";
  };
  add("duration_s", change.duration_s);
  add("valve_gain_factor", change.valve_gain);
  add("bulk_modulus_factor", change.bulk_modulus);
  add("viscosity_factor", change.viscosity);
  add("seal_friction_factor", change.seal_friction);
  add("leakage_m3_s_Pa", change.leakage_m3_s_Pa);
  add("overlap_A", change.overlap_A);
  return text + "}\n";
}

}  // namespace

std::span<const PlantRow> plant_rows() { return kRows; }

std::string scene_of(const PlantRow& row, const robot::Robot& robot, double change_s) {
  std::string changes;
  for (const robot::Joint& joint : robot.joints) {
    if (joint.electric || (row.first_leg && joint.leg != 0)) {
      continue;
    }
    if (changes_something(row.first)) {
      changes += "  " + joint.name + ": " + change_of(joint.name, row.first, 0.0);
    }
    if (row.later) {
      changes += "  then_" + joint.name + ": " + change_of(joint.name, *row.later, change_s);
    }
  }
  std::string text = changes.empty() ? "" : "actuators:\n" + changes;
  if (row.payload_kg > 0.0) {
    text += "payloads: {load: {start_s: " + config::number_text(change_s) +
            ", mass_kg: " + config::number_text(row.payload_kg) + ", z_m: 0.15}}\n";
  }
  return text;
}

}  // namespace farrier::trials
