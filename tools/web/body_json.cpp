#include "tools/web/body_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "body/model/trunk_shape.hpp"
#include "tools/web/rounded_json.hpp"

namespace farrier::web {
namespace {

using nlohmann::json;

constexpr double kLength = 1e-4;    // m, m/s: what no eye sees
constexpr double kAttitude = 1e-5;  // of a unit quaternion
constexpr double kForce = 0.1;      // N
constexpr std::size_t kAxes = 3;

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

json trunk_box(const body::BodyModel& model) {
  const body::TrunkBox box = body::shown_trunk(model);
  return {{"centre", vector_of(box.centre_m)}, {"size", vector_of(2.0 * box.half_extents_m)}};
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
