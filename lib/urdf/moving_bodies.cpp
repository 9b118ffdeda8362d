#include "urdf/moving_bodies.hpp"

namespace farrier::urdf {
namespace {

/// The inertia of two bodies that move together, both counted from one point.
body::RigidInertia sum_of(const body::RigidInertia& a, const body::RigidInertia& b) {
  body::RigidInertia sum;
  sum.mass_kg = a.mass_kg + b.mass_kg;
  if (sum.mass_kg <= 0.0) {
    return sum;
  }
  sum.com_m = (a.mass_kg * a.com_m + b.mass_kg * b.com_m) / sum.mass_kg;
  for (const body::RigidInertia* part : {&a, &b}) {
    const Eigen::Vector3d d = part->com_m - sum.com_m;
    sum.tensor_kg_m2 +=
        part->tensor_kg_m2 + part->mass_kg * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
  }
  return sum;
}

class Walk {
 public:
  explicit Walk(const UrdfModel& model) : model_(model) {}

  std::vector<MovingBody> bodies() {
    bodies_.emplace_back();
    add_link(model_.root, 0, Eigen::Isometry3d::Identity());
    return std::move(bodies_);
  }

 private:
  /// `frame`: of the link, in the root's.
  void add_link(int link, std::size_t body, const Eigen::Isometry3d& frame) {
    const UrdfLink& data = model_.links[static_cast<std::size_t>(link)];
    bodies_[body].links.push_back(&data);
    if (data.inertia) {
      body::RigidInertia turned;
      turned.mass_kg = data.inertia->mass_kg;
      turned.com_m = frame * data.inertia->com_m - bodies_[body].hinge_m;
      turned.tensor_kg_m2 = frame.linear() * data.inertia->tensor_kg_m2 * frame.linear().transpose();
      bodies_[body].inertia = sum_of(bodies_[body].inertia, turned);
    }
    for (const UrdfJoint& joint : model_.joints) {
      if (joint.parent != link) {
        continue;
      }
      const Eigen::Isometry3d child = frame * joint.origin;
      std::size_t of_child = body;
      if (joint.moves()) {
        of_child = bodies_.size();
        MovingBody moved;
        moved.joint = &joint;
        moved.parent = static_cast<int>(body);
        moved.hinge_m = child.translation();
        moved.axis = child.linear() * joint.axis;
        bodies_.push_back(std::move(moved));
      }
      add_link(joint.child, of_child, child);
    }
  }

  const UrdfModel& model_;
  std::vector<MovingBody> bodies_;
};

}  // namespace

std::vector<MovingBody> moving_bodies(const UrdfModel& model) { return Walk(model).bodies(); }

}  // namespace farrier::urdf
