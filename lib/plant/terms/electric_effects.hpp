#pragma once

#include <array>

#include "plant/terms/contact_parameters.hpp"
#include "plant/terms/term.hpp"

// Effects that electric joints alone have. Those whose physics hydraulic joints share keep their names and are in
// AllTerms: delay of the input, play, the load's, the sensors'. Equations: diagnosis/model/drive_simulation.hpp.

namespace farrier::plant {

inline constexpr std::array kTorqueConstantParameters{
    Parameter{"gain", "gain", "1", "1", Scale::kOne, false, 0.2, 5.0, {1.05, 1.05}, "Over the file's."}};
inline constexpr std::array kCurrentLagParameters{Parameter{"time_constant_s",
                                                            "time_constant_s",
                                                            "s",
                                                            "s",
                                                            Scale::kSecond,
                                                            false,
                                                            1e-5,
                                                            0.05,
                                                            {0.002, 0.01},
                                                            "Time constant beyond that of the file."}};
inline constexpr std::array kCurrentLimitParameters{Parameter{"current_A",
                                                              "current_A",
                                                              "A",
                                                              "A",
                                                              Scale::kCurrent,
                                                              true,
                                                              1.0,
                                                              1000.0,
                                                              {2.0, 2.0},
                                                              "Largest current that the drive gives."}};
inline constexpr std::array kGearStiffnessParameters{
    Parameter{"stiffness_Nm_rad",
              "stiffness_Nm_rad",
              "Nm/rad",
              "Nm/rad",
              Scale::kGearStiffness,
              true,
              0.02,
              50.0,
              {1.05, 1.05},
              "Stiffness between rotor and load, k."},
    Parameter{"relaxation_s",
              "relaxation_s",
              "s",
              "s",
              Scale::kSecond,
              false,
              0.0,
              0.02,
              {1e-3, 1e-3},
              "Damping over stiffness; of a drive with a spring the damping is the file's."}};
inline constexpr std::array kRotorInertiaParameters{Parameter{"inertia_kg_m2",
                                                              "inertia_kg_m2",
                                                              "kg m^2",
                                                              "kg m^2",
                                                              Scale::kRotor,
                                                              false,
                                                              0.02,
                                                              20.0,
                                                              {1.05, 1.05},
                                                              "Inertia of the rotor, J."}};
inline constexpr std::array kCoggingParameters{
    Parameter{"amplitude_Nm", "amplitude_Nm", "Nm", "Nm", Scale::kForce, false, 0.0, 0.5, {0.01, 0.01}, "Amplitude."},
    Parameter{"periods_per_turn",
              "periods_per_turn",
              "1",
              "1",
              Scale::kOne,
              false,
              1.0,
              6000.0,
              {36.0, 36.0},
              "Periods in a turn of the output."},
    Parameter{"phase_rad", "phase_rad", "rad", "rad", Scale::kOne, false, -20.0, 20.0, {0.0, 0.0}, "Phase at 0 rad."}};
inline constexpr std::array kGravityParameters{
    Parameter{
        "moment_Nm", "moment_Nm", "Nm", "Nm", Scale::kForce, false, 0.0, 3.0, {0.05, 0.05}, "Largest torque, m g l."},
    Parameter{"hanging_rad",
              "hanging_rad",
              "rad",
              "rad",
              Scale::kOne,
              false,
              -20.0,
              20.0,
              {0.0, 0.0},
              "Position at which it hangs."}};

/// Effects of electric joints alone; their ids follow those of AllTerms.
inline constexpr std::array kElectricEffects{
    EffectInfo{"current_lag", Side::kDrive, false, false, kCurrentLagParameters,
               "The drive's current follows its command late, as a first-order lag does."},
    EffectInfo{"current_limit", Side::kDrive, false, false, kCurrentLimitParameters,
               "The drive gives no larger current than this one."},
    EffectInfo{"torque_constant", Side::kDrive, true, true, kTorqueConstantParameters,
               "The motor's torque per current is another than the model's."},
    EffectInfo{"rotor_inertia", Side::kDrive, true, true, kRotorInertiaParameters,
               "The rotor has another inertia than the model's."},
    EffectInfo{"gear_stiffness", Side::kDrive, true, true, kGearStiffnessParameters,
               "Gear and shaft between rotor and load are softer or stiffer than the model's."},
    EffectInfo{"gear_friction", Side::kDrive, false, false, kContactParameters,
               "The gear sticks and slips, beyond the friction of the file."},
    EffectInfo{"cogging", Side::kDrive, false, false, kCoggingParameters,
               "The motor's torque has a ripple, periodic in its position."},
    EffectInfo{"gravity", Side::kLoad, false, false, kGravityParameters,
               "A weight turns with the load, as a payload or a link that the model leaves out."}};

}  // namespace farrier::plant
