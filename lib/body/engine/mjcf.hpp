#pragma once

#include <string>

#include "body/model/body_model.hpp"
#include "body/scene/scene.hpp"

namespace farrier::body {

/// Model and scene as MJCF, MuJoCo's XML. Every number is written with all its digits. Bodies and geoms are named:
/// "trunk"; "0/0" to "0/2" for the links and joints of the first leg; "0/foot" for its foot's geom and site.
std::string mjcf_text(const BodyModel& model, const Scene& scene, double step_s);

}  // namespace farrier::body
