#include "gait/gait_params.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "gait/foot_path.hpp"
#include "gait/leg_kinematics.hpp"
#include "gait/schedule.hpp"

namespace farrier::gait {
namespace {

// Ticks an announcement needs on top of the jitter to reach everybody before the switch.
constexpr Tick kAnnounceMargin = 2;

// A knee straighter than this has next to no leverage on the length of the leg, and velocities grow without bound.
constexpr double kStraightKnee_rad = 0.1;

class Complaints {
 public:
  void require(bool holds, const std::string& otherwise) {
    if (!holds) {
      text_ << (text_.tellp() > 0 ? "; " : "") << otherwise;
    }
  }
  bool none() { return text_.tellp() <= 0; }
  Result<Done> result() {
    return none() ? Result<Done>(Done{}) : Result<Done>(Error{"gait refused: " + text_.str()});
  }

 private:
  std::ostringstream text_;
};

bool within(double value, double low, double high) { return value >= low && value <= high; }  // false for NaN

void check_numbers(const RobotPlan& plan, Complaints& complaints) {
  constexpr double kHuge = 1e9;
  const GaitParams& gait = plan.gait;
  complaints.require(within(plan.period_s, 1e-6, 1.0), "period must be 1e-6..1 s");
  complaints.require(within(plan.body_weight_N, 0.0, kHuge), "body weight must be >= 0 N");
  complaints.require(within(gait.frequency_Hz, 1e-3, 1e3), "frequency must be 0.001..1000 Hz");
  complaints.require(gait.duty > 0.0 && gait.duty < 1.0, "duty must lie between 0 and 1, exclusive");
  complaints.require(within(gait.step_length_m, 0.0, kHuge), "step length must be >= 0 m");
  complaints.require(within(gait.step_height_m, 0.0, kHuge), "step height must be >= 0 m");
  complaints.require(within(gait.load_transfer_fraction, 0.0, 0.5), "load transfer must be 0..0.5 of the stance");
  complaints.require(within(gait.touchdown_jitter_s, 0.0, 1.0), "touchdown jitter must be 0..1 s");
  complaints.require(within(gait.lead_in_s, 0.0, 1e4), "lead-in must be 0..10000 s");
  complaints.require(gait.announce_ticks >= 1, "switches must be announced at least 1 tick ahead");
  complaints.require(!plan.legs.empty(), "a gait needs a leg");
  for (const LegPlan& leg : plan.legs) {
    complaints.require(leg.phase_offset >= 0.0 && leg.phase_offset < 1.0, leg.name + ": phase offset must be 0..1");
    complaints.require(!leg.joints.empty(), leg.name + ": a leg needs a joint");
  }
}

void check_phases(const RobotPlan& plan, Complaints& complaints) {
  const PhaseTicks ticks = phase_ticks(plan);
  const Tick shortest = std::min(ticks.stance, ticks.stride - ticks.stance);
  const Tick announce = plan.gait.announce_ticks;
  complaints.require(shortest >= 1, "frequency and duty leave a phase without a tick");
  if (plan.gait.pattern == Pattern::kStand) {
    return;  // no switch to announce
  }
  complaints.require(announce >= ticks.jitter + kAnnounceMargin,
                     "switches are announced " + std::to_string(announce) + " ticks ahead, which must exceed the " +
                         std::to_string(ticks.jitter) + " ticks of touchdown jitter by " +
                         std::to_string(kAnnounceMargin));
  complaints.require(announce < shortest, "the shorter phase has " + std::to_string(shortest) +
                                              " ticks and must be longer than the announcement of " +
                                              std::to_string(announce));
}

void check_multisine(const RobotPlan& plan, Complaints& complaints) {
  const GaitParams& gait = plan.gait;
  complaints.require(std::isfinite(gait.multisine_amplitude_N), "the multisine's amplitude must be finite");
  complaints.require(!gait.multisine_frequencies_Hz.empty(), "a multisine needs a frequency");
  for (const double frequency_Hz : gait.multisine_frequencies_Hz) {
    complaints.require(frequency_Hz > 0.0 && frequency_Hz * plan.period_s < 0.5,
                       "multisine frequencies must lie between 0 and half the sampling rate");
  }
}

bool reaches(const LegGeometry& geometry, const Eigen::Vector3d& foot) {
  const auto angles = ik(geometry, foot);
  return angles && std::abs((*angles)[2]) >= kStraightKnee_rad;
}

void check_reach(const LegPlan& leg, const RobotPlan& plan, Complaints& complaints) {
  constexpr int kPoints = 200;
  const GaitParams& gait = plan.gait;
  const bool trot = gait.pattern == Pattern::kTrot;
  const FootPath path{.step_length_m = trot ? gait.step_length_m : 0.0,
                      .step_height_m = trot ? gait.step_height_m : 0.0,
                      .stance_s = gait.duty / gait.frequency_Hz,
                      .swing_s = (1.0 - gait.duty) / gait.frequency_Hz};
  const LegGeometry& geometry = leg.geometry;
  Eigen::Vector3d neutral =
      fk(geometry, {leg.joints[0].home_angle_rad, leg.joints[1].home_angle_rad, leg.joints[2].home_angle_rad});
  const bool bends_its_way = reaches(geometry, neutral) && (leg.joints[2].home_angle_rad < 0.0) == geometry.front;
  complaints.require(bends_its_way, leg.name + ": home pose is not one the leg can stand in");
  neutral.z() = -gait.hip_height_m;
  for (int i = 0; i < kPoints; ++i) {
    const double since_touchdown_s = i / (kPoints * gait.frequency_Hz);
    if (!reaches(geometry, neutral + foot_motion(path, since_touchdown_s).position)) {
      complaints.require(false, leg.name + ": the foot's path leaves the leg's reach: lower the hip, shorten the step");
      return;
    }
  }
}

void check_legs(const RobotPlan& plan, Complaints& complaints) {
  for (const LegPlan& leg : plan.legs) {
    complaints.require(leg.joints.size() == 3, leg.name + ": leg kinematics need the joints HAA, HFE, KFE");
    const LegGeometry& geometry = leg.geometry;
    const bool lengths = geometry.upper_m > 0.0 && geometry.lower_m > 0.0 && geometry.hip_offset_m >= 0.0;
    complaints.require(lengths, leg.name + ": lengths must be positive");
    if (lengths && leg.joints.size() == 3) {
      check_reach(leg, plan, complaints);
    }
  }
}

}  // namespace

Result<Done> validate(const RobotPlan& plan) {
  Complaints complaints;
  check_numbers(plan, complaints);
  if (!complaints.none()) {
    return complaints.result();  // the rest computes with these numbers
  }
  check_phases(plan, complaints);
  if (plan.gait.reference == ReferenceKind::kMultisine) {
    check_multisine(plan, complaints);
  } else {
    check_legs(plan, complaints);
  }
  return complaints.result();
}

}  // namespace farrier::gait
