#include "trials/blind/blind_trials.hpp"

#include <time.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>

#include "control/law/effect_compensation.hpp"
#include "diagnosis/judge/joint_bench.hpp"
#include "diagnosis/judge/parallel.hpp"
#include "diagnosis/separability/separability.hpp"
#include "trials/blind/score.hpp"
#include "diagnosis/model/sides_of_joint.hpp"
#include "robot/joint_effects.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::blind {

diagnosis::Recording recording_of(const truth::Samples& samples) {
  diagnosis::Recording recording;
  recording.period_s = samples.period_s;
  recording.valve_current_A = samples.valve_current_A;
  recording.position = samples.position;
  recording.velocity = samples.velocity;
  recording.force = samples.force;
  return recording;
}

namespace {

constexpr double kPeriod_s = 0.001;
/// Held-out rms by channel of the nominal model with its constants fitted.
std::array<double, diagnosis::kChannels> base_error(const truth::Samples& samples, const robot::Joint& joint) {
  robot::Joint plain = joint;
  plain.effects.clear();
  const auto sides = diagnosis::sides_of(plain);
  const diagnosis::JointData data = sides->prepared(recording_of(samples), joint.noise.position);
  const diagnosis::JointSimulator simulator(*sides, data);
  const diagnosis::Bench bench(simulator, {true, true, true}, {});
  const diagnosis::Hypothesis base = bench.base();
  return {std::sqrt(base.total(0)), std::sqrt(base.total(1)), std::sqrt(base.total(2))};
}

/// Returns the hidden effects as a joint's effects; none if one of them is outside the library.
std::vector<plant::ActiveEffect> hidden_effects(const std::vector<truth::Answer>& answers, const robot::Joint& joint,
                                                const std::vector<plant::ActiveEffect>& found) {
  const plant::Scales scales(joint.actuator, joint.swing_load);
  std::vector<plant::ActiveEffect> hidden;
  for (const truth::Answer& answer : answers) {
    plant::ActiveEffect effect{plant::find_effect(answer.name), {}};
    if (effect.id == plant::kEffectCount) {
      return {};
    }
    const plant::ActiveEffect* const like = plant::find(found, effect.id);
    for (std::size_t i = 0; i < effect.info().parameters.size(); ++i) {
      effect.values[i] =
          like != nullptr ? like->values[i]
                          : plant::default_value(effect.info().parameters[i], scales, joint.actuator, joint.swing_load);
    }
    effect.values[0] = answer.value;
    hidden.push_back(effect);
  }
  return hidden;
}

std::optional<trials::TrackingGain> control_gain(const std::vector<truth::Answer>& answers, const robot::Joint& joint,
                                                 const std::vector<plant::ActiveEffect>& found) {
  if (joint.electric) {
    return std::nullopt;
  }
  const std::vector<plant::ActiveEffect> hidden = hidden_effects(answers, joint, found);
  if (hidden.empty() || std::ranges::none_of(found, control::is_compensated, &plant::ActiveEffect::id)) {
    return std::nullopt;
  }
  const auto world = robot::with_effects(joint, hidden);
  const auto known = robot::with_effects(joint, found);
  if (!world || !known) {
    return std::nullopt;
  }
  const auto gain = trials::tracking_gain(world.value(), joint, known.value(), {.period_s = kPeriod_s});
  return gain ? std::optional(gain.value()) : std::nullopt;
}

/// Hidden effects that a recording of a joint with all of them does not separate. Parameters but the hidden ones are as the fits
/// of the effects begin.
std::vector<std::string> inseparable_of(const diagnosis::Recording& recording, const robot::Joint& joint,
                                        const std::vector<truth::Answer>& answers,
                                        const diagnosis::DiagnosisOptions& options) {
  const diagnosis::JointBench of_joint(recording, joint, options.fit);
  const diagnosis::JointSimulator& simulator = of_joint.simulator();
  std::vector<diagnosis::Model::Effect> set;
  for (const truth::Answer& answer : answers) {
    const plant::EffectId id = plant::find_nameable(answer.name);
    const auto starts = simulator.starts(id);
    set.push_back({id, starts.empty() ? std::vector<double>() : starts.front()});
    if (!starts.empty()) {
      set.back().fitted[0] = simulator.scales().fitted(plant::effect_info(id).parameters[0], answer.value);
    }
  }
  const auto expected = of_joint.expected_of(simulator.nominal());
  const auto in_turn = diagnosis::by_threads(options.threads, options.progress, 1);
  std::vector<std::string> names;
  for (const auto& member : diagnosis::member_visibilities(of_joint.bench(), set, expected, options.rules, in_turn)) {
    if (!member.separable()) {
      names.emplace_back(plant::effect_info(member.beside.id).name);
    }
  }
  return names;
}

/// Processor time of this thread.
double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Outcome run_trial(const TrialPlan& plan, const std::vector<const robot::Joint*>& joints) {
  Outcome outcome;
  outcome.plan = plan;
  const robot::Joint& joint = *joints[plan.joint];
  const auto trial = truth::generate(joint, kPeriod_s, plan.plan);
  if (!trial) {
    outcome.refused = trial.error().message;
    return outcome;
  }
  outcome.answers = trial.value().answers;
  diagnosis::DiagnosisOptions options;
  options.threads = 1;
  const diagnosis::Recording recording = recording_of(trial.value().samples);
  if (plan.kind == Kind::kSet) {
    outcome.inseparable = inseparable_of(recording, joint, outcome.answers, options);
  }
  const double before_s = thread_cpu_s();
  const diagnosis::Diagnosis found = diagnosis::diagnose(recording, joint, options);
  outcome.cpu_s = thread_cpu_s() - before_s;
  if (!plan.plan.hidden.empty()) {
    truth::Plan without = plan.plan;
    without.hidden.clear();
    const auto twin = truth::generate(joint, kPeriod_s, without);
    if (!twin) {
      outcome.refused = twin.error().message;
      return outcome;
    }
    const auto with_none = base_error(twin.value().samples, joint);
    for (std::size_t c = 0; c < with_none.size(); ++c) {
      outcome.detectable = std::max(outcome.detectable, std::sqrt(found.judgement.base.total(c)) / with_none[c] - 1.0);
    }
  }
  outcome.verdict = found.judgement.verdict;
  outcome.error_before = found.nrmse_before;
  outcome.error_after = found.nrmse_after;
  const plant::Scales scales = robot::scales_of(joint);
  for (const diagnosis::NamedEffect& effect : found.judgement.effects) {
    const plant::EffectInfo& info = plant::effect_info(effect.id);
    Named named{info.name,         scales.value(info.parameters[0], effect.fitted[0]),
                effect.confidence, effect.evidence,
                effect.deviation,  effect.fit_deviation,
                effect.distance,   std::nullopt,
                std::nullopt};
    const auto answer = std::ranges::find(outcome.answers, named.name, &truth::Answer::name);
    if (answer != outcome.answers.end()) {
      named.fit_error = std::abs(effect.fitted[0] - scales.fitted(info.parameters[0], answer->value));
      named.size_error = size_error(info.parameters[0], named.value, answer->value, scales);
    }
    outcome.named.push_back(std::move(named));
  }
  for (const auto& [one, other] : found.judgement.alternatives) {
    outcome.alternatives.emplace_back(plant::effect_info(one).name, plant::effect_info(other).name);
  }
  outcome.parameter_error = outcome.named.empty()
                                ? std::numeric_limits<double>::infinity()
                                : outcome.named.front().size_error.value_or(std::numeric_limits<double>::infinity());
  outcome.control = control_gain(outcome.answers, joint, diagnosis::found_effects(found, joint));
  return outcome;
}

namespace {

/// An exception, such as of memory that is not there, is that trial's failure.
Outcome run_or_refuse(const TrialPlan& plan, const std::vector<const robot::Joint*>& joints) {
  try {
    return run_trial(plan, joints);
  } catch (const std::exception& thrown) {
    Outcome refused;
    refused.plan = plan;
    refused.refused = thrown.what();
    return refused;
  }
}

}  // namespace

std::vector<Outcome> run_trials(const std::vector<TrialPlan>& plans, const std::vector<const robot::Joint*>& joints,
                                int threads, const std::function<bool(std::size_t, const Outcome&)>& done) {
  std::vector<Outcome> outcomes(plans.size());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    outcomes[i].plan = plans[i];
    outcomes[i].refused = kNotRun;
  }
  std::atomic<bool> goes_on{true};
  std::mutex telling;
  diagnosis::by_threads(
      threads, [](double) {}, 1)(plans.size(), [&](std::size_t i) {
    if (goes_on) {
      outcomes[i] = run_or_refuse(plans[i], joints);
      const std::lock_guard lock(telling);
      goes_on = done(i, outcomes[i]) && goes_on;
    }
  });
  return outcomes;
}

}  // namespace farrier::blind
