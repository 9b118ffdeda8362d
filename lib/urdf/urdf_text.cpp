#include "urdf/urdf_text.hpp"

#include <tinyxml2.h>

#include "body/model/trunk_shape.hpp"
#include "config/visitor.hpp"
#include "urdf/joint_limits.hpp"

namespace farrier::urdf {
namespace {

using Eigen::Vector3d;

/// Radius of a leg's cylinder where the file has no sphere at its end, as a share of its length.
constexpr double kSlenderness = 0.08;

std::string text_of(const Vector3d& v) {
  const Vector3d plain = v.array() + 0.0;  // no "-0"
  return config::number_text(plain.x()) + " " + config::number_text(plain.y()) + " " + config::number_text(plain.z());
}

/// An XML document in the making.
class Xml {
 public:
  /// An element that ends when this object does.
  class Element {
   public:
    Element(Xml& xml, const char* tag) : printer_(xml.printer_) { printer_.OpenElement(tag); }
    ~Element() { printer_.CloseElement(); }
    Element(const Element&) = delete;
    Element& operator=(const Element&) = delete;

    Element& set(const char* name, const std::string& value) {
      printer_.PushAttribute(name, value.c_str());
      return *this;
    }
    Element& set(const char* name, double value) { return set(name, config::number_text(value)); }
    Element& set(const char* name, const Vector3d& value) { return set(name, text_of(value)); }

   private:
    tinyxml2::XMLPrinter& printer_;
  };

  void comment(const char* text) { printer_.PushComment(text); }
  std::string text() const { return std::string("<?xml version=\"1.0\"?>\n") + printer_.CStr(); }

