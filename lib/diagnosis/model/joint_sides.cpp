#include "diagnosis/model/joint_sides.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "diagnosis/model/load_starts.hpp"
#include "plant/terms/active_effect.hpp"

namespace farrier::diagnosis {
namespace {

/// Share of the valve's largest current that a recording uses, below which sizes of currents begin at its own, too.
constexpr double kMuchCurrent = 0.5;

/// Largest current of a recording over the joint's, 1 without a current.
double share_of_current(const JointSides& joint, const JointData& data) {
  double most = 0.0;
  for (const double current_A : data.current_A) {
    most = std::max(most, std::abs(current_A));
  }
  return data.current_A.empty() ? 1.0 : most / joint.scales().of(plant::Scale::kCurrent);
}

}  // namespace

std::vector<std::vector<double>> usual_starts(const JointSides& joint, plant::EffectId id, const JointData& data) {
  const plant::EffectInfo& info = plant::effect_info(id);
  const double length = joint.scales().of(plant::Scale::kLength);
  const auto [low, high] = std::ranges::minmax(data.position);
  std::vector<std::vector<double>> all = starts_of(info);
  // A valve too large for its joint never opens far: sizes that are usual for the valve would shut it.
  const double used = share_of_current(joint, data);
  if (info.parameters[0].scale == plant::Scale::kCurrent && used < kMuchCurrent && !info.parameters[0].reciprocal) {
    for (std::size_t i = 0, usual = all.size(); i < usual; ++i) {
      all.push_back(all[i]);
      all.back()[0] = std::max(all[i][0] * used, info.parameters[0].low);
    }
  }
  for (auto& start : all) {
    for (std::size_t i = 1; i < start.size(); ++i) {
      if (std::string_view(info.parameters[i].name) == "slack_position_m") {
        start[i] =
            joint.load().stiffness > 0.0 ? joint.load().equilibrium_position / length : 0.5 * (low + high) / length;
      }
    }
  }
  if (id == plant::effect_id<plant::SpringHardening>()) {
    // A fit that begins far from where the spring is slack ends elsewhere.
    std::ranges::move(starts_of_hardening(data, joint.scales()), std::back_inserter(all));
  }
  return all;
}

std::size_t replaced_of_load(plant::EffectId id) noexcept {
  using plant::Scale;
  const plant::EffectInfo& info = plant::effect_info(id);
  if (!info.nominal || info.side != plant::Side::kLoad) {
    return kNominals;
  }
  switch (info.parameters[0].scale) {
    case Scale::kMass:
      return static_cast<std::size_t>(Nominal::kMass);
    case Scale::kDamping:
      return static_cast<std::size_t>(Nominal::kDamping);
    default:
      return static_cast<std::size_t>(Nominal::kStiffness);
  }
}

}  // namespace farrier::diagnosis
