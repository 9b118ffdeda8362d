#include "tools/web/body_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

namespace farrier::web {
namespace {

using nlohmann::json;

constexpr double kLength = 1e-4;    // m, m/s: what no eye sees
constexpr double kAttitude = 1e-5;  // of a unit quaternion
constexpr double kForce = 0.1;      // N
constexpr std::size_t kAxes = 3;

json rounded(double value, double digit) {
  return std::isfinite(value) ? json(std::round(value / digit) / std::round(1.0 / digit)) : json(nullptr);
}

json list_of(std::span<const double> values, double digit) {
  json list = json::array();
  for (const double value : values) {
    list.push_back(rounded(value, digit));
  }
  return list;
}

json vector_of(const Eigen::Vector3d& vector_m) { return list_of(std::span(vector_m.data(), kAxes), kLength); }

/// The vectors of the robot's feet in a field that has room for more.
template <std::size_t kSize>
json of_feet(const std::array<double, kSize>& numbers, std::size_t legs, double digit) {
  return list_of(std::span(numbers).first(std::min(kSize, kAxes * legs)), digit);
}

/// The sides of the box of uniform density that has this mass and these moments of inertia: with I_x = m (y^2 + z^2) / 12
/// and so on, x^2 = 6 (I_y + I_z - I_x) / m.
Eigen::Vector3d sides_of(const body::RigidInertia& inertia) {
  const Eigen::Vector3d moments = inertia.tensor_kg_m2.diagonal();
  return (6.0 / inertia.mass_kg * (Eigen::Vector3d::Constant(moments.sum()) - 2.0 * moments)).cwiseMax(0.0).cwiseSqrt();
}

/// The box spanned by the first hinges. Along an axis on which they do not differ it is as the trunk's inertia says.
json trunk_box(const body::BodyModel& model) {
  Eigen::AlignedBox3d hinges;
  for (const body::LegModel& leg : model.legs) {
    hinges.extend(leg.links.front().hinge_m);
  }
  const Eigen::Vector3d spanned = hinges.sizes();
  const Eigen::Vector3d size = (spanned.array() > kLength).select(spanned, sides_of(model.trunk));
  return {{"centre", vector_of(hinges.center())}, {"size", vector_of(size)}};
}

/// Hinges from the second on, and the foot: the first hinge does not move.
json leg_of(const std::optional<monitor::BodyFrame::Leg>& leg) {
  if (!leg) {
    return nullptr;
  }
  json points = json::array();
  for (std::size_t index = 1; index < leg->hinges_m.size(); ++index) {
    points.push_back(vector_of(leg->hinges_m[index]));
  }
  points.push_back(vector_of(leg->foot_m));
  return points;
}

json truth_of(const std::optional<signals::BodyTruth>& truth, std::size_t legs) {
  if (!truth) {
    return nullptr;
  }
  return {{"position", list_of(truth->position_m, kLength)},
          {"attitude", list_of(truth->attitude, kAttitude)},
          {"velocity", list_of(truth->velocity_m_s, kLength)},
          {"forces", of_feet(truth->foot_force_N, legs, kForce)},
          {"push", list_of(truth->push_N, kForce)}};
}

json state_of(const std::optional<signals::BodyState>& state, std::size_t legs) {
  if (!state) {
    return nullptr;
  }
  json stands = json::array();
  for (std::size_t leg = 0; leg < std::min(legs, state->stands.size()); ++leg) {
    stands.push_back(state->stands[leg]);
  }
  return {{"mode", to_string(state->mode)},
          {"position", list_of(state->position_m, kLength)},
          {"attitude", list_of(state->attitude, kAttitude)},
          {"velocity", list_of(state->velocity_m_s, kLength)},
          {"command", list_of(state->command, kLength)},
          {"forces", of_feet(state->felt_force_N, legs, kForce)},
          {"footholds", of_feet(state->foothold_m, legs, kLength)},
          {"stands", std::move(stands)}};
}

}  // namespace

json body_shapes(const robot::Robot& robot) {
  if (!robot.body) {
    return nullptr;
  }
  json legs = json::array();
  for (const body::LegModel& leg : robot.body->legs) {
    legs.push_back(
        {{"hinge", vector_of(leg.links.front().hinge_m)}, {"foot_radius", rounded(leg.foot_radius_m, kLength)}});
  }
  return {{"trunk", trunk_box(*robot.body)},
          {"legs", std::move(legs)},
          {"weight", rounded(body::total_mass_kg(*robot.body) * robot.body->gravity_m_s2, kForce)}};
}

json body_json(const std::optional<monitor::BodyFrame>& body) {
  if (!body) {
    return nullptr;
  }
  json legs = json::array();
  for (const auto& leg : body->legs) {
    legs.push_back(leg_of(leg));
  }
  return {{"legs", std::move(legs)},
          {"com", vector_of(body->centre_of_mass_m)},
          {"truth", truth_of(body->truth, body->legs.size())},
          {"state", state_of(body->state, body->legs.size())}};
}

}  // namespace farrier::web
