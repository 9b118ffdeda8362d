#pragma once

// The whole robot with plants that no design knows, under fixed designs, adaptation and perfect knowledge.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "trials/body/plant_rows.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::trials {

/// Speed error, share, from which on a run counts as a fall: the robot lay down, or hardly walks.
inline constexpr double kDoesNotWalk = 0.5;

/// True if a robot of the study fell, lay down or was not simulated.
bool is_lost(const TrotRow& run) noexcept;

/// A ground and a gait.
struct StudyCondition {
  const char* name;      ///< of one word
  const char* sentence;  ///< for people
  double speed_m_s;
  double block_height_m;                  ///< of HyQ; 0: flat
  double frequency_Hz = 0.0, duty = 0.0;  ///< of the gait; 0: the file's
};
inline constexpr std::array kStudyConditions{
    StudyCondition{"easy", "0.4 m/s over blocks up to 4 cm", 0.4, 0.04},
    StudyCondition{"fast", "1.0 m/s on flat ground with 2 strides a second", 1.0, 0.0, 2.0, 0.6},
    StudyCondition{"rough", "0.4 m/s over blocks up to 8 cm", 0.4, 0.08}};

/// Names of the designs of study_designs().
inline constexpr const char* kNominal = "nominal";
inline constexpr const char* kTuned = "tuned";
inline constexpr const char* kObserver = "observer";
inline constexpr const char* kThesis = "thesis";
inline constexpr const char* kAdaptive = "adaptive";
inline constexpr const char* kPerfect = "perfect";

/// A design that walks through all rows and conditions.
struct StudyDesign {
  std::string name;      ///< of one word
  std::string sentence;  ///< for people
  robot::Robot robot;
  bool adapts = false, knows = false;
};

/// The designs in the order of their names above. Nominal is the file's. Tuned was found by FixedSearch over all rows, and
/// the observer is added to it. Thesis is LQR with recursive least squares. Adaptive is the file's with the valve that its
/// estimator finds. Perfect is the file's with the true valve, overlap and leakage at each tick. `with_rls` is of the same
/// file, with the estimators of the bench.
std::vector<StudyDesign> study_designs(const robot::Robot& on_ground, const robot::Robot& with_rls);

/// The adaptive design with none, a tenth, all and three times of the noise of its joints' sensors, named "noise_0",
/// "noise_10", "noise_100" and "noise_300". The noise of the IMU stays.
std::vector<StudyDesign> noise_designs(const robot::Robot& on_ground);

/// A fixed design with these gains on every joint.
StudyDesign fixed_design(const robot::Robot& on_ground, const std::string& name, const std::string& sentence,
                         const control::FeedbackLinearisationGains& gains);

/// The robot of a design with the gait of a condition.
robot::Robot with_gait(robot::Robot robot, const StudyCondition& condition);

/// The run as a case: its trial is "row, condition", its name "design, seed". Figures are over the time from three strides
/// after a step on, from the begin of a drift, or from 4 s of walking on.
TrotCase study_case(const StudyDesign& design, const PlantRow& row, const StudyCondition& condition,
                    std::uint64_t seed);

/// RMS over the kinds of joint of the force errors in stance.
double stance_nrmse(const ForceErrors& errors) noexcept;

}  // namespace farrier::trials
