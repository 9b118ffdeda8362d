#include "robot/description_format.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <string_view>

namespace farrier::robot {
namespace {

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 64;
  std::string result(text.substr(0, kLongest));
  std::ranges::replace_if(
      result, [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

/// Printable text of an attribute of an element, either of which may be missing; empty for none.
std::string attribute(const tinyxml2::XMLElement* element, const char* name) {
  const char* const value = element == nullptr ? nullptr : element->Attribute(name);
  return value == nullptr ? "" : printable(value);
}

/// The limits of moving joints, and whether there is an element for xacro.
class Survey : public tinyxml2::XMLVisitor {
 public:
  bool VisitEnter(const tinyxml2::XMLElement& element, const tinyxml2::XMLAttribute* /*first*/) override {
    const std::string_view name = element.Name();
    xacro_ = xacro_ || name.starts_with("xacro:");
    const tinyxml2::XMLElement* const limit = name == "joint" ? element.FirstChildElement("limit") : nullptr;
    if (const std::string effort = attribute(limit, "effort"); !effort.empty() && ++joints_ <= kMost) {
      limits_ += "\n  " + attribute(&element, "name") + ": torque_limit_Nm: " + effort +
                 ", speed_limit_rad_s: " + attribute(limit, "velocity");
    }
    return true;
  }

  bool xacro() const { return xacro_; }
  /// "hip: torque_limit_Nm: 23.7, speed_limit_rad_s: 30.1" each, at most six.
  std::string limits() const {
    return joints_ <= kMost ? limits_ : limits_ + "\n  and " + std::to_string(joints_ - kMost) + " more";
  }

 private:
  static constexpr int kMost = 6;
  bool xacro_ = false;
  int joints_ = 0;
  std::string limits_;
};

}  // namespace

std::optional<config::Problem> foreign_description(const std::string& text, const std::string& file) {
  const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (first == std::string::npos || text[first] != '<') {
    return std::nullopt;
  }
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  const tinyxml2::XMLElement* const root = document.RootElement();
  Survey survey;
  document.Accept(&survey);
  struct Format {
    const char* tag;
    const char* name;
  };
  for (const Format& format : {Format{"xacro:", "a xacro file"}, Format{"robot", "a URDF"},
                               Format{"sdf", "an SDF file"}, Format{"mujoco", "an MJCF file"}}) {
    const std::string_view tag = survey.xacro() ? "xacro:" : root == nullptr ? "" : root->Name();
    // tinyxml2 keeps no element of a damaged description, or of the begin of a long one.
    if (document.Error() ? text.find(std::string("<") + format.tag) == std::string::npos : tag != format.tag) {
      continue;
    }
    const std::string robot = attribute(root, tag == "mujoco" ? "model" : "name");
    return config::Problem{
        file, std::max(1, root == nullptr ? document.ErrorLineNum() : root->GetLineNum()), "",
        std::string("is ") + format.name + (robot.empty() ? "" : " of " + robot) +
            ", not a robot file: copy go1.yaml of the shipped robots, which was written from a URDF, and give "
            "each joint's effort as torque_limit_Nm, its velocity as speed_limit_rad_s and its rotor's "
            "inertia as armature_kg_m2 (docs/robots.md, From a URDF)" +
            (tag == "robot" ? survey.limits() : "")};
  }
  return config::Problem{file, 1, "", "is XML, not a robot file: give a YAML file, as docs/robots.md explains"};
}

}  // namespace farrier::robot
