#include "gait/foot_path.hpp"

#include "gait/smooth_step.hpp"

namespace farrier::gait {

PointMotion foot_motion(const FootPath& path, double since_touchdown_s) noexcept {
  const double speed = path.step_length_m / path.stance_s;
  PointMotion motion;
  // Stance, and what swing adds its return to:  x = S/2 - (S / T_s) t
  motion.position.x() = 0.5 * path.step_length_m - speed * since_touchdown_s;
  motion.velocity.x() = -speed;
  if (since_touchdown_s <= path.stance_s) {
    return motion;
  }
  // Swing, u = (t - T_s) / T_w:  x += (S / T_s)(T_s + T_w) step(u),  z = H hump(u)
  const double u = (since_touchdown_s - path.stance_s) / path.swing_s;
  const double way = speed * (path.stance_s + path.swing_s);
  const Smooth step = smooth_step(u);
  const Smooth hump = smooth_hump(u);
  const double rate = 1.0 / path.swing_s;
  motion.position.x() += way * step.value;
  motion.velocity.x() += way * step.slope * rate;
  motion.acceleration.x() = way * step.curvature * rate * rate;
  motion.position.z() = path.step_height_m * hump.value;
  motion.velocity.z() = path.step_height_m * hump.slope * rate;
  motion.acceleration.z() = path.step_height_m * hump.curvature * rate * rate;
  return motion;
}

}  // namespace farrier::gait
