#include "urdf/comparison.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "core/text.hpp"
#include "urdf/joint_limits.hpp"
#include "urdf/joint_pairs.hpp"
#include "urdf/moving_bodies.hpp"

namespace farrier::urdf {
namespace {

using Eigen::Vector3d;

std::string short_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number);
  return text;
}

std::string short_text(const Vector3d& v) {
  return "[" + short_text(v.x()) + ", " + short_text(v.y()) + ", " + short_text(v.z()) + "]";
}

std::string elements_text(const Eigen::Matrix3d& t) {
  return "xx " + short_text(t(0, 0)) + ", yy " + short_text(t(1, 1)) + ", zz " + short_text(t(2, 2)) + ", xy " +
         short_text(t(0, 1)) + ", xz " + short_text(t(0, 2)) + ", yz " + short_text(t(1, 2));
}

class Comparer {
 public:
  Comparer(const robot::Robot& robot, const Tolerances& tolerances) : robot_(robot), tolerances_(tolerances) {}

  Comparison compare(const UrdfModel& urdf) {
    const std::vector<MovingBody> bodies = moving_bodies(urdf);
    compare_inertia("trunk", bodies.front().inertia, robot_.body->trunk);
    const std::vector<const MovingBody*> pairs = paired_bodies(bodies, robot_);
    std::set<const MovingBody*> used{&bodies.front()};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const robot::Joint& joint = robot_.joints[i];
      if (pairs[i] == nullptr) {
        differ(joint.name, "is no joint of the URDF");
        continue;
      }
      used.insert(pairs[i]);
      ++result_.compared_joints;
      compare_joint(joint, *pairs[i], bodies[static_cast<std::size_t>(pairs[i]->parent)]);
    }
    for (const MovingBody& body : bodies) {
      if (!used.contains(&body)) {
        differ("", "joint " + body.joint->name + " of the URDF (line " + std::to_string(body.joint->line) +
                       ") is none of the robot file; it moves " + short_text(body.inertia.mass_kg) + " kg");
      }
    }
    compare_total(bodies);
    list_what_is_one_sided(urdf);
    return std::move(result_);
  }

 private:
  void differ(const std::string& where, const std::string& message) { result_.differences.push_back({where, message}); }

  void differ(const std::string& where, const std::string& what, const std::string& urdf, const std::string& robot) {
    differ(where, what + " " + urdf + ", in the robot file " + robot);
  }

  bool alike(double a, double b) const {
    return std::abs(a - b) <= tolerances_.relative * std::max(std::abs(a), std::abs(b));
  }

  void compare_inertia(const std::string& where, const body::RigidInertia& urdf, const body::RigidInertia& ours) {
    if (!alike(urdf.mass_kg, ours.mass_kg)) {
      differ(where, "mass", short_text(urdf.mass_kg) + " kg", short_text(ours.mass_kg) + " kg");
    }
    if ((urdf.com_m - ours.com_m).norm() > tolerances_.length_m) {
      differ(where, "centre of mass", short_text(urdf.com_m) + " m", short_text(ours.com_m) + " m");
    }
    const double scale = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(ours.tensor_kg_m2).eigenvalues().maxCoeff();
    const double error = (urdf.tensor_kg_m2 - ours.tensor_kg_m2).cwiseAbs().maxCoeff();
    if (error <= tolerances_.relative * scale) {
      return;
    }
    // A tensor about the hinge, taken for one about the centre of mass, counts the mass twice.
    const Eigen::Matrix3d steiner =
        ours.mass_kg * (ours.com_m.squaredNorm() * Eigen::Matrix3d::Identity() - ours.com_m * ours.com_m.transpose());
    const bool about_hinge = (urdf.tensor_kg_m2 - ours.tensor_kg_m2 - steiner).cwiseAbs().maxCoeff() <=
                             tolerances_.relative * (scale + steiner.trace());
    differ(where, "inertia about the centre of mass", elements_text(urdf.tensor_kg_m2) + " kg m^2",
           elements_text(ours.tensor_kg_m2) + " kg m^2" +
               (about_hinge ? "; the URDF's is the one about the joint's axis, which counts the mass twice" : ""));
  }

  void compare_joint(const robot::Joint& joint, const MovingBody& body, const MovingBody& parent) {
    const UrdfJoint& urdf = *body.joint;
    const body::Link& link =
        robot_.body->legs[static_cast<std::size_t>(joint.leg)].links[static_cast<std::size_t>(joint.index_in_leg)];
    if (urdf.name != joint.name) {
      differ(joint.name, "name", urdf.name, joint.name);
    }
    if (urdf.type != UrdfJointType::kRevolute && urdf.type != UrdfJointType::kContinuous) {
      differ(joint.name, "type", to_string(urdf.type), "revolute");
      return;
    }
    const Vector3d hinge_m = body.hinge_m - parent.hinge_m;
    if ((hinge_m - link.hinge_m).norm() > tolerances_.length_m) {
      differ(joint.name, "origin", short_text(hinge_m) + " m from that of the joint before",
             short_text(link.hinge_m) + " m");
    }
    const double cosine = body.axis.dot(link.axis);
    const double sign = cosine < 0.0 ? -1.0 : 1.0;
    if (body.axis.cross(link.axis).norm() > tolerances_.angle_rad) {
      differ(joint.name, "axis", short_text(body.axis), short_text(link.axis));
    } else if (sign < 0.0) {
      differ(joint.name, "sign: axis", short_text(body.axis),
             short_text(link.axis) + "; angles, velocities and torques have the other sign");
    }
    compare_inertia(joint.name, body.inertia, link.inertia);
    compare_limits(joint, urdf, sign);
    if (urdf.damping_Nms_rad && !alike(*urdf.damping_Nms_rad, link.damping_Nms_rad)) {
      differ(joint.name, "damping", short_text(*urdf.damping_Nms_rad) + " Nms/rad",
             short_text(link.damping_Nms_rad) + " Nms/rad (body.joint_damping_Nms_rad)");
    }
  }

  // Limits of an axis with the other sign change places.
  void compare_limits(const robot::Joint& joint, const UrdfJoint& urdf, double sign) {
    const JointLimits ours = limits_of(joint, robot_.file);
    if (urdf.type == UrdfJointType::kContinuous || !urdf.lower_rad || !urdf.upper_rad) {
      differ(joint.name, "limits", "none", short_text(ours.lower_rad) + " to " + short_text(ours.upper_rad) + " rad");
    } else {
      const double lower = sign > 0.0 ? *urdf.lower_rad : -*urdf.upper_rad;
      const double upper = sign > 0.0 ? *urdf.upper_rad : -*urdf.lower_rad;
      if (std::abs(lower - ours.lower_rad) > tolerances_.angle_rad ||
          std::abs(upper - ours.upper_rad) > tolerances_.angle_rad) {
        differ(joint.name, "limits", short_text(lower) + " to " + short_text(upper) + " rad",
               short_text(ours.lower_rad) + " to " + short_text(ours.upper_rad) + " rad");
      }
    }
    if (urdf.effort_Nm && !alike(*urdf.effort_Nm, ours.effort_Nm)) {
      differ(joint.name, "effort", short_text(*urdf.effort_Nm) + " Nm",
             short_text(ours.effort_Nm) + " Nm, the largest between the limits");
    }
    if (urdf.velocity_rad_s && !alike(*urdf.velocity_rad_s, ours.velocity_rad_s)) {
      differ(joint.name, "velocity", short_text(*urdf.velocity_rad_s) + " rad/s",
             short_text(ours.velocity_rad_s) + " rad/s, the largest between the limits");
    }
  }

  void compare_total(const std::vector<MovingBody>& bodies) {
    double urdf_kg = 0.0;
    for (const MovingBody& body : bodies) {
      urdf_kg += body.inertia.mass_kg;
    }
    const double ours_kg = body::total_mass_kg(*robot_.body);
    if (!alike(urdf_kg, ours_kg)) {
      differ("", "mass of the robot", short_text(urdf_kg) + " kg", short_text(ours_kg) + " kg");
    }
  }

  void list_what_is_one_sided(const UrdfModel& urdf) {
    for (const auto& [element, count] : urdf.other_elements) {
      result_.only_in_urdf.push_back(counted(static_cast<std::uint64_t>(count), element));
    }
    const auto meshes = std::ranges::count_if(urdf.links, &UrdfLink::has_mesh);
    if (meshes > 0) {
      result_.only_in_urdf.push_back(counted(static_cast<std::uint64_t>(meshes), "link") + " with meshes");
    }
    for (const UrdfJoint& joint : urdf.joints) {
      if (!joint.mimics.empty()) {
        result_.only_in_urdf.push_back(joint.name + " mimics " + joint.mimics + ", which nothing drives");
      }
      if (joint.friction_Nm.value_or(0.0) > 0.0) {
        result_.only_in_urdf.push_back("dry friction of " + joint.name + ", which actuators and effects have here");
      }
    }
    std::map<std::string, std::string> joints_of_range;
    for (const robot::Joint& joint : robot_.joints) {
      const JointLimits limits = limits_of(joint, robot_.file);
      if (!alike(limits.effort_Nm, limits.least_effort_Nm)) {
        std::string& joints =
            joints_of_range[short_text(limits.least_effort_Nm) + " to " + short_text(limits.effort_Nm)];
        joints += (joints.empty() ? "" : ", ") + joint.name;
      }
    }
    for (const auto& [range, joints] : joints_of_range) {
      result_.only_in_robot.push_back("torque that changes with the angle, " + range +
                                      " Nm at the same force: " + joints);
    }
    const robot::RobotFile& file = robot_.file;
    const auto add = [&](bool present, const char* what) {
      if (present) {
        result_.only_in_robot.emplace_back(what);
      }
    };
    add(!file.valves.empty(), "valves, cylinders and vane motors: valves, actuators");
    add(file.supply.has_value(), "pressures and pump: supply");
    add(!file.electric_actuators.empty(), "motors with gear, spring and armature: electric_actuators");
    add(true, "geometry between actuator and joint: linkages");
    add(true, "gains, estimators and their limits: controllers, estimators, update_logic, safety");
    add(true, "gait and control of the whole robot: gait, locomotion");
  }

  const robot::Robot& robot_;
  const Tolerances& tolerances_;
  Comparison result_;
};

}  // namespace

Comparison compare(const UrdfModel& urdf, const robot::Robot& robot, const Tolerances& tolerances) {
  return Comparer(robot, tolerances).compare(urdf);
}

}  // namespace farrier::urdf
