#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "monitor/frame.hpp"

namespace farrier::monitor {

/// Makes the part of a frame that shows the shared hydraulic supply. Frames have fifty samples a second, as many as
/// summaries of a joint.
class SupplyView {
 public:
  explicit SupplyView(double period_s) : every_ticks_(static_cast<Tick>(std::lround(kEvery_s / period_s))) {}

  /// `time_ns`: log time of the sample.
  void take(const signals::SupplyState& state, std::uint64_t time_ns) {
    heard_ns_ = time_ns;
    now_.newest = state;
    keep(state, now_.states, kept_state_);
  }
  void take(const signals::SupplyTruth& truth) {
    now_.newest_truth = truth;
    keep(truth, now_.truths, kept_truth_);
  }

  /// Forgets all samples: another run begins.
  void begin_anew() {
    now_ = {};
    heard_ns_ = 0;
    kept_state_ = kept_truth_ = kNoTick;
  }

  /// Empty before the first sample, and once the newest is older than kSilent_s. Samples since the last frame are then
  /// forgotten.
  std::optional<SupplyFrame> frame(std::uint64_t time_ns) {
    SupplyFrame frame = now_;
    now_.states.clear();
    now_.truths.clear();
    const bool silent = static_cast<double>(time_ns - std::min(heard_ns_, time_ns)) * 1e-9 > kSilent_s;
    return heard_ns_ == 0 || silent ? std::nullopt : std::optional(std::move(frame));
  }

 private:
  static constexpr double kEvery_s = 0.02;

  template <class Sample>
  void keep(const Sample& sample, std::vector<Sample>& samples, Tick& kept) {
    if (kept == kNoTick || sample.tick < kept || sample.tick >= kept + every_ticks_) {
      samples.push_back(sample);
      kept = sample.tick;
    }
  }

  Tick every_ticks_;
  Tick kept_state_ = kNoTick, kept_truth_ = kNoTick;
  SupplyFrame now_;
  std::uint64_t heard_ns_ = 0;  ///< 0: never
};

}  // namespace farrier::monitor
