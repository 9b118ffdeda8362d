#include "robot/description_format.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace farrier::robot {
namespace {

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 64;
  std::string result(text.substr(0, kLongest));
  std::ranges::replace_if(
      result, [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

/// Text of an attribute of an XML tag, empty for none.
std::string attribute(std::string_view tag, const std::string& name) {
  for (const char quote : {'"', '\''}) {
    const std::string begin = name + "=" + quote;
    for (std::size_t at = tag.find(begin); at != std::string_view::npos; at = tag.find(begin, at + 1)) {
      if (at > 0 && (tag[at - 1] == ' ' || tag[at - 1] == '\t' || tag[at - 1] == '\n' || tag[at - 1] == '\r')) {
        const std::size_t from = at + begin.size();
        const std::size_t to = tag.find(quote, from);
        return to == std::string_view::npos ? "" : printable(tag.substr(from, to - from));
      }
    }
  }
  return "";
}

/// The tag that begins at or behind `from`, its own place in `from`; empty for none.
std::string_view next_tag(std::string_view text, const std::string& name, std::size_t& from) {
  for (from = text.find("<" + name, from); from != std::string_view::npos; from = text.find("<" + name, from + 1)) {
    const std::size_t behind = from + name.size() + 1;
    if (behind < text.size() && std::string_view(" \t\r\n>/").find(text[behind]) != std::string_view::npos) {
      return text.substr(from, std::min(text.find('>', from), text.size()) - from);
    }
  }
  return {};
}

std::string without_comments(std::string text) {
  for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at)) {
    const std::size_t end = text.find("-->", at);
    const std::size_t last = end == std::string::npos ? text.size() : end + 3;
    const auto lines = std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                  text.begin() + static_cast<std::ptrdiff_t>(last), '\n');
    text.replace(at, last - at, std::string(static_cast<std::size_t>(lines), '\n'));
  }
  return text;
}

/// The limits of moving joints, "hip: torque_limit_Nm: 23.7, speed_limit_rad_s: 30.1" each, at most six.
std::string limits_of_urdf(std::string_view text) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string> found;
  std::size_t at = 0;
  for (std::string_view tag = next_tag(text, "joint", at); !tag.empty(); tag = next_tag(text, "joint", ++at)) {
    const std::size_t end = std::min(text.find("</joint", at), text.size());
    std::size_t limit_at = at;
    const std::string_view limit = next_tag(text, "limit", limit_at);
    const std::string effort = attribute(limit, "effort");
    if (!limit.empty() && limit_at < end && !effort.empty()) {
      found.push_back(attribute(tag, "name") + ": torque_limit_Nm: " + effort +
                      ", speed_limit_rad_s: " + attribute(limit, "velocity"));
    }
  }
  std::string listed;
  for (std::size_t i = 0; i < std::min(found.size(), kMost); ++i) {
    listed += "\n  " + found[i];
  }
  return found.size() <= kMost ? listed : listed + "\n  and " + std::to_string(found.size() - kMost) + " more";
}

}  // namespace

std::optional<config::Problem> foreign_description(const std::string& text, const std::string& file) {
  const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (first == std::string::npos || text[first] != '<') {
    return std::nullopt;
  }
  const std::string plain = without_comments(text);
  struct Format {
    const char* tag;
    const char* name;
  };
  for (const Format& format :
       {Format{"robot", "a URDF"}, Format{"sdf", "an SDF file"}, Format{"mujoco", "an MJCF file"}}) {
    std::size_t at = 0;
    const std::string_view tag = next_tag(plain, format.tag, at);
    if (tag.empty()) {
      continue;
    }
    const bool urdf = std::string_view(format.tag) == "robot";
    const bool xacro = urdf && (plain.find("<xacro:") != std::string::npos);
    const int line =
        1 + static_cast<int>(std::count(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    const std::string robot = attribute(tag, urdf ? "name" : "model");
    const std::string limits = urdf && !xacro ? limits_of_urdf(plain) : "";
    return config::Problem{
        file, line, "",
        std::string("is ") + (xacro ? "a xacro file" : format.name) + (robot.empty() ? "" : " of " + robot) +
            ", not a robot file: copy go1.yaml of the shipped robots, which was written from a URDF, and give "
            "each joint's effort as torque_limit_Nm, its velocity as speed_limit_rad_s and its rotor's "
            "inertia as armature_kg_m2 (docs/robots.md, From a URDF)" +
            limits};
  }
  return config::Problem{file, 1, "", "is XML, not a robot file: give a YAML file, as docs/robots.md explains"};
}

}  // namespace farrier::robot
