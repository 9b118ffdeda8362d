#include "urdf/urdf_reader.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/text.hpp"

namespace farrier::urdf {
namespace {

using Eigen::Vector3d;
using tinyxml2::XMLElement;

constexpr std::array kTypes = {UrdfJointType::kRevolute, UrdfJointType::kContinuous, UrdfJointType::kPrismatic,
                               UrdfJointType::kFixed,    UrdfJointType::kFloating,   UrdfJointType::kPlanar};

class Reader {
 public:
  Reader(std::string file, const XMLElement& root) : root_(root) { model_.file = std::move(file); }

  Result<UrdfModel, config::Problems> read() {
    const char* const name = root_.Attribute("name");
    model_.name = name == nullptr ? "" : name;
    for (const XMLElement* e = root_.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      const std::string tag = e->Name();
      if (tag.starts_with("xacro:")) {
        problem(*e, "", "is xacro: expand it first, xacro robot.urdf.xacro > robot.urdf");
      } else if (tag == "link") {
        read_link(*e);
      } else if (tag != "joint" && tag != "material") {
        ++model_.other_elements[tag];
      }
    }
    for (const XMLElement* e = root_.FirstChildElement("joint"); e != nullptr; e = e->NextSiblingElement("joint")) {
      read_joint(*e);
    }
    check_tree();
    if (!problems_.empty()) {
      config::sort_by_line(problems_);
      return problems_;
    }
    return std::move(model_);
  }

 private:
  void problem(const XMLElement& at, const std::string& where, const std::string& message) {
    problems_.push_back({model_.file, at.GetLineNum(), where, message});
  }

  std::string name_of(const XMLElement& element) {
    const char* const name = element.Attribute("name");
    if (name == nullptr || *name == '\0') {
      problem(element, element.Name(), "has no name: give one");
      return "";
    }
    return name;
  }

  /// The numbers of an attribute; `otherwise` without it, and after a problem.
  std::vector<double> numbers(const XMLElement& e, const char* name, std::vector<double> otherwise) {
    const char* const text = e.Attribute(name);
    if (text == nullptr) {
      return otherwise;
    }
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    std::vector<double> values;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end != '\0' || !std::isfinite(value)) {
        problem(e, e.Name(), std::string(name) + ": '" + word + "' is no number");
        return otherwise;
      }
      values.push_back(value);
    }
    if (values.size() != otherwise.size()) {
      problem(e, e.Name(), std::string(name) + ": give " + counted(otherwise.size(), "number"));
      return otherwise;
    }
    return values;
  }

  double number(const XMLElement& e, const char* name, double otherwise) { return numbers(e, name, {otherwise})[0]; }

  std::optional<double> optional_number(const XMLElement* e, const char* name) {
    return e == nullptr || e->Attribute(name) == nullptr ? std::nullopt : std::optional(number(*e, name, 0.0));
  }

  Vector3d vector(const XMLElement& e, const char* name, const Vector3d& otherwise) {
    const std::vector<double> v = numbers(e, name, {otherwise.x(), otherwise.y(), otherwise.z()});
    return {v[0], v[1], v[2]};
  }

  // rpy are fixed-axis angles: R = Rz(yaw) Ry(pitch) Rx(roll).
  Eigen::Isometry3d origin_of(const XMLElement& parent) {
    Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();
    if (const XMLElement* const e = parent.FirstChildElement("origin")) {
      const Vector3d rpy_rad = vector(*e, "rpy", Vector3d::Zero());
      origin = Eigen::Translation3d(vector(*e, "xyz", Vector3d::Zero())) *
               Eigen::AngleAxisd(rpy_rad.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy_rad.y(), Vector3d::UnitY()) *
               Eigen::AngleAxisd(rpy_rad.x(), Vector3d::UnitX());
    }
    return origin;
  }

  body::RigidInertia read_inertia(const XMLElement& inertial, const std::string& link) {
    const Eigen::Isometry3d origin = origin_of(inertial);
    body::RigidInertia inertia;
    inertia.com_m = origin.translation();
    if (const XMLElement* const mass = inertial.FirstChildElement("mass")) {
      inertia.mass_kg = number(*mass, "value", 0.0);
    }
    if (const XMLElement* const e = inertial.FirstChildElement("inertia")) {
      const double xy = number(*e, "ixy", 0.0);
      const double xz = number(*e, "ixz", 0.0);
      const double yz = number(*e, "iyz", 0.0);
      Eigen::Matrix3d tensor;
      tensor << number(*e, "ixx", 0.0), xy, xz, xy, number(*e, "iyy", 0.0), yz, xz, yz, number(*e, "izz", 0.0);
      inertia.tensor_kg_m2 = origin.linear() * tensor * origin.linear().transpose();
    }
    if (inertia.mass_kg < 0.0 || !body::is_possible_tensor(inertia.tensor_kg_m2)) {
      problem(inertial, link,
              inertia.mass_kg < 0.0
                  ? "has a negative mass"
                  : std::string("has a tensor about its centre of mass that ") + body::kImpossibleTensor);
    }
    return inertia;
  }

  void read_link(const XMLElement& e) {
    UrdfLink link{.name = name_of(e), .line = e.GetLineNum()};
    if (link_named(link.name) >= 0) {
      problem(e, link.name, "is a second link of that name");
    }
    if (const XMLElement* const inertial = e.FirstChildElement("inertial")) {
      link.inertia = read_inertia(*inertial, link.name);
    }
    for (const char* use : {"visual", "collision"}) {
      for (const XMLElement* u = e.FirstChildElement(use); u != nullptr; u = u->NextSiblingElement(use)) {
        const XMLElement* const geometry = u->FirstChildElement("geometry");
        link.has_mesh = link.has_mesh || (geometry != nullptr && geometry->FirstChildElement("mesh") != nullptr);
      }
    }
    model_.links.push_back(std::move(link));
  }

