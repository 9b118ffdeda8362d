#include "trials/body/body_estimators.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "control/law/valve_opening.hpp"
#include "control/model/model_rows.hpp"
#include "core/median.hpp"
#include "estimation/estimator.hpp"
#include "estimator_service/estimator_service.hpp"
#include "robot/joint_model.hpp"

namespace farrier::trials {
namespace {

using estimation::EstimationMethod;
using estimator_service::EstimatorService;

robot::Robot with_method(const robot::Robot& robot, EstimationMethod method) {
  robot::Robot other = robot;
  for (robot::Joint& joint : other.joints) {
    joint.estimator.method = method;
  }
  return other;
}

/// The truth that estimates of one joint are held against.
struct JointTruth {
  control::DiscreteModel model;  // the valve open to either side, the mean
  plant::JointPhysics physics;
};

JointTruth truth_of(const robot::Robot& robot, const robot::Joint& joint, Phase phase) {
  const plant::LoadParams& load = phase == Phase::kStance ? joint.stance_load : joint.swing_load;
  return {robot::model_of(joint, load, robot.period_s, {.valve_sign = 0.0}), robot::nominal_physics(joint, load)};
}

/// One joint's last true states and inputs, newest last.
struct History {
  std::deque<Eigen::Vector3d> states;
  std::deque<double> currents_A;
};

/// Sums over all joints of a place.
struct Sums {
  EstimateScore score;
  std::vector<double> valve, oil, load, misfit;
  double errors = 0.0, changes = 0.0;
};

/// One method beside a walk.
class Candidate {
 public:
  static Result<Candidate> create(const robot::Robot& robot) {
    auto service = FARRIER_TRY(EstimatorService::create(robot, robot.loop_delay_lockstep));
    return Candidate(robot, std::move(service));
  }

  /// A measurement with the true change of force over the tick before, the states' change before that, and the inputs'.
  void take(const signals::JointMeasurement& measurement, const std::optional<Eigen::Vector3d>& change,
            double input_change_A, double force_change, bool judged) {
    const robot::Joint& joint = robot_.joints[measurement.joint];
    Sums& sums = sums_[static_cast<std::size_t>(joint.index_in_leg)][measurement.phase];
    const signals::JointModelEstimate& known = estimates_[measurement.joint];
    if (judged && change && known.validity > 0.0 && known.phase == measurement.phase) {
      const control::DiscreteModel model = control::model_of_rows(known.a, known.b);
      // The change of x[k+1] = A x[k] + B u[k] + c, which has no constant.
      const double error = force_change - model.a.row(2).dot(*change) - model.b(2) * input_change_A;
      sums.errors += error * error;
      sums.changes += force_change * force_change;
    }
    service_.take(measurement);
    if (robot_.estimate_due(measurement.tick)) {
      estimates_[measurement.joint] = service_.estimate(measurement.joint, measurement.tick);
      if (judged) {
        note(joint, estimates_[measurement.joint], sums);
      }
    }
  }

  EstimateScores scores() {
    EstimateScores all;
    for (std::size_t place = 0; place < all.size(); ++place) {
      for (const Phase phase : {Phase::kSwing, Phase::kStance}) {
        Sums& sums = sums_[place][phase];
        EstimateScore& score = all[place][phase];
        score = sums.score;
        score.valve_ratio = median_or_zero(sums.valve);
        score.oil_ratio = median_or_zero(sums.oil);
        score.load_ratio = median_or_zero(sums.load);
        score.misfit = median_or_zero(sums.misfit);
        score.force_error = sums.changes > 0.0 ? std::sqrt(sums.errors / sums.changes) : 0.0;
      }
    }
    return all;
  }

 private:
  Candidate(const robot::Robot& robot, EstimatorService service)
      : robot_(robot), service_(std::move(service)), estimates_(robot.joints.size()) {
    for (const robot::Joint& joint : robot.joints) {
      truths_.push_back({truth_of(robot, joint, Phase::kSwing), truth_of(robot, joint, Phase::kStance)});
    }
  }

  void note(const robot::Joint& joint, const signals::JointModelEstimate& estimate, Sums& sums) const {
    ++sums.score.estimates;
    for (std::size_t flag = 0; flag < sums.score.flags.size(); ++flag) {
      sums.score.flags[flag] += (estimate.flags & bit(estimation::kEstimateFlags[flag].value)) != 0 ? 1 : 0;
    }
    sums.score.valid += estimate.validity >= robot_.update_logic.validity_min ? 1 : 0;
    if (!(estimate.validity > 0.0)) {
      return;
    }
    ++sums.score.usable;
    sums.misfit.push_back(estimate.prediction_error);
    const JointTruth& truth = truths_[joint.number][static_cast<std::size_t>(estimate.phase)];
    if (estimate.has_physics != 0) {
      const plant::JointPhysics physics = plant::physics_of(estimate.physics);
      sums.valve.push_back(physics.valve_gain / truth.physics.valve_gain);
      sums.oil.push_back(physics.bulk_modulus / truth.physics.bulk_modulus);
      sums.load.push_back(physics.load_mass / truth.physics.load_mass);
      return;
    }
    const control::DiscreteModel model = control::model_of_rows(estimate.a, estimate.b);
    sums.valve.push_back(model.b(2) / truth.model.b(2));
    sums.oil.push_back(model.a(2, 1) / truth.model.a(2, 1));
    sums.load.push_back(truth.model.a(1, 2) / model.a(1, 2));
  }

