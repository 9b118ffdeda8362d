#include "locomotion/mode_sequencer.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::locomotion {

double ModeSequencer::height_m(const MotionCommand& command, const TrunkReference& reference) const noexcept {
  switch (mode_) {
    case Mode::kLie:
    case Mode::kFallen:
      return reference.height_m();
    case Mode::kSitDown:
      return params_.folded_height_m;
    case Mode::kStandUp:
      return force_share_ < 1.0 ? reference.height_m() : reference.commanded_height_m(command);
    case Mode::kStand:
    case Mode::kTrot:
    case Mode::kStop:
      break;
  }
  return reference.commanded_height_m(command);
}

Mode ModeSequencer::next(const MotionCommand& command, const TrunkReference& reference,
                         const TrotSchedule& schedule) const noexcept {
  const double to_go = std::abs(reference.height_m() - height_m(command, reference));
  const bool arrived = to_go < params_.height_tolerance_m;
  switch (mode_) {
    case Mode::kLie:
      return command.request != Request::kLie && soft_start_ >= 1.0 && force_share_ <= 0.0 ? Mode::kStandUp : mode_;
    case Mode::kStandUp:
      if (command.request == Request::kLie) {
        return Mode::kSitDown;
      }
      return force_share_ >= 1.0 && arrived ? Mode::kStand : mode_;
    case Mode::kStand:
      return command.request == Request::kTrot ? Mode::kTrot
                                               : (command.request == Request::kLie ? Mode::kSitDown : mode_);
    case Mode::kTrot:
      return command.request == Request::kTrot ? mode_ : Mode::kStop;
    case Mode::kStop:
      return schedule.walking() ? (command.request == Request::kTrot ? Mode::kTrot : mode_) : Mode::kStand;
    case Mode::kSitDown:
      if (command.request != Request::kLie) {
        return Mode::kStandUp;
      }
      return arrived && force_share_ <= 0.0 ? Mode::kLie : mode_;
    case Mode::kFallen:
      break;
  }
  return mode_;
}

void ModeSequencer::step(Tick now, const MotionCommand& command, double up, const TrunkReference& reference,
                         TrotSchedule& schedule) noexcept {
  const Mode before = mode_;
  const bool upright = up > params_.fallen_cosine;  // false for NaN
  mode_ = upright ? next(command, reference, schedule) : Mode::kFallen;
  entered_ = mode_ != before;
  soft_start_ = std::min(1.0, soft_start_ + period_s_ / params_.soft_start_s);
  const bool low = std::abs(reference.height_m() - params_.folded_height_m) < params_.height_tolerance_m;
  const bool pose = mode_ == Mode::kLie || (mode_ == Mode::kSitDown && low);
  const double change = period_s_ / params_.take_load_s;
  force_share_ = std::clamp(force_share_ + (pose ? -change : change), 0.0, 1.0);
  if (mode_ == Mode::kTrot) {
    schedule.start(now);
  }
  rest_s_ = mode_ == Mode::kStop && reference.at_rest() ? rest_s_ + period_s_ : 0.0;
  const bool stops = command.feet_down || rest_s_ > (command.at_once ? 0.0 : params_.settle_s);
  if (mode_ == Mode::kFallen || (mode_ == Mode::kStop && stops)) {
    schedule.stop();
  }
}

}  // namespace farrier::locomotion
