#include "body/engine/mjcf.hpp"

#include <charconv>
#include <initializer_list>

namespace farrier::body {
namespace {

// A foot touches the plane and at most as many boxes as meet at a corner, with a margin.
constexpr int kContactsOfAFoot = 16;
constexpr int kContactsOfAKnee = 4;
constexpr int kContactsOfTheTrunk = 48;  // eight with a box; a run ends soon after a fall
constexpr int kRowsOfAContact = 4;       // edges of the friction pyramid

// Shortest text that reads back as the same number.
std::string text_of(double number) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr};
}

std::string text_of(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) {
    text += (text.empty() ? "" : " ") + text_of(number);
  }
  return text;
}

std::string text_of(const Eigen::Vector3d& v) { return text_of({v.x(), v.y(), v.z()}); }
std::string text_of(const Eigen::Quaterniond& q) { return text_of({q.w(), q.x(), q.y(), q.z()}); }

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

// By principal axes: MuJoCo's own search for them, of a full tensor, ends at 1e-8 of it.
std::string inertial(const RigidInertia& inertia) {
  const PrincipalInertia principal = principal_inertia(inertia.tensor_kg_m2);
  return "<inertial" + attribute("pos", text_of(inertia.com_m)) + attribute("quat", text_of(principal.attitude)) +
         attribute("mass", text_of(inertia.mass_kg)) + attribute("diaginertia", text_of(principal.moments_kg_m2)) +
         "/>\n";
}

std::string foot_text(const LegModel& leg, const std::string& number) {
  const std::string place = attribute("name", number + "/foot") + attribute("pos", text_of(leg.foot_m));
  const std::string knee =
      leg.knee_radius_m > 0.0 ? "<geom class=\"robot\"" + attribute("size", text_of(leg.knee_radius_m)) + "/>\n" : "";
  return knee + "<geom class=\"robot\"" + place + attribute("size", text_of(leg.foot_radius_m)) + "/>\n<site" + place +
         "/>\n";
}

std::string trunk_box_text(const TrunkBox& box) {
  return "<geom class=\"robot\" type=\"box\"" + attribute("pos", text_of(box.centre_m)) +
         attribute("size", text_of(box.half_extents_m)) + "/>\n";
}

std::string stops_text(const std::optional<JointStops>& stops) {
  return stops ? attribute("range", text_of({stops->least_rad, stops->largest_rad})) : "";
}

std::string leg_text(const LegModel& leg, const std::string& number) {
  std::string text;
  for (std::size_t i = 0; i < leg.links.size(); ++i) {
    const Link& link = leg.links[i];
    const std::string name = attribute("name", number + "/" + std::to_string(i));
    text += "<body" + name + attribute("pos", text_of(link.hinge_m)) + ">\n<joint" + name +
            attribute("axis", text_of(link.axis)) + attribute("armature", text_of(link.armature_kg_m2)) +
            attribute("damping", text_of(link.damping_Nms_rad)) + stops_text(link.stops) + "/>\n" +
            inertial(link.inertia);
  }
  text += foot_text(leg, number);
  for (std::size_t i = 0; i < leg.links.size(); ++i) {
    text += "</body>\n";
  }
  return text;
}

std::string box_text(const Box& box) {
  return "<geom class=\"ground\" type=\"box\"" + attribute("pos", text_of(box.centre_m)) +
         attribute("size", text_of(box.half_extents_m)) + attribute("quat", text_of(box.attitude)) + "/>\n";
}

// Feet, knees and trunk collide with the ground, and with nothing else. No actuator has a limit: that is the actuators'
// business. A step forgets the last one's contact forces (warmstart), so position and velocity are all the state there
// is.
std::string header_text(const BodyModel& model, const Scene& scene, double step_s) {
  const int contacts =
      (kContactsOfAFoot + kContactsOfAKnee) * static_cast<int>(model.legs.size()) + kContactsOfTheTrunk;
  return "<mujoco>\n<compiler angle=\"radian\" autolimits=\"true\" boundmass=\"0\" boundinertia=\"0\"/>\n"
         "<option integrator=\"Euler\" cone=\"pyramidal\" solver=\"Newton\" iterations=\"50\" tolerance=\"1e-10\"" +
         attribute("timestep", text_of(step_s)) + attribute("gravity", text_of({0.0, 0.0, -model.gravity_m_s2})) +
         "><flag warmstart=\"disable\"/></option>\n<size" + attribute("nconmax", std::to_string(contacts)) +
         attribute("njmax", std::to_string(kRowsOfAContact * contacts + model.joints())) +
         "/>\n<default>\n<geom condim=\"3\" solref=\"0.005 1\" solimp=\"0.95 0.99 0.001 0.5 2\"" +
         attribute("friction", text_of({scene.friction, 0.0, 0.0})) +
         "/>\n<joint solreflimit=\"0.005 1\"/>\n<default class=\"robot\"><geom type=\"sphere\" mass=\"0\" "
         "contype=\"1\" conaffinity=\"0\"/></default>\n"
         "<default class=\"ground\"><geom contype=\"0\" conaffinity=\"1\"/></default>\n</default>\n";
}

}  // namespace

std::string mjcf_text(const BodyModel& model, const Scene& scene, double step_s) {
  std::string text = header_text(model, scene, step_s) +
                     "<worldbody>\n<geom class=\"ground\" name=\"ground\" type=\"plane\" size=\"0 0 1\"" +
                     attribute("quat", text_of(scene.ground)) + "/>\n";
  for (const Box& box : scene.boxes) {
    text += box_text(box);
  }
  text += "<body name=\"trunk\">\n<freejoint name=\"trunk\"/>\n" + inertial(model.trunk);
  if (model.box) {
    text += trunk_box_text(*model.box);
  }
  for (std::size_t leg = 0; leg < model.legs.size(); ++leg) {
    text += leg_text(model.legs[leg], std::to_string(leg));
  }
  return text + "</body>\n</worldbody>\n</mujoco>\n";
}

}  // namespace farrier::body
