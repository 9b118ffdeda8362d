#pragma once

#include <vector>

#include "urdf/urdf_model.hpp"

namespace farrier::urdf {

/// The links of a URDF that move together, with the joint that moves them. All vectors have the axes of the root link, at
/// angles of zero.
struct MovingBody {
  const UrdfJoint* joint = nullptr;                   ///< null: the body of the root link
  int parent = -1;                                    ///< place of the body that carries it; -1: none, of the root's
  Eigen::Vector3d hinge_m = Eigen::Vector3d::Zero();  ///< origin of the joint, from the root link's origin
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  body::RigidInertia inertia;  ///< of all its links; the centre of mass is counted from hinge_m
  std::vector<const UrdfLink*> links;
};

/// The bodies of a mechanism, the root's first, each behind its parent. Fixed joints join links to one body: masses add
/// up, and tensors by the parallel-axis theorem.
std::vector<MovingBody> moving_bodies(const UrdfModel& model);

}  // namespace farrier::urdf
