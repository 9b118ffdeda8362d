// Which effects a selection takes, what a linearised step promises of them, and what a set leaves.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/noise.hpp"
#include "diagnosis/judge/judgement.hpp"
#include "diagnosis/judge/screening.hpp"
#include "diagnosis/judge/selection.hpp"
#include "diagnosis/model/joint_simulator.hpp"
#include "diagnosis/model/twin.hpp"
#include "diagnosis/separability/separability.hpp"
#include "tests/unit/diagnosis/rig.hpp"

namespace farrier::diagnosis {
namespace selection_test {

constexpr double kGain = 1.15;  ///< of the load cell
constexpr int kLate = 4;        ///< samples of the valve's current
constexpr double kMass = 1.3;   ///< of the nominal load

plant::EffectId id_of(const char* name) { return plant::find_effect(name); }

SensorNoiseLevels noise() { return {rig().noise.position, rig().noise.velocity, rig().noise.force}; }

/// The rig under random steps, as its sensors read it, with a load of another mass, a load cell of another gain and a
/// current that acts later than recorded.
Recording recorded(double mass, double gain, int late) {
  plant::LoadParams load = rig().swing_load;
  load.mass *= mass;
  const NoiseStream draw(7, "selection_test", "current");
  Recording recording = recorded_rig(
      4000, load, [&](int k) { return (2.0 * draw.uniform(k / 60) - 1.0) * ((k / 1000) % 2 == 0 ? 0.5e-3 : 2e-3); });
  const NoiseStream position(7, "selection_test", "position");
  const NoiseStream velocity(7, "selection_test", "velocity");
  const NoiseStream force(7, "selection_test", "force");
  for (std::size_t i = 0; i < recording.force.size(); ++i) {
    const auto tick = static_cast<Tick>(i);
    recording.position[i] += rig().noise.position * position.normal(tick);
    recording.velocity[i] += rig().noise.velocity * velocity.normal(tick);
    recording.force[i] = gain * recording.force[i] + rig().noise.force * force.normal(tick);
  }
  std::vector<double>& current = recording.valve_current_A;
  std::rotate(current.begin(), current.begin() + late, current.end());
  return recording;
}

/// A recording with everything that judges sets of effects.
struct Case {
  explicit Case(const Recording& recording)
      : data(prepare(recording, rig().actuator, rig().noise.position)),
        model(rig().actuator, rig().swing_load),
        simulator(model, data, rig().noise.force),
        bench(simulator, {true, true, true}, {}) {}

