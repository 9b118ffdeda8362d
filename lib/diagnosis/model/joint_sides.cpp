#include "diagnosis/model/joint_sides.hpp"

#include <algorithm>
#include <string_view>

namespace farrier::diagnosis {

std::vector<std::vector<double>> usual_starts(const JointSides& joint, plant::EffectId id, const JointData& data) {
  const plant::EffectInfo& info = plant::effect_info(id);
  const double length = joint.scales().of(plant::Scale::kLength);
  const auto [low, high] = std::ranges::minmax(data.position);
  std::vector<std::vector<double>> all = starts_of(info);
  for (auto& start : all) {
    for (std::size_t i = 1; i < start.size(); ++i) {
      if (std::string_view(info.parameters[i].name) == "slack_position_m") {
        start[i] =
            joint.load().stiffness > 0.0 ? joint.load().equilibrium_position / length : 0.5 * (low + high) / length;
      }
    }
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
