#include "urdf/joint_pairs.hpp"

#include <algorithm>
#include <string>

#include "core/text.hpp"

namespace farrier::urdf {
namespace {

std::string plain_name(const std::string& name) {
  std::string plain = lower(name);
  constexpr std::string_view kEnding = "_joint";
  if (plain.ends_with(kEnding)) {
    plain.resize(plain.size() - kEnding.size());
  }
  return plain;
}

class Pairing {
 public:
  Pairing(const std::vector<MovingBody>& bodies, const robot::Robot& robot)
      : bodies_(bodies), robot_(robot), pairs_(robot.joints.size(), nullptr) {}

  std::vector<const MovingBody*> pairs() {
    for (const robot::Joint& joint : robot_.joints) {
      const auto named = std::ranges::find_if(bodies_, [&](const MovingBody& body) {
        return body.joint != nullptr && plain_name(body.joint->name) == plain_name(joint.name);
      });
      pairs_[joint.number] = named == bodies_.end() ? nullptr : &*named;
    }
    for (std::size_t leg = 0; leg < robot_.body->legs.size(); ++leg) {
      const auto first = pairs_.begin() + static_cast<std::ptrdiff_t>(leg * body::kJointsPerLeg);
      if (std::all_of(first, first + body::kJointsPerLeg, [](const MovingBody* body) { return body == nullptr; })) {
        pair_by_place(leg);
      }
    }
    return std::move(pairs_);
  }

 private:
  bool taken(const MovingBody& body) const { return std::ranges::find(pairs_, &body) != pairs_.end(); }

  void pair_by_place(std::size_t leg) {
    const Eigen::Vector3d hip_m = robot_.body->legs[leg].links[0].hinge_m;
    const MovingBody* nearest = nullptr;
    for (const MovingBody& body : bodies_) {
      if (body.parent == 0 && !taken(body) &&
          (nearest == nullptr || (body.hinge_m - hip_m).norm() < (nearest->hinge_m - hip_m).norm())) {
        nearest = &body;
      }
    }
    for (std::size_t i = 0; i < body::kJointsPerLeg && nearest != nullptr; ++i) {
      pairs_[leg * body::kJointsPerLeg + i] = nearest;
      const auto next = std::ranges::find_if(bodies_, [&](const MovingBody& body) {
        return body.parent >= 0 && &bodies_[static_cast<std::size_t>(body.parent)] == nearest;
      });
      nearest = next == bodies_.end() ? nullptr : &*next;
    }
  }

  const std::vector<MovingBody>& bodies_;
  const robot::Robot& robot_;
  std::vector<const MovingBody*> pairs_;
};

}  // namespace

std::vector<const MovingBody*> paired_bodies(const std::vector<MovingBody>& bodies, const robot::Robot& robot) {
  return Pairing(bodies, robot).pairs();
}

}  // namespace farrier::urdf
