#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier::body {

// Frames. The trunk's frame has x forward, y left, z up; its origin is a point of the trunk that the data choose. Each
// link has a frame with its origin on its hinge. All frames are parallel to the trunk's while all joint angles are zero.

inline constexpr int kMaxLegs = 6;
inline constexpr int kJointsPerLeg = 3;
inline constexpr int kMaxJoints = kMaxLegs * kJointsPerLeg;

/// Mass, centre of mass and inertia tensor of one body, in the body's frame.
struct RigidInertia {
  double mass_kg = 0.0;                                    ///< > 0
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();         ///< centre of mass
  Eigen::Matrix3d tensor_kg_m2 = Eigen::Matrix3d::Zero();  ///< about the centre of mass; elements, not products
};

/// Angles between two stops, least_rad < largest_rad.
struct JointStops {
  double least_rad;
  double largest_rad;
};

/// A hinge and the link that it turns. A positive angle turns the link about `axis` by the right-hand rule.
struct Link {
  Eigen::Vector3d hinge_m = Eigen::Vector3d::Zero();  ///< in the frame of the parent: the trunk or the link before
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();    ///< of unit length
  double armature_kg_m2 = 0.0;                        ///< inertia of the actuator, as the joint feels it; >= 0
  double damping_Nms_rad = 0.0;                       ///< viscous friction of the joint; >= 0
  double known_damping_Nms_rad = 0.0;                 ///< part of it that controllers count; >= 0
  std::optional<JointStops> stops;                    ///< of the hinge itself; none where the actuator has them
  RigidInertia inertia;
};

/// A chain of three hinges with a sphere as foot.
struct LegModel {
  std::string name;
  std::array<Link, kJointsPerLeg> links;             ///< from the trunk outwards
  Eigen::Vector3d foot_m = Eigen::Vector3d::Zero();  ///< centre of the sphere, in the frame of the last link
  double foot_radius_m = 0.0;                        ///< > 0
  double knee_radius_m = 0.0;  ///< of a sphere about the last hinge that meets the ground; 0: none
};

/// The part of the trunk that can touch the ground: a box along the trunk's axes.
struct TrunkBox {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();        ///< in the trunk's frame
  Eigen::Vector3d half_extents_m = Eigen::Vector3d::Zero();  ///< each > 0
};

/// A legged robot as rigid bodies: a free trunk and up to kMaxLegs legs.
struct BodyModel {
  RigidInertia trunk;
  std::vector<LegModel> legs;
  std::optional<TrunkBox> box;  ///< none: the trunk passes through the ground
  double gravity_m_s2 = 9.81;   ///< >= 0, along -z of the world

  int joints() const noexcept { return kJointsPerLeg * static_cast<int>(legs.size()); }
};

/// Refuses an inertia without mass, and a tensor that is not symmetric, possible and positive definite. The message
/// begins with a verb: "has no mass: ...".
Result<Done> validate(const RigidInertia& inertia);

/// Refuses a body that no mechanics can move, by the name of the body and with the remedy. Each mass must be above
/// zero, each tensor symmetric and possible, each axis of unit length, each foot a sphere, each stop below the other.
Result<Done> validate(const BodyModel& model);

/// Mass of trunk and legs.
double total_mass_kg(const BodyModel& model) noexcept;

/// True if masses at points can have this tensor I: its principal moments keep the triangle inequality. A thin rod
/// passes. The condition is that tr(I)/2 1 - I is positive semidefinite (Wensing, Kim and Slotine 2018, IEEE Robotics and
/// Automation Letters 3(1), section III).
bool is_possible_tensor(const Eigen::Matrix3d& tensor_kg_m2) noexcept;
/// The end of the sentence "is a tensor that ..." about one that is not possible.
inline constexpr const char* kImpossibleTensor =
    "no masses can have: no principal moment may exceed the sum of the others";

/// Principal moments of a tensor, and the rotation from its principal axes to the body's.
struct PrincipalInertia {
  Eigen::Vector3d moments_kg_m2;
  Eigen::Quaterniond attitude;
};
PrincipalInertia principal_inertia(const Eigen::Matrix3d& tensor_kg_m2) noexcept;

}  // namespace farrier::body
