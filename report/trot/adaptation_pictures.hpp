#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/page/draw_pictures.hpp"
#include "report/trot/html_report.hpp"

namespace farrier::report {

/// True if the supervisor decided anything about the joint.
bool adapted(const ReportInput& input, const robot::Joint& joint);

/// Adds velocity and force gain of both slots over time, against those for the true loads. `end_s`: end of the run.
/// Returns the picture's path. Refuses a joint without a controller.
Result<std::string> add_gains_picture(Drawing& drawing, const ReportInput& input, const robot::Joint& joint,
                                      double end_s);

/// Adds the poles of every estimate decided on, against those of the true loads. Returns the picture's path.
std::string add_estimates_picture(Drawing& drawing, const ReportInput& input, const robot::Joint& joint);

/// A picture of poles in the complex plane up to `radius`, with the unit circle.
Picture pole_picture(std::vector<Series> poles, double radius);

}  // namespace farrier::report
