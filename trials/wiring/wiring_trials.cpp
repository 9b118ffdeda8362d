#include "trials/wiring/wiring_trials.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>

#include "diagnosis/judge/parallel.hpp"
#include "trials/wiring/wiring_faults.hpp"

namespace farrier::wiring {
namespace {

constexpr double kPeriod_s = 0.001;

std::string words_of(const blind::TrialPlan& plan) {
  std::string words;
  for (const truth::Hidden& hidden : plan.plan.hidden) {
    words += (words.empty() ? "" : " and ") + hidden.name;
  }
  return words.empty() ? "no effect" : words;
}

/// A recording of each joint without a fault or an effect, under all excitations in turn.
Result<std::vector<diagnosis::Recording>> good_recordings(const std::vector<const robot::Joint*>& joints,
                                                          std::uint64_t seed) {
  std::vector<diagnosis::Recording> recordings;
  for (std::size_t n = 0; n < joints.size(); ++n) {
    const truth::Plan plan{.seed = seed + n, .excitation = static_cast<truth::Excitation>(n % 3), .hidden = {}};
    const auto trial = FARRIER_TRY(truth::generate(*joints[n], kPeriod_s, plan));
    recordings.push_back(recording_of(trial.samples, *joints[n]));
  }
  return recordings;
}

}  // namespace

bool is_fault(const diagnosis::WiringFault& answer, const diagnosis::WiringFault& fault) noexcept {
  using diagnosis::WiringKind;
  if (answer.kind != fault.kind || answer.channel != fault.channel || answer.both_pressures != fault.both_pressures ||
      answer.joint != fault.joint || (fault.kind == WiringKind::kExchanged && answer.other != fault.other)) {
    return false;
  }
  const bool lag = fault.kind == WiringKind::kLate || fault.kind == WiringKind::kEarly;
  return std::abs(answer.amount - fault.amount) <= 0.1 * fault.amount + (lag ? 1.0 : 0.0);
}

diagnosis::Recording recording_of(const truth::Samples& samples, const robot::Joint& joint) {
  diagnosis::Recording recording = blind::recording_of(samples);
  recording.coordinates = joint.rotary ? diagnosis::Coordinates::kRotary : diagnosis::Coordinates::kLinear;
  for (std::size_t i = 0; i < samples.position.size(); ++i) {
    recording.time_s.push_back(static_cast<double>(i) * samples.period_s);
  }
  recording.pressure_a_Pa = samples.pressure_a_Pa;
  recording.pressure_b_Pa = samples.pressure_b_Pa;
  recording.supply_pressure_Pa = samples.supply_pressure_Pa;
  return recording;
}

Result<std::vector<KindScore>> run_wiring_trials(const std::vector<const robot::Joint*>& joints, std::uint64_t seed) {
  std::vector<const robot::Joint*> of;
  // One more than there are of a kind: the other joint's of the last.
  for (std::size_t n = 0; n <= kRecordings; ++n) {
    of.push_back(joints[n % joints.size()]);
  }
  const std::vector<diagnosis::Recording> recordings = FARRIER_TRY(good_recordings(of, seed));
  std::vector<KindScore> scores;
  for (const FaultKind& kind : fault_kinds(joints.front()->electric.has_value())) {
    KindScore score{.name = kind.name};
    for (int i = 0; i < kRecordings; ++i) {
      const auto n = static_cast<std::size_t>(i);
      diagnosis::Recording recording = recordings[n];
      diagnosis::OtherJoint other{of[n + 1]->name, recordings[n + 1]};
      const diagnosis::WiringFault fault = kind.put(recording, *of[n], other, i);
      const auto answers = diagnosis::find_wiring(recording, *of[n], {&other, 1});
      const auto right = [&](const diagnosis::WiringAnswer& answer) { return is_fault(answer.fault, fault); };
      const bool possible = std::ranges::any_of(answers, right);
      ++score.recordings;
      score.first += !answers.empty() && right(answers.front()) ? 1 : 0;
      score.possible += possible ? 1 : 0;
      score.wrong += !answers.empty() && !possible ? 1 : 0;
    }
    scores.push_back(score);
  }
  return scores;
}

Result<std::vector<KindScore>> run_robot_wiring_trials(const robot::Robot& robot, std::uint64_t seed) {
  using enum diagnosis::WiredChannel;
  std::vector<const robot::Joint*> joints;
  for (const robot::Joint& joint : robot.joints) {
    joints.push_back(&joint);
  }
  const std::vector<diagnosis::Recording> recordings = FARRIER_TRY(good_recordings(joints, seed));
  std::vector<diagnosis::OtherJoint> all;
  for (std::size_t n = 0; n < joints.size(); ++n) {
    all.push_back({joints[n]->name, recordings[n]});
  }
  std::vector<KindScore> scores;
  for (const auto& [name, channel] : {std::pair{"force cables of two joints exchanged", kForce},
                                      std::pair{"position cables of two joints exchanged", kPosition},
                                      std::pair{"velocity cables of two joints exchanged", kVelocity},
                                      std::pair{"current cables of two joints exchanged", kCurrent}}) {
    KindScore score{.name = name};
    for (std::size_t i = 0; i < kRecordings; ++i) {
      // Neighbours, and joints further apart each time.
      const std::size_t one = 2 * i % joints.size(), other = (3 * i + 1) % joints.size();
      std::vector<diagnosis::OtherJoint> faulty = all;
      std::swap(diagnosis::column(faulty[one].recording, channel), diagnosis::column(faulty[other].recording, channel));
      int first = 0, possible = 0, wrong = 0;
      for (const auto& [mine, theirs] : {std::pair{one, other}, std::pair{other, one}}) {
        const diagnosis::WiringFault fault{
            .kind = diagnosis::WiringKind::kOtherJoint, .channel = channel, .joint = joints[theirs]->name};
        const auto answers = diagnosis::find_wiring(faulty[mine].recording, *joints[mine], faulty);
        const auto right = [&](const diagnosis::WiringAnswer& answer) { return is_fault(answer.fault, fault); };
        const bool named = std::ranges::any_of(answers, right);
        first += !answers.empty() && right(answers.front()) ? 1 : 0;
        possible += named ? 1 : 0;
        wrong += !answers.empty() && !named ? 1 : 0;
      }
      ++score.recordings;
      score.first += first == 2 ? 1 : 0;
      score.possible += possible == 2 ? 1 : 0;
      score.wrong += wrong > 0 ? 1 : 0;
    }
    scores.push_back(score);
  }
  KindScore right_cables{.name = "joints of the robot with right cables",
                         .recordings = static_cast<int>(joints.size())};
  for (std::size_t n = 0; n < joints.size(); ++n) {
    right_cables.wrong += diagnosis::find_wiring(recordings[n], *joints[n], all).empty() ? 0 : 1;
  }
  scores.push_back(right_cables);
  return scores;
}

std::vector<std::string> false_alarms(const std::vector<blind::TrialPlan>& plans,
                                      const std::vector<const robot::Joint*>& joints, int threads,
                                      const std::function<bool()>& done) {
  std::vector<std::string> alarms;
  std::atomic<bool> goes_on{true};
  std::mutex telling;
  diagnosis::by_threads(
      threads, [](double) {}, 1)(plans.size(), [&](std::size_t i) {
    if (!goes_on) {
      return;
    }
    const robot::Joint& joint = *joints[plans[i].joint];
    const auto trial = truth::generate(joint, kPeriod_s, plans[i].plan);
    std::vector<std::string> mine;
    for (const bool pressures : {true, false}) {
      if (!trial) {
        break;
      }
      diagnosis::Recording recording = recording_of(trial.value().samples, joint);
      if (!pressures) {
        recording.pressure_a_Pa = recording.pressure_b_Pa = recording.supply_pressure_Pa = {};
      }
      const auto answers = diagnosis::find_wiring(recording, joint);
      for (const diagnosis::Finding& finding : diagnosis::wiring_findings(answers, recording, joint)) {
        mine.push_back("trial " + std::to_string(i) + ", " + words_of(plans[i]) + ": " + finding.text);
      }
    }
    const std::lock_guard lock(telling);
    alarms.insert(alarms.end(), mine.begin(), mine.end());
    if (!trial) {
      alarms.push_back("trial " + std::to_string(i) + " could not be made: " + trial.error().message);
    }
    goes_on = done() && goes_on;
  });
  return alarms;
}

}  // namespace farrier::wiring
