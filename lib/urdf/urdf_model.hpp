#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "body/model/body_model.hpp"

namespace farrier::urdf {

/// A link of a URDF. Without `inertial` it has neither mass nor inertia.
struct UrdfLink {
  std::string name;
  int line = 0;
  std::optional<body::RigidInertia> inertia{};  ///< in the link's frame
  bool has_mesh = false;
};

enum class UrdfJointType { kRevolute, kContinuous, kPrismatic, kFixed, kFloating, kPlanar };

/// A joint of a URDF; what it does not give is none.
struct UrdfJoint {
  std::string name;
  int line = 0;
  UrdfJointType type = UrdfJointType::kFixed;
  int parent = 0;  ///< place of the link in UrdfModel::links
  int child = 0;
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< of the child's frame in the parent's, at angle zero
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();           ///< of unit length, in the child's frame
  std::optional<double> lower_rad{}, upper_rad{}, effort_Nm{}, velocity_rad_s{}, damping_Nms_rad{}, friction_Nm{};
  std::string mimics{};  ///< joint that it follows, or empty

  bool moves() const noexcept { return type != UrdfJointType::kFixed; }
};

/// A mechanism as a URDF describes it: a tree of links.
struct UrdfModel {
  std::string name;
  std::string file;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  int root = 0;                               ///< place of the link that is no child
  std::map<std::string, int> other_elements;  ///< such as transmission, gazebo, ros2_control: how many
};

/// "revolute"
const char* to_string(UrdfJointType type) noexcept;

}  // namespace farrier::urdf
