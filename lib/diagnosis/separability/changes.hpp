#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/judge/judgement.hpp"

namespace farrier::diagnosis {

/// Effects that are added to a model together.
using AddedEffects = std::vector<Model::Effect>;

/// Changes that effects make to a recording's simulated channels beside a reference model, and how far the numbers of that model
/// and of another effect follow them.
///
/// The products of all changes and derivatives of a channel form one matrix. Any linear least squares problem among them is a
/// block of it.
class Changes {
 public:
  /// `targets` are the additions whose changes are followed. `others` are effects that may follow from the starts of their
  /// fits. Passed over are those of the reference or of the joint's file, and those that no judged channel shows.
  /// `unit`: rms by channel that counts as one, N | m/s. `bench` outlives this.
  Changes(const Bench& bench, const Model& reference, const std::array<double, kChannels>& unit,
          const std::vector<AddedEffects>& targets, const std::vector<plant::EffectId>& others,
          const ForEach& for_each);

  /// Remainder of a change.
  struct Left {
    std::array<double, kChannels> rms{};  ///< by channel, over the unit
    Model follower;                       ///< the reference and the effect that follows, after the step
    double largest() const noexcept;
  };
  /// Remainder of a target's change when the reference's constants follow it within their ranges, and the numbers of its
  /// effects but those of `held`.
  Left left_of(std::size_t target, const std::vector<plant::EffectId>& held = {}) const;
  /// The same when `other` follows too, from the best of its starts. Empty if it is passed over or shows on no channel of the
  /// target.
  std::optional<Left> left_beside(std::size_t target, plant::EffectId other) const;
  /// The remainder of a target's change as simulated, after a few more steps from `linear.follower` with all numbers free.
  Left settled(std::size_t target, const Left& linear) const;
  /// Standard deviation of the first number of a target's last effect, with all others free. Infinite if it is not free.
  double deviation_of(std::size_t target) const;

 private:
  /// Columns of an addition: its change, then the derivatives by the numbers of its last effect.
  struct Response {
    AddedEffects added;
    ChannelMask shows;
    Eigen::Index change = 0;
    std::vector<FreeNumber> free;  ///< these numbers
  };
  std::size_t place_of(const AddedEffects& added);
  void simulate(std::size_t channel, const ForEach& for_each);
  Model with(const AddedEffects& added) const;
  ChannelMask concerned(const ChannelMask& shows) const;
  /// Sum over channels of the products of columns, as facts of a fit.
  Eigen::MatrixXd facts(const ChannelMask& channels, const std::vector<Eigen::Index>& rows,
                        const std::vector<Eigen::Index>& columns) const;
  Left left_of(const Response& target, const Response* other, const std::vector<plant::EffectId>& held) const;

  const Bench& bench_;
  Model reference_;
  std::array<double, kChannels> unit_;
  std::vector<FreeNumber> own_;  ///< of the reference; their columns are the first
  std::vector<Response> responses_;
  std::vector<std::size_t> targets_;  ///< places in `responses_`
  std::array<std::vector<std::size_t>, plant::kNameableCount> starts_;
  Eigen::Index columns_ = 0;
  std::array<Eigen::MatrixXd, kChannels> products_;
  std::array<Eigen::MatrixXd, kChannels> residuals_;  ///< of the reference with each target, a column each
  std::array<double, kChannels> count_{};
};

}  // namespace farrier::diagnosis