  JointData data;
  JointModel model;
  JointSimulator simulator;
  Bench bench;
  ExpectedResiduals expected = [this](const Hypothesis& hypothesis) {
    return expected_residuals(bench, simulator, hypothesis, noise());
  };
  Rules rules;
  ForEach for_each = [](std::size_t count, const std::function<void(std::size_t)>& piece) {
    for (std::size_t i = 0; i < count; ++i) {
      piece(i);
    }
  };
};

/// A recording with the three effects of the file, made once.
const Case& three() {
  static const Case one(recorded(kMass, kGain, kLate));
  return one;
}

const Hypothesis& base_of_three() {
  static const Hypothesis base = three().bench.base();
  return base;
}

std::vector<plant::EffectId> sorted(std::vector<plant::EffectId> effects) {
  std::ranges::sort(effects);
  return effects;
}

const std::vector<plant::EffectId> kHidden =
    sorted({id_of("load_mass"), id_of("force_sensor_gain"), id_of("input_delay")});

TEST(Screening, TheLargestPromiseOfTheForceIsOfAnEffectThatIsThere) {
  const Screening screening(three().bench, base_of_three());
  const double delay = screening.promise_of(id_of("input_delay")).log_ratio;
  EXPECT_GT(delay, 0.1);
  EXPECT_GT(delay, screening.promise_of(id_of("internal_leakage")).log_ratio);
  EXPECT_GT(delay, screening.promise_of(id_of("air_entrainment")).log_ratio);
}

/// The load's mass alone is hidden: the nominal model, the mass beside it as it is first fitted, and that refined.
struct MassAlone {
  Case one{recorded(kMass, 1.0, 0)};
  plant::EffectId mass = id_of("load_mass");
  Hypothesis base = one.bench.base();
  Hypothesis with = one.bench.with(base, one.bench.sketch(base, mass, one.simulator.starts(mass)).value(), 0.0).value();
  Hypothesis refined = one.bench.refined(with);
};

const MassAlone& mass_alone() {
  static const MassAlone alone;
  return alone;
}

TEST(Screening, EffectsOfTheSameSidePromiseNothingBesideTheOneThatExplainsIt) {
  const MassAlone& alone = mass_alone();
  const double before = Screening(alone.one.bench, alone.base).promise_of(alone.mass).log_ratio;
  const Screening after(alone.one.bench, alone.refined);
  EXPECT_LT(after.promise_of(id_of("load_damping")).log_ratio, 0.05 * before);
  EXPECT_LT(after.promise_of(id_of("load_stiffness")).log_ratio, 0.05 * before);
}

TEST(Hypothesis, ResidualsOfARefinedOneCountByItsOwnError) {
  const MassAlone& alone = mass_alone();
  const auto motion = static_cast<std::size_t>(Channel::kMotion);
  const auto total = [&](const Hypothesis& h) { return h.fitted_squares[motion][0] + h.fitted_squares[motion][1]; };
  const double share = total(alone.with) / total(alone.base);
  EXPECT_LT(share, 0.25);
  EXPECT_NEAR(alone.with.weight[motion] / alone.base.weight[motion], std::sqrt(share), 1e-9);
  EXPECT_LE(total(alone.refined), total(alone.with));
}

TEST(Remainder, IsThatOfATwinWhereNothingIsHiddenAndMoreBesideAnEffect) {
  const Case none(recorded(1.0, 1.0, 0));
  const auto left = remainder(none.bench, none.bench.base(), none.expected);
  const auto hidden = remainder(three().bench, base_of_three(), three().expected);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_GT(left[c].rms, 0.7 * left[c].expected) << c;
    EXPECT_LT(left[c].rms, 1.6 * left[c].expected) << c;
    EXPECT_GT(hidden[c].rms, 3.0 * hidden[c].expected) << c;
    EXPECT_GT(hidden[c].nrmse, left[c].nrmse) << c;
  }
}

TEST(Remainder, LeavesOutAChannelThatIsNotJudged) {
  const Case& all = three();
  const Bench load(all.simulator, {false, true, false}, {});
  const auto left = remainder(load, base_of_three(), [](const Hypothesis&) {
    return std::array<double, kChannels>{1.0, 1.0, 1.0};
  });
  EXPECT_EQ(left[0].rms, 0.0);
  EXPECT_GT(left[1].rms, 0.0);
  EXPECT_EQ(left[2].nrmse, 0.0);
}

TEST(Selection, GrowsASetOfThreeWithTheirSizesAndExchangesNone) {
  const Case& one = three();
  Selection selection(one.bench, one.expected, one.rules, one.for_each);
  selection.grow();
  ASSERT_EQ(sorted(selection.chosen().effects), kHidden);
  selection.exchange();
  ASSERT_EQ(sorted(selection.chosen().effects), kHidden);
  for (std::size_t i = 0; i < selection.chosen().effects.size(); ++i) {
    const plant::EffectId id = selection.chosen().effects[i];
    const Estimate estimate = pooled(selection.chosen(), i);
    const plant::Parameter& first = plant::effect_info(id).parameters[0];
    const double value = one.simulator.scales().value(first, estimate.fitted[0]);
    const double true_value = id == id_of("load_mass")           ? kMass * rig().swing_load.mass
                              : id == id_of("force_sensor_gain") ? kGain
                                                                 : 1e-3 * kLate;
    EXPECT_NEAR(value, true_value, 0.05 * true_value) << plant::effect_info(id).name;
    EXPECT_FALSE(at_bound(id, estimate));
    EXPECT_GT(selection.share_of(id), 0.05);
  }
}

TEST(Selection, TiesWhatTheRecordingCannotSeparate) {
  // A small offset of the load cell and a constant force on the load do the same to the motion.
  Recording recording = recorded(1.0, 1.0, 0);
  for (double& force : recording.force) {
    force += 4.0;
  }
  const Case one(recording);
  Selection selection(one.bench, one.expected, one.rules, one.for_each);
  selection.grow();
  selection.tie_inseparable();
  std::vector<Model::Effect> set;
  for (std::size_t i = 0; i < selection.chosen().effects.size(); ++i) {
    set.push_back({selection.chosen().effects[i], pooled(selection.chosen(), i).fitted});
  }
  std::size_t rivals = 0;
  const auto noise = one.expected(selection.base());
  for (const MemberVisibility& member : member_visibilities(one.bench, set, noise, one.rules, one.for_each)) {
    for (const LikeEffect& rival : member.beside.rivals) {
      ++rivals;
      EXPECT_EQ(std::ranges::count_if(selection.ties(),
                                      [&](const Selection::Tie& tie) {
                                        return tie.chosen == member.beside.id && tie.rival == rival.id &&
                                               holds(tie.with_rival, rival.id);
                                      }),
                1)
          << plant::effect_info(rival.id).name;
    }
  }
  EXPECT_GE(rivals, 1u);
}

TEST(Selection, HasNoMoreEffectsThanAllowed) {
  const Case& one = three();
  Rules rules;
  rules.most_effects = 1;
  Selection selection(one.bench, one.expected, rules, one.for_each);
  selection.grow();
  EXPECT_EQ(selection.chosen().effects.size(), 1u);
  rules.most_effects = 0;
  Selection none(one.bench, one.expected, rules, one.for_each);
  none.grow();
  EXPECT_TRUE(none.chosen().effects.empty());
}

TEST(Selection, ChoosesNothingWhereNothingIsHidden) {
  const Case none(recorded(1.0, 1.0, 0));
  Selection selection(none.bench, none.expected, none.rules, none.for_each);
  selection.grow();
  selection.grow_from_others();
  selection.exchange();
  EXPECT_TRUE(selection.chosen().effects.empty());
}

TEST(Judge, NamesNoCauseOfWhichNoneIsLikely) {
  const Case one(recorded(kMass, 1.0, 0));
  Rules rules;
  const Judgement likely = judge(one.bench, one.expected, rules, one.for_each);
  ASSERT_EQ(likely.verdict, Verdict::kEffects);
  rules.likely = 1.0;  // more than any confidence
  const Judgement unlikely = judge(one.bench, one.expected, rules, one.for_each);
  EXPECT_EQ(unlikely.verdict, Verdict::kUnknown);
  ASSERT_EQ(unlikely.effects.size(), 1u) << "what explains a part is still given";
  EXPECT_EQ(unlikely.effects[0].id, likely.effects[0].id);
}

}  // namespace selection_test
}  // namespace farrier::diagnosis
