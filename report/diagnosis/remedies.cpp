#include "report/diagnosis/remedies.hpp"

#include <algorithm>
#include <string_view>

namespace farrier::report {
namespace {

constexpr Remedy kRemedies[] = {
    {"input_delay", "command path",
     "Compare the time of a command with that of the current: buffers, bus cycles, driver."},
    {"valve_hysteresis", "valve",
     "Check oil and filters for dirt that holds the spool, and the driver for its dither."},
    {"valve_bias", "valve", "Set the valve's null at rest, or the offset of its driver."},
    {"valve_dynamics", "valve", "Check that pilot stage, filter and driver gain are as ordered: the spool is slow."},
    {"valve_deadband", "valve", "Compare with the valve's data sheet: a worn or wrong spool overlaps its ports."},
    {"valve_asymmetry", "valve", "Measure the flow to either side: an edge is worn or blocked."},
    {"flow_saturation", "valve", "Check the valve's rated flow, and filters and orifices before it."},
    {"supply_droop", "supply", "Check accumulator, pump, filter and hose: the pressure falls when flow is drawn."},
    {"internal_leakage", "piston",
     "Shut both ports and measure the flow: the piston's seals or the valve's lands leak."},
    {"air_entrainment", "oil", "Bleed the lines and check the suction side for air."},
    {"backlash", "linkage or gear", "Move the joint by hand: pins, rod ends or the gear have play."},
    {"piston_friction", "piston", "Check seals, their preload and side loads on the rod."},
    {"end_stop", "end stops", "Look for something in the way, and for the zero of the position sensor."},
    {"load_mass", "load", "Weigh what the joint carries, and compare it with the robot file."},
    {"flexible_load", "load", "Check mounts and screws of what the joint carries: a part of it swings by itself."},
    {"load_stiffness", "load", "Look for springs, hoses and cables that pull on the load."},
    {"load_damping", "load bearings", "Check bearings, grease and dampers of the load."},
    {"spring_hardening", "load", "Check springs and hoses for windings that touch or stretch taut."},
    {"external_force", "load", "Look for what pulls steadily: weight, cables, a neighbouring part."},
    {"load_friction", "load bearings", "Turn the unloaded joint by hand: guides or bearings stick."},
    {"position_dependent_friction", "load bearings",
     "Move the unloaded joint through its stroke by hand: a rod is bent, or a guide is worn in one place."},
    {"force_sensor_lag", "load cell", "Check filter and sampling of the load cell's amplifier."},
    {"force_sensor_gain", "load cell", "Calibrate the load cell with a known weight."},
    {"force_sensor_offset", "load cell", "Zero the load cell without a load."},
    {"velocity_filter_lag", "velocity sensor", "Check the filter of the velocity."},
    {"current_lag", "motor drive", "Check the gains of the drive's current loop."},
    {"current_limit", "motor drive", "Check the drive's current limit, its temperature and the supply's voltage."},
    {"torque_constant", "motor", "Check motor type and temperature: hot or weak magnets give less torque."},
    {"rotor_inertia", "motor", "Compare motor and gear ratio with the robot file."},
    {"gear_stiffness", "gear", "Check gear, coupling and spring: their stiffness is not the file's."},
    {"gear_friction", "gear", "Check grease, preload and wear of the gear."},
    {"cogging", "motor", "Compare the period with pole pairs and teeth: motor or gear ripples."},
    {"gravity", "load", "Weigh what the joint carries: a payload or a link is missing in the robot file."},
};

}  // namespace

const Remedy& remedy_of(plant::EffectId id) noexcept {
  static constexpr Remedy kOther{"", "joint", "Inspect the joint."};
  const auto found = std::ranges::find_if(kRemedies, [name = std::string_view(plant::effect_info(id).name)](
                                                         const Remedy& one) { return one.effect == name; });
  return found == std::end(kRemedies) ? kOther : *found;
}

}  // namespace farrier::report
