#include "tools/report/effects_table.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "tools/report/text_format.hpp"

namespace farrier::report {
namespace {

using plant::Scale;

constexpr std::array<std::pair<std::string_view, const char*>, 22> kMeanings{{
    {"input_delay", "The valve has a current later than it was commanded."},
    {"valve_bias", "The valve is shut at another current than 0."},
    {"valve_dynamics", "The spool follows the current as a mass on a spring does."},
    {"valve_deadband", "The spool overlaps its ports: small currents open nothing."},
    {"valve_asymmetry", "The ports that extend are larger than those that retract, or smaller."},
    {"flow_saturation", "An orifice before the valve keeps its flow from growing with the current."},
    {"supply_droop", "The supply pressure falls with the flow that is drawn."},
    {"internal_leakage", "Oil leaks past the piston from one chamber to the other."},
    {"air_entrainment", "Free air makes the oil softer, the more the lower its pressure."},
    {"backlash", "There is play between piston and load."},
    {"piston_friction", "The piston's seals stick and slip."},
    {"end_stop", "The piston meets end stops before the stroke ends."},
    {"load_mass", "The load has another mass or inertia than the model."},
    {"load_stiffness", "The load is held by another spring than the model's."},
    {"load_damping", "The load has another viscous friction than the model."},
    {"spring_hardening", "The load's spring is stiffer, or softer, the further it is bent."},
    {"external_force", "A constant force acts on the load."},
    {"load_friction", "The load sticks and slips on its guides."},
    {"force_sensor_lag", "The load cell reads late."},
    {"force_sensor_gain", "The load cell reads a multiple of the force."},
    {"force_sensor_offset", "The load cell reads a constant beside the force."},
    {"velocity_filter_lag", "The velocity is read late."},
}};

const char* text_of(Scale scale) {
  switch (scale) {
    case Scale::kOne:
    case Scale::kSecond:
    case Scale::kRate:
      return "";
    case Scale::kCurrent:
      return "largest current";
    case Scale::kForce:
      return "full push";
    case Scale::kLength:
      return "stroke";
    case Scale::kSpeed:
      return "full speed";
    case Scale::kLeakage:
      return "full flow / supply pressure";
    case Scale::kDroop:
      return "supply pressure / full flow";
    case Scale::kMass:
      return "the model's";
    case Scale::kDamping:
      return "the model's, or 0.01 full push / full speed";
    case Scale::kStiffness:
      return "the model's, or 0.2 full push / stroke";
    case Scale::kCubic:
      return "stiffness / stroke^2";
  }
  return "";
}

std::string both(std::string_view linear, std::string_view rotary, std::string_view quote) {
  const std::string one = std::string(quote) + std::string(linear) + std::string(quote);
  return linear == rotary ? one : one + ", " + std::string(quote) + std::string(rotary) + std::string(quote);
}

std::string range_text(const plant::Parameter& p) {
  const double ends[] = {p.reciprocal ? 1.0 / p.high : p.low, p.reciprocal ? 1.0 / p.low : p.high};
  const std::string_view scale = text_of(p.scale);
  return short_number(ends[0]) + " to " + short_number(ends[1]) +
         (scale.empty() ? "" : " times " + std::string(scale));
}

}  // namespace

const char* meaning_of(plant::EffectId id) noexcept {
  const auto found = std::ranges::find(kMeanings, std::string_view(plant::effect_info(id).name),
                                       [](const auto& entry) { return entry.first; });
  return found == kMeanings.end() ? "" : found->second;
}

const char* place_of(plant::Side side) noexcept {
  switch (side) {
    case plant::Side::kValveAndOil:
      return "valve and oil";
    case plant::Side::kLoad:
      return "load";
    case plant::Side::kForceSensor:
      return "force sensor";
    case plant::Side::kVelocitySensor:
      return "velocity sensor";
  }
  return "";
}

std::string effects_table_markdown() {
  std::string table = "| effect | place | parameter | unit | range | meaning |\n|---|---|---|---|---|---|\n";
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const plant::EffectInfo& info = plant::effect_info(id);
    for (const plant::Parameter& p : info.parameters) {
      const bool first = &p == info.parameters.data();
      table += "| " + (first ? "`" + std::string(info.name) + "`" : std::string()) + " | " +
               (first ? place_of(info.side) : "") + " | " + both(p.name, p.rotary_name, "`") + " | " +
               both(p.unit, p.rotary_unit, "") + " | " + range_text(p) + " | " +
               (first ? std::string(meaning_of(id)) + " " : std::string()) + p.meaning + " |\n";
    }
  }
  return table;
}

}  // namespace farrier::report
