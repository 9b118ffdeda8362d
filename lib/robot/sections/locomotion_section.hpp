#pragma once

#include <string>

#include "config/visitor.hpp"
#include "locomotion/trot_controller.hpp"

namespace farrier::robot {

/// Parameters of the controller of the whole robot. Places, lengths and masses are those of the sections body and legs.
struct LocomotionSection {
  std::string controller;       ///< section of the joints' controllers on a ground; empty: those of the joints
  std::string joint_estimator;  ///< likewise of their estimators
  locomotion::LocomotionParams params;
  double folded_haa_rad = 0.0, folded_hfe_rad = 0.0, folded_kfe_rad = 0.0;  ///< as a hind leg counts them
  config::Place place;
};

void declare(config::Visitor& v, LocomotionSection& section);

}  // namespace farrier::robot

// Declared beside the structs, where the visitor finds them.
namespace farrier::locomotion {

void declare(config::Visitor& v, StateEstimatorParams& estimator);
void declare(config::Visitor& v, LegSequencerParams& contact);
void declare(config::Visitor& v, FeltTouchdownParams& felt);
void declare(config::Visitor& v, GroundPlaneParams& ground);
void declare(config::Visitor& v, TrunkReferenceParams& reference);
void declare(config::Visitor& v, TrunkWrenchParams& trunk);
void declare(config::Visitor& v, PayloadParams& payload);
void declare(config::Visitor& v, ForceDistributionParams& forces);
void declare(config::Visitor& v, FootholdParams& foothold);
void declare(config::Visitor& v, SwingParams& swing);
void declare(config::Visitor& v, LegControllerParams& leg);
void declare(config::Visitor& v, ModeSequencerParams& mode);
void declare(config::Visitor& v, JointGuardParams& guard);

}  // namespace farrier::locomotion
