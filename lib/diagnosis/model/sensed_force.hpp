#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "diagnosis/data/joint_data.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// The force behind a recording's force sensor, step by step: its offset, gain and lag undone.
template <class T>
class SensedForce {
 public:
  static constexpr std::size_t kParts = JointData::kLoadSubsteps;
  /// A number for each substep of a period.
  using Parts = std::array<T, kParts>;

  /// Stands at sample `begin`. `data` must outlive this.
  SensedForce(const JointData& data, const plant::TermSet<T>& terms, std::size_t begin) : data_(&data) {
    if (const auto* gain = terms.template find<plant::ForceSensorGain>()) {
      gain_ = gain->gain();
    }
    if (const auto* offset = terms.template find<plant::ForceSensorOffset>()) {
      offset_ = offset->offset();
    }
    if (const auto* lag = terms.template find<plant::ForceSensorLag>()) {
      lag_.emplace(lag->lag_s(), data.period_s);
    }
    now_ = measured(begin);
  }

  /// At the current sample.
  const T& now() const { return now_; }
  const T& gain() const { return gain_; }

  /// Mean force over each substep from the current sample k to the next: its chord, bent by `bend`. Goes on to the next.
  Parts advance(std::size_t k, Parts bend) {
    T next = measured(std::min(k + 1, data_->size() - 1));
    if (lag_) {
      next = lag_->input_for(measured(k), next, now_, bend);
    }
    Parts force;
    for (std::size_t j = 0; j < kParts; ++j) {
      force[j] = now_ + (static_cast<double>(j) + 0.5) / kParts * (next - now_) + bend[j];
    }
    now_ = next;
    return force;
  }

 private:
  T measured(std::size_t k) const { return (data_->force[k] - offset_) / gain_; }

  const JointData* data_;
  T gain_ = T(1.0);
  T offset_ = T(0.0);
  std::optional<plant::FirstOrderLag<T>> lag_;
  T now_;
};

}  // namespace farrier::diagnosis
