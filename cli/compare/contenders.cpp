#include "cli/compare/contenders.hpp"

#include "trials/grey_box.hpp"

namespace farrier::cli {
namespace {

using report::Contender;

control::Kind kind_of(Contender contender) noexcept {
  switch (contender) {
    case Contender::kAdaptive:
    case Contender::kPerfect:
    case Contender::kStance:
    case Contender::kSwing:
      break;
    case Contender::kFeedbackLinearisation:
      return control::Kind::kFeedbackLinearisation;
    case Contender::kPid:
      return control::Kind::kPid;
    case Contender::kGreyBox:
      return control::Kind::kFlowInversion;
  }
  return control::Kind::kLqr;
}

}  // namespace

robot::Robot believed_by(Contender contender, const robot::Robot& nominal) {
  robot::Robot robot = contender == Contender::kGreyBox ? trials::with_grey_box(nominal) : nominal;
  for (robot::Joint& joint : robot.joints) {
    joint.kind = kind_of(contender);
    joint.dither_percent = contender == Contender::kAdaptive ? joint.dither_percent : 0.0;
  }
  if (contender == Contender::kPerfect) {
    robot.safety.stance_lead_s = 0.0;
  }
  return robot;
}

run::InprocRun run_of(Contender contender, const robot::Robot& world) {
  run::InprocRun run;
  run.grouping = run::Grouping::kOne;
  run.simulated = &world;
  switch (contender) {
    case Contender::kAdaptive:
    case Contender::kGreyBox:
      run.design = supervisor::Design::kAdaptive;
      break;
    case Contender::kPerfect:
      run.design = supervisor::Design::kPhases;
      run.designer = &world;
      run.announce = locomotion::Announce::kActual;
      break;
    case Contender::kStance:
      run.design = supervisor::Design::kStance;
      break;
    case Contender::kSwing:
      run.design = supervisor::Design::kSwing;
      break;
    case Contender::kFeedbackLinearisation:
    case Contender::kPid:
      break;  // take no gains
  }
  return run;
}

}  // namespace farrier::cli