  robot::Robot robot_;
  EstimatorService service_;
  std::vector<signals::JointModelEstimate> estimates_;  // newest, by joint
  std::vector<std::array<JointTruth, kPhaseCount>> truths_;
  std::array<PerPhase<Sums>, body::kJointsPerLeg> sums_{};
};

/// Feeds every candidate with the measurements of one walk.
class Audience {
 public:
  Audience(const robot::Robot& robot, std::vector<Candidate> candidates, Tick judged_from)
      : candidates_(std::move(candidates)),
        judged_from_(judged_from),
        histories_(robot.joints.size()),
        delay_(static_cast<std::size_t>(robot.loop_delay_lockstep)) {
    for (const robot::Joint& joint : robot.joints) {
      valves_.emplace_back(joint.effects, joint.actuator);
    }
  }

  void take(const signals::JointMeasurement& measurement, const trace::TraceRow& truth) {
    History& history = histories_[measurement.joint];
    history.states.push_back({truth.position_m_or_rad, truth.velocity_m_s_or_rad_s, truth.force_N_or_Nm});
    // Inputs that act between the last states: the current that answers the tick `delay` before.
    const std::size_t inputs = history.currents_A.size();
    std::optional<Eigen::Vector3d> change;
    double input_change_A = 0.0, force_change = 0.0;
    if (history.states.size() == 3 && inputs >= delay_ + 2) {
      change = history.states[1] - history.states[0];
      force_change = history.states[2](2) - history.states[1](2);
      input_change_A = history.currents_A[inputs - 1 - delay_] - history.currents_A[inputs - 2 - delay_];
    }
    for (Candidate& candidate : candidates_) {
      candidate.take(measurement, change, input_change_A, force_change, measurement.tick >= judged_from_);
    }
    history.currents_A.push_back(valves_[measurement.joint].at(measurement.valve_current_A));
    if (history.states.size() == 3) {
      history.states.pop_front();
    }
    if (history.currents_A.size() > delay_ + 2) {
      history.currents_A.pop_front();
    }
  }

  std::vector<Candidate>& candidates() noexcept { return candidates_; }

 private:
  std::vector<Candidate> candidates_;
  Tick judged_from_;
  std::vector<History> histories_;
  std::vector<control::ValveOpening> valves_;
  std::size_t delay_;
};

const robot::Robot& source_of(EstimationMethod method, const robot::Robot& on_ground,
                              const robot::Robot& with_grey_box) {
  return method == EstimationMethod::kGreyBox ? with_grey_box : on_ground;
}

}  // namespace

std::vector<EstimatorResult> score_estimators(const robot::Robot& on_ground, const robot::Robot& with_grey_box,
                                              std::uint64_t seed, const std::function<bool()>& keep_on) {
  std::vector<EstimatorResult> results;
  std::vector<Candidate> candidates;
  for (const auto& method : estimation::kEstimationMethods) {
    results.push_back({.name = method.name, .refusal = {}});
    auto candidate = Candidate::create(with_method(source_of(method.value, on_ground, with_grey_box), method.value));
    if (candidate) {
      candidates.push_back(std::move(candidate).value());
    } else {
      results.back().refusal = candidate.error().message;
    }
  }
  TrotCase walk = compared_cases(on_ground, 1).front();
  walk.seed = seed;
  Audience audience(on_ground, std::move(candidates),
                    static_cast<Tick>(std::lround(walk.judged_from_s / on_ground.period_s)));
  const auto ran =
      run_trot_case(on_ground, walk, Joints::kActuators, keep_on,
                    [&audience](const auto& measurement, const auto& truth) { audience.take(measurement, truth); });
  if (!ran || !ran.value()) {
    return ran ? std::vector<EstimatorResult>{}
               : std::vector<EstimatorResult>{{.name = "walk", .refusal = ran.error().message}};
  }
  auto scored = audience.candidates().begin();
  for (EstimatorResult& result : results) {
    if (result.refusal.empty()) {
      result.scores = (scored++)->scores();
    }
  }
  return results;
}

std::vector<AdaptingRobot> adapting_robots(const robot::Robot& on_ground, const robot::Robot& with_grey_box) {
  const auto with_kind = [](robot::Robot robot, control::Kind kind) {
    for (robot::Joint& joint : robot.joints) {
      joint.kind = kind;
    }
    return robot;
  };
  std::vector<AdaptingRobot> all;
  all.push_back({"file", "", on_ground, false});
  all.push_back({"file", "file", on_ground});
  const robot::Robot lqr = with_kind(on_ground, control::Kind::kLqr);
  all.push_back({"lqr", "", lqr, false});
  for (const auto& method : estimation::kEstimationMethods) {
    if (method.value != EstimationMethod::kGreyBox) {
      all.push_back({"lqr", method.name, with_method(lqr, method.value)});
    }
  }
  const robot::Robot inversion = with_kind(with_grey_box, control::Kind::kFlowInversion);
  all.push_back({"flow_inversion", "", inversion, false});
  all.push_back({"flow_inversion", "greybox", inversion});
  return all;
}

std::vector<AdaptingResult> adapt_on_body(std::span<const AdaptingRobot> robots, int seeds,
                                          const std::function<bool()>& done) {
  std::vector<AdaptingResult> results;
  for (const AdaptingRobot& each : robots) {
    auto runs = compare_runs(each.robot, seeds, each.adapts, done);
    if (!runs) {
      break;
    }
    results.push_back({each.controller, each.estimator, std::move(*runs)});
  }
  return results;
}

}  // namespace farrier::trials