 private:
  tinyxml2::XMLPrinter printer_;
};

void write_origin(Xml& xml, const Vector3d& position_m) {
  Xml::Element(xml, "origin").set("xyz", position_m).set("rpy", Vector3d(Vector3d::Zero()));
}

void write_inertial(Xml& xml, const body::RigidInertia& inertia) {
  const Eigen::Matrix3d& t = inertia.tensor_kg_m2;
  Xml::Element inertial(xml, "inertial");
  write_origin(xml, inertia.com_m);
  Xml::Element(xml, "mass").set("value", inertia.mass_kg);
  Xml::Element(xml, "inertia")
      .set("ixx", t(0, 0))
      .set("ixy", t(0, 1))
      .set("ixz", t(0, 2))
      .set("iyy", t(1, 1))
      .set("iyz", t(1, 2))
      .set("izz", t(2, 2));
}

/// `use` is visual or collision.
void write_box(Xml& xml, const char* use, const body::TrunkBox& box) {
  Xml::Element element(xml, use);
  write_origin(xml, box.centre_m);
  Xml::Element geometry(xml, "geometry");
  Xml::Element(xml, "box").set("size", Vector3d(2.0 * box.half_extents_m));
}

void write_sphere(Xml& xml, const char* use, const Vector3d& centre_m, double radius_m) {
  Xml::Element element(xml, use);
  write_origin(xml, centre_m);
  Xml::Element geometry(xml, "geometry");
  Xml::Element(xml, "sphere").set("radius", radius_m);
}

/// A cylinder along z, from the link's origin to its end.
void write_cylinder(Xml& xml, const Vector3d& end_m, double radius_m) {
  Xml::Element element(xml, "visual");
  write_origin(xml, 0.5 * end_m);
  Xml::Element geometry(xml, "geometry");
  Xml::Element(xml, "cylinder").set("radius", radius_m).set("length", end_m.norm());
}

void write_fixed(Xml& xml, const std::string& parent, const std::string& child, const Vector3d& position_m) {
  Xml::Element joint(xml, "joint");
  joint.set("name", child + "_fixed").set("type", "fixed");
  write_origin(xml, position_m);
  Xml::Element(xml, "parent").set("link", parent);
  Xml::Element(xml, "child").set("link", child);
}

void write_joint(Xml& xml, const robot::Robot& robot, const robot::Joint& joint, const body::Link& link,
                 const std::string& parent, const std::string& child) {
  const JointLimits limits = limits_of(joint, robot.file);
  Xml::Element element(xml, "joint");
  element.set("name", joint.name).set("type", "revolute");
  write_origin(xml, link.hinge_m);
  Xml::Element(xml, "parent").set("link", parent);
  Xml::Element(xml, "child").set("link", child);
  Xml::Element(xml, "axis").set("xyz", link.axis);
  Xml::Element(xml, "limit")
      .set("lower", limits.lower_rad)
      .set("upper", limits.upper_rad)
      .set("effort", limits.effort_Nm)
      .set("velocity", limits.velocity_rad_s);
  Xml::Element(xml, "dynamics").set("damping", link.damping_Nms_rad).set("friction", 0.0);
}

/// The link behind the joint `index` of a leg.
void write_link(Xml& xml, const body::LegModel& leg, std::size_t index, const std::string& name) {
  constexpr std::size_t kLast = body::kJointsPerLeg - 1;
  const Vector3d end_m = index == kLast ? leg.foot_m : leg.links[index + 1].hinge_m;
  const double knee_m = leg.knee_radius_m > 0.0 ? leg.knee_radius_m : kSlenderness * leg.foot_m.norm();
  Xml::Element link(xml, "link");
  link.set("name", name);
  write_inertial(xml, leg.links[index].inertia);
  if (end_m.norm() > 0.0) {
    write_cylinder(xml, end_m, index == kLast ? leg.foot_radius_m : knee_m);
  }
  if (index == kLast) {
    write_sphere(xml, "visual", leg.foot_m, leg.foot_radius_m);
    write_sphere(xml, "collision", leg.foot_m, leg.foot_radius_m);
    if (leg.knee_radius_m > 0.0) {
      write_sphere(xml, "collision", Vector3d::Zero(), leg.knee_radius_m);
    }
  }
}

void write_leg(Xml& xml, const robot::Robot& robot, std::size_t leg_place) {
  const body::LegModel& leg = robot.body->legs[leg_place];
  std::string parent = "trunk";
  for (std::size_t index = 0; index < leg.links.size(); ++index) {
    const std::string child = leg.name + "_" + kLinksOfALeg[index];
    write_joint(xml, robot, robot.joints[leg_place * body::kJointsPerLeg + index], leg.links[index], parent, child);
    write_link(xml, leg, index, child);
    parent = child;
  }
  write_fixed(xml, parent, leg.name + "_foot", leg.foot_m);
  Xml::Element(xml, "link").set("name", leg.name + "_foot");
}

}  // namespace

Result<std::string> urdf_text(const robot::Robot& robot) {
  if (!robot.body) {
    return Error{robot.path +
                 " describes no rigid bodies: a URDF needs body.trunk, the inertias of the links and "
                 "hip_position_m of each leg (docs/robots.md, From the mechanism to the file)"};
  }
  Xml xml;
  {
    xml.comment(" Written by farrier robot urdf: shapes are boxes, cylinders and spheres. ");
    Xml::Element root(xml, "robot");
    root.set("name", robot.name);
    Xml::Element(xml, "link").set("name", "base_link");
    write_fixed(xml, "base_link", "trunk", Vector3d::Zero());
    {
      Xml::Element trunk(xml, "link");
      trunk.set("name", "trunk");
      write_inertial(xml, robot.body->trunk);
      write_box(xml, "visual", robot.body->box.value_or(body::shown_trunk(*robot.body)));
      if (robot.body->box) {
        write_box(xml, "collision", *robot.body->box);
      }
    }
    for (std::size_t leg = 0; leg < robot.body->legs.size(); ++leg) {
      write_leg(xml, robot, leg);
    }
  }
  return xml.text();
}

}  // namespace farrier::urdf
