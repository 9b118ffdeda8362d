#pragma once

#include <string>

#include "config/problem.hpp"
#include "core/result.hpp"
#include "urdf/urdf_model.hpp"

namespace farrier::urdf {

/// Reads a URDF without xacro. Refuses, all mistakes together with their lines: XML that is damaged, another root than
/// robot, names given twice, joints between links that are not there, links with two parents, none or several roots,
/// loops, numbers that are none, axes of length zero, and inertias that no masses can have.
Result<UrdfModel, config::Problems> read_urdf_text(const std::string& text, const std::string& file);

/// The same, of a file.
Result<UrdfModel, config::Problems> read_urdf(const std::string& path);

}  // namespace farrier::urdf
