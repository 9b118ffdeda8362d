#include "trials/grey_box.hpp"

#include <algorithm>

namespace farrier::trials {

robot::Robot with_grey_box(robot::Robot robot) {
  const robot::EstimatorSection* section = config::find(robot.file.estimators, "greybox");
  for (robot::Joint& joint : robot.joints) {
    const int blank_ticks = joint.estimator.blank_ticks;
    if (section != nullptr) {
      joint.estimator = section->params;
    } else {
      joint.estimator = {};
      joint.estimator.method = estimation::EstimationMethod::kGreyBox;
      joint.estimator.grey_box.emplace();
      joint.estimator.blank_ticks = blank_ticks;  // touchdowns jitter as they did
    }
    joint.kind = control::Kind::kFlowInversion;
    joint.dither_percent = 0.0;
  }
  return robot;
}

}  // namespace farrier::trials
