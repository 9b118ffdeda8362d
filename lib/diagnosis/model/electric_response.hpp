#pragma once

#include <span>
#include <vector>

#include "diagnosis/model/joint_sides.hpp"
#include "diagnosis/model/rotor_and_load.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// An electric joint with a model's factors and effects.
struct WholeElectricJoint {
  DriveNumbers<double> drive;
  LoadNumbers<double> load;
  plant::TermSet<double> terms;  ///< effects of input, load and sensors
  double middle = 0.0;           ///< in which it is held, rad
  Hold hold = {};
};

/// Substeps of a period in the simulation of a whole joint. The winding's time constant of 0.2 ms is then followed to
/// 1 %.
inline constexpr std::size_t kWholeSubsteps = 16;

/// Readings of the joint, period by period, under `current_A` beside its hold. Motor, gear and load are one system of
/// equations, those of plant/electric_actuator.hpp, by the midpoint rule. Before, it is held for a second from rest, so
/// that a steady torque has bent the hold. Contacts of `joint` step kWholeSubsteps times a period.
std::vector<plant::JointReadings> electric_response(const WholeElectricJoint& joint, std::span<const double> current_A,
                                                    double period_s);

}  // namespace farrier::diagnosis
