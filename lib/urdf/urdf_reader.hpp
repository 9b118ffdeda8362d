#pragma once

#include <string>

#include "config/problem.hpp"
#include "core/result.hpp"
#include "urdf/urdf_model.hpp"

namespace farrier::urdf {

/// Reads a URDF without xacro. Refuses all mistakes together, with their lines: XML that is damaged or has another root,
/// names given twice, numbers that are none, axes of length zero, inertias that no masses can have. Links must be a tree:
/// joints between links that are there, one root, one parent each, no loop.
Result<UrdfModel, config::Problems> read_urdf_text(const std::string& text, const std::string& file);

/// The text of a file. Refuses one that cannot be read or is empty.
Result<std::string, config::Problems> urdf_file_text(const std::string& path);

/// read_urdf_text() of a file.
Result<UrdfModel, config::Problems> read_urdf(const std::string& path);

}  // namespace farrier::urdf
