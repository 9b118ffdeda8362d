#include "tools/playback/rerun.hpp"

#include <algorithm>
#include <cstring>
#include <map>

#include "signals/cdr.hpp"
#include "tools/playback/identify.hpp"

namespace farrier::playback {
namespace {

using signals::JointModelEstimate;

/// Recorded estimates of one joint by their tick.
using Estimates = std::map<Tick, JointModelEstimate>;

template <class Number>
bool same_bits(const Number& one, const Number& other) noexcept {
  return std::memcmp(&one, &other, sizeof one) == 0;
}

template <class Number>
void compare(const std::string& name, const Number& recorded, const Number& now, std::optional<Difference>& first) {
  if (!first && !same_bits(recorded, now)) {
    first = Difference{.tick = kNoTick,
                       .field = name,
                       .recorded = static_cast<double>(recorded),
                       .now = static_cast<double>(now)};
  }
}

template <class Number, std::size_t kSize>
void compare(const std::string& name, const std::array<Number, kSize>& recorded, const std::array<Number, kSize>& now,
             std::optional<Difference>& first) {
  for (std::size_t i = 0; i < kSize; ++i) {
    compare(name + '[' + std::to_string(i) + ']', recorded[i], now[i], first);
  }
}

/// Nothing where all fields are the same.
std::optional<Difference> difference(const JointModelEstimate& recorded, const JointModelEstimate& now) {
  std::optional<Difference> first;
#define FARRIER_COMPARE(field) compare(#field, recorded.field, now.field, first);
  FARRIER_FIELDS_JointModelEstimate(FARRIER_COMPARE)
#undef FARRIER_COMPARE
  if (first) {
    first->tick = recorded.tick;
  }
  return first;
}

/// Everything of the run that is needed, in one pass.
struct Recorded {
  Measurements measured;
  std::vector<Estimates> estimates;  // by joint
};

Recorded read(RecordedRun& run) {
  Recorded recorded;
  recorded.estimates.resize(run.robot().joints.size());
  recorded.measured = read_measurements(run, [&](const recording::Sample& sample) {
    if (sample.topic == bus::TopicId::kJointModelEstimate) {
      JointModelEstimate estimate;
      if (signals::from_cdr(sample.cdr, estimate) && estimate.joint < recorded.estimates.size()) {
        recorded.estimates[estimate.joint].emplace(estimate.tick, estimate);
      }
    }
  });
  return recorded;
}

/// Counts one joint's measurements and the ticks missing between them.
void count(const std::vector<signals::JointMeasurement>& measurements, RerunJoint& sum) {
  sum.measurements = measurements.size();
  if (!measurements.empty()) {
    sum.missing = static_cast<std::uint64_t>(measurements.back().tick - measurements.front().tick) + 1 - sum.measurements;
  }
}

}  // namespace

Result<Rerun> rerun_estimator(RecordedRun& run, const KeepOn& keep_on) {
  Recorded recorded = read(run);
  Rerun rerun;
  rerun.ending = recorded.measured.ending;
  for (const std::vector<signals::JointMeasurement>& joint : recorded.measured.joints) {
    count(joint, rerun.joints.emplace_back());
    if (!joint.empty()) {
      rerun.first_tick = rerun.first_tick == kNoTick ? joint.front().tick : std::min(rerun.first_tick, joint.front().tick);
    }
  }
  auto fed = identify(recorded.measured, run.robot(), [&](const JointModelEstimate& now) {
    RerunJoint& sum = rerun.joints[now.joint];
    const auto before = recorded.estimates[now.joint].extract(now.tick);
    if (before.empty()) {
      ++sum.unrecorded;
      return;
    }
    ++sum.compared;
    if (auto different = difference(before.mapped(), now)) {
      ++sum.different;
      sum.first = sum.first ? sum.first : different;
    }
  }, keep_on);
  if (!fed) {
    return fed.error();
  }
  for (std::size_t i = 0; i < rerun.joints.size(); ++i) {
    rerun.joints[i].unanswered = recorded.estimates[i].size();
  }
  return rerun;
}

}  // namespace farrier::playback
