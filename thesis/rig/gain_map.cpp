#include "thesis/rig/gain_map.hpp"

#include <algorithm>
#include <cmath>

#include "control/design/lqr.hpp"
#include "robot/joint_model.hpp"

namespace farrier::thesis {

using control::LoadParameter;

namespace {

Axis axis_of(LoadParameter parameter) {
  switch (parameter) {
    case LoadParameter::kMass: return {"mass (kg)", log_space(control::kMassRange_kg.low, control::kMassRange_kg.high, 15), parameter};
    case LoadParameter::kDamping:
      return {"friction (Ns/m)", linear_space(control::kDampingRange_Ns_m.low, control::kDampingRange_Ns_m.high, 15), parameter};
    case LoadParameter::kStiffness: break;
  }
  return {"stiffness (N/m)", linear_space(control::kStiffnessRange_N_m.low, control::kStiffnessRange_N_m.high, 15), parameter};
}

}  // namespace

Result<GainVector> gains_for(const robot::Robot& rig, const plant::LoadParams& load) {
  const robot::Joint& joint = rig.joints[0];
  const auto gains = control::design_lqr(robot::model_of(joint, load, rig.period_s), control::LqrWeights{},
                                         joint.normalisation, control::Form::kFullState, 0);
  if (!gains) {
    return Error{"gain map: mass " + std::to_string(load.mass) + " kg, friction " + std::to_string(load.damping) +
                 " Ns/m, stiffness " + std::to_string(load.stiffness) + " N/m: " + to_string(gains.error())};
  }
  return GainVector{gains.value().position, gains.value().velocity, gains.value().force};
}

Result<Map> make_map(const robot::Robot& rig, LoadParameter first, LoadParameter second) {
  Map map{axis_of(first), axis_of(second), {}};
  for (const double one : map.first.values) {
    map.k.emplace_back();
    for (const double other : map.second.values) {
      const auto gains = FARRIER_TRY(gains_for(rig, control::with(control::with(rig.joints[0].swing_load, map.first.parameter, one),
                                                      map.second.parameter, other)));
      map.k.back().push_back(gains);
    }
  }
  return map;
}

Map transposed(const Map& map) {
  Map other{map.second, map.first, {}};
  other.k.assign(map.second.values.size(), std::vector<GainVector>(map.first.values.size()));
  for (std::size_t i = 0; i < map.k.size(); ++i) {
    for (std::size_t j = 0; j < map.k[i].size(); ++j) {
      other.k[j][i] = map.k[i][j];
    }
  }
  return other;
}

double rising(const Map& map, Channel channel) {
  double rises = 0.0;
  double steps = 0.0;
  for (std::size_t i = 0; i + 1 < map.k.size(); ++i) {
    for (std::size_t j = 0; j < map.k[i].size(); ++j) {
      rises += std::abs(map.k[i + 1][j][channel]) > std::abs(map.k[i][j][channel]) ? 1.0 : 0.0;
      steps += 1.0;
    }
  }
  return rises / steps;
}

double change(const Map& map, Channel channel, std::size_t j) {
  double low = std::abs(map.k[0][j][channel]), high = low, top = 0.0;
  for (const auto& row : map.k) {
    low = std::min(low, std::abs(row[j][channel]));
    high = std::max(high, std::abs(row[j][channel]));
    for (const GainVector& k : row) {
      top = std::max(top, std::abs(k[channel]));
    }
  }
  return (high - low) / top;
}

double change(const Map& map, Channel channel) {
  double largest = 0.0;
  for (std::size_t j = 0; j < map.second.values.size(); ++j) {
    largest = std::max(largest, change(map, channel, j));
  }
  return largest;
}

Picture picture_of(const Map& map) {
  Picture picture{std::string("LQR gains over ") + map.first.label + "; lines: " + map.second.label +
                      ", black to yellow as it grows",
                  3, {}};
  constexpr const char* kTitles[] = {"position", "velocity", "force"};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    Panel panel{.title = kTitles[channel], .x_label = map.first.label, .y_label = "gain"};
    for (std::size_t j = 0; j < map.second.values.size(); ++j) {
      Series line;
      const double shade = static_cast<double>(j) / static_cast<double>(map.second.values.size() - 1);
      for (std::size_t i = 0; i < map.k.size(); ++i) {
        line.x.push_back(map.first.values[i]);
        line.y.push_back(map.k[i][j][channel]);
        line.shade.push_back(shade);
      }
      panel.series.push_back(std::move(line));
    }
    picture.panels.push_back(std::move(panel));
  }
  return picture;
}

}  // namespace farrier::thesis
