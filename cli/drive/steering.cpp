#include "cli/drive/steering.hpp"

#include <algorithm>
#include <cmath>

#include "report/figures/text_format.hpp"

namespace farrier::cli {
namespace {

using locomotion::MotionCommand;

constexpr double kStep_m_s = 0.1;
constexpr double kStep_rad_s = 0.1;

// Whole steps, so that steps up and down lead back to zero.
double stepped(double value, double change, double limit) noexcept {
  const double step = std::abs(change);
  return std::clamp(std::round((value + change) / step) * step, -limit, limit);
}

}  // namespace

void Steering::walk(double forward_m_s, double left_m_s, double yaw_rate_rad_s) noexcept {
  if (command_.request != MotionRequest::kTrot) {
    command_ = {.request = MotionRequest::kTrot};
  }
  if (forward_m_s != 0.0) {
    command_.forward_m_s = stepped(command_.forward_m_s, forward_m_s, limits_.fastest_forward_m_s);
  }
  if (left_m_s != 0.0) {
    command_.left_m_s = stepped(command_.left_m_s, left_m_s, limits_.fastest_left_m_s);
  }
  if (yaw_rate_rad_s != 0.0) {
    command_.yaw_rate_rad_s = stepped(command_.yaw_rate_rad_s, yaw_rate_rad_s, limits_.fastest_yaw_rad_s);
  }
}

void Steering::press(Key key) noexcept {
  if (ending_ && key != Key::kNull) {
    return;
  }
  switch (key) {
    case Key::kFaster:
      walk(kStep_m_s, 0.0, 0.0);
      break;
    case Key::kSlower:
      walk(-kStep_m_s, 0.0, 0.0);
      break;
    case Key::kTurnLeft:
      walk(0.0, 0.0, kStep_rad_s);
      break;
    case Key::kTurnRight:
      walk(0.0, 0.0, -kStep_rad_s);
      break;
    case Key::kLeft:
      walk(0.0, kStep_m_s, 0.0);
      break;
    case Key::kRight:
      walk(0.0, -kStep_m_s, 0.0);
      break;
    case Key::kStop:
      command_ = {.request = MotionRequest::kStand};
      break;
    case Key::kLie:
      command_ = {.request = MotionRequest::kLie};
      break;
    case Key::kEnd:
      command_ = {.request = MotionRequest::kLie};
      ending_ = true;
      break;
    case Key::kNull:
      nulled_ = true;
      break;
  }
}

std::string Steering::text() const {
  std::string text = to_string(mode_);
  if (command_.request == MotionRequest::kTrot) {
    text += ", forward " + report::short_number(command_.forward_m_s) + " m/s, left " +
            report::short_number(command_.left_m_s) + " m/s, turning left " +
            report::short_number(command_.yaw_rate_rad_s) + " rad/s";
  } else {
    text += std::string(", asked to ") + to_string(command_.request);
  }
  return text;
}

}  // namespace farrier::cli