  /// Place of the link of that name; -1 for none.
  int link_named(const std::string& name) const {
    const auto found = std::ranges::find(model_.links, name, &UrdfLink::name);
    return found == model_.links.end() ? -1 : static_cast<int>(found - model_.links.begin());
  }

  int end_of(const XMLElement& joint, const std::string& name, const char* end) {
    const XMLElement* const e = joint.FirstChildElement(end);
    const char* const link = e == nullptr ? nullptr : e->Attribute("link");
    const int place = link == nullptr ? -1 : link_named(link);
    if (place < 0) {
      problem(joint, name,
              link == nullptr ? std::string("has no ") + end + ": give a link"
                              : std::string("has a ") + end + " that is no link: '" + link + "'");
    }
    return place;
  }

  void read_joint(const XMLElement& e) {
    UrdfJoint joint{.name = name_of(e), .line = e.GetLineNum()};
    const char* const type = e.Attribute("type");
    const auto* const found = std::ranges::find_if(
        kTypes, [&](UrdfJointType t) { return type != nullptr && std::string(to_string(t)) == type; });
    if (found == kTypes.end()) {
      problem(e, joint.name,
              "has no type that URDF knows: give revolute, continuous, prismatic, fixed, floating or planar");
      return;
    }
    joint.type = *found;
    joint.parent = end_of(e, joint.name, "parent");
    joint.child = end_of(e, joint.name, "child");
    joint.origin = origin_of(e);
    if (const XMLElement* const axis = e.FirstChildElement("axis")) {
      joint.axis = vector(*axis, "xyz", Vector3d::UnitX());
      if (joint.axis.norm() == 0.0 && joint.moves()) {
        problem(*axis, joint.name, "has an axis of length zero");
      }
      joint.axis.normalize();
    }
    const XMLElement* const limit = e.FirstChildElement("limit");
    joint.lower_rad = optional_number(limit, "lower");
    joint.upper_rad = optional_number(limit, "upper");
    joint.effort_Nm = optional_number(limit, "effort");
    joint.velocity_rad_s = optional_number(limit, "velocity");
    joint.damping_Nms_rad = optional_number(e.FirstChildElement("dynamics"), "damping");
    joint.friction_Nm = optional_number(e.FirstChildElement("dynamics"), "friction");
    if (const XMLElement* const mimic = e.FirstChildElement("mimic"); mimic != nullptr && mimic->Attribute("joint")) {
      joint.mimics = mimic->Attribute("joint");
    }
    if (std::ranges::find(model_.joints, joint.name, &UrdfJoint::name) != model_.joints.end()) {
      problem(e, joint.name, "is a second joint of that name");
    }
    model_.joints.push_back(std::move(joint));
  }

  // A tree: each link but one is a child once, and the way up from each link ends at that one.
  void check_tree() {
    if (!problems_.empty()) {
      return;
    }
    std::vector<int> parent_of(model_.links.size(), -1);
    for (const UrdfJoint& joint : model_.joints) {
      int& parent = parent_of[static_cast<std::size_t>(joint.child)];
      if (parent >= 0) {
        problems_.push_back(
            {model_.file, joint.line, joint.name,
             "moves a link that another joint moves: " + model_.links[static_cast<std::size_t>(joint.child)].name});
      }
      parent = joint.parent;
    }
    const auto roots = std::ranges::count(parent_of, -1);
    if (roots != 1) {
      problems_.push_back({model_.file, root_.GetLineNum(), "",
                           "has " + counted(static_cast<std::uint64_t>(roots), "root link") +
                               ": one link alone must be the child of no joint"});
      return;
    }
    model_.root = static_cast<int>(std::ranges::find(parent_of, -1) - parent_of.begin());
    for (std::size_t link = 0; link < parent_of.size(); ++link) {
      int at = static_cast<int>(link);
      for (std::size_t steps = 0; at >= 0 && steps <= parent_of.size(); ++steps) {
        at = parent_of[static_cast<std::size_t>(at)];
      }
      if (at >= 0) {
        problems_.push_back({model_.file, model_.links[link].line, model_.links[link].name, "is part of a loop"});
      }
    }
  }

  const XMLElement& root_;
  UrdfModel model_;
  config::Problems problems_;
};

}  // namespace

Result<UrdfModel, config::Problems> read_urdf_text(const std::string& text, const std::string& file) {
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  const XMLElement* const root = document.RootElement();
  if (document.Error() || root == nullptr) {
    return config::Problems{{file, std::max(1, document.ErrorLineNum()), "",
                             "is no XML that can be read: give a URDF (" +
                                 std::string(document.Error() ? document.ErrorName() : "no element") + ")"}};
  }
  if (std::string(root->Name()) != "robot") {
    return config::Problems{
        {file, root->GetLineNum(), "", std::string("begins with <") + root->Name() + ">, a URDF with <robot>"}};
  }
  return Reader(file, *root).read();
}

Result<std::string, config::Problems> urdf_file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || text.str().empty()) {
    return config::Problems{{path, 0, "", "cannot be read, or is empty: give a URDF"}};
  }
  return text.str();
}

Result<UrdfModel, config::Problems> read_urdf(const std::string& path) {
  const std::string text = FARRIER_TRY(urdf_file_text(path));
  return read_urdf_text(text, path);
}

}  // namespace farrier::urdf
