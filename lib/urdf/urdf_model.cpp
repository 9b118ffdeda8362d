#include "urdf/urdf_model.hpp"

namespace farrier::urdf {

const char* to_string(UrdfJointType type) noexcept {
  switch (type) {
    case UrdfJointType::kRevolute:
      return "revolute";
    case UrdfJointType::kContinuous:
      return "continuous";
    case UrdfJointType::kPrismatic:
      return "prismatic";
    case UrdfJointType::kFixed:
      return "fixed";
    case UrdfJointType::kFloating:
      return "floating";
    case UrdfJointType::kPlanar:
      return "planar";
  }
  return "?";
}

}  // namespace farrier::urdf
