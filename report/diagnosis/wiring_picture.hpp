#pragma once

#include <string>

#include "diagnosis/wiring/wiring_evidence.hpp"
#include "report/page/draw_pictures.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

/// Adds the picture of a fault of wiring: both sides of the law that shows it best, in the second in which they are
/// furthest apart, as recorded and below with the fault undone. Its path; empty if the law has no two points.
std::string add_wiring_picture(Drawing& drawing, const diagnosis::WiringEvidence& evidence, const robot::Joint& joint);

/// Caption of that picture.
std::string wiring_caption(const diagnosis::WiringEvidence& evidence, const robot::Joint& joint);

}  // namespace farrier::report
