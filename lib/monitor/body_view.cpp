#include "monitor/body_view.hpp"

#include <algorithm>
#include <limits>

namespace farrier::monitor {
namespace {

constexpr std::size_t kMostSamples = 512;  // half a second at 1 kHz; summaries come every 20 ms

}  // namespace

template <class Signal>
void BodyView::Recent<Signal>::take(const Signal& signal, std::uint64_t time_ns) {
  heard_ns_ = time_ns;
  samples_.push_back(signal);
  if (samples_.size() > kMostSamples) {
    samples_.pop_front();
  }
}

template <class Signal>
std::optional<Signal> BodyView::Recent<Signal>::at(Tick tick, std::uint64_t time_ns) {
  if (samples_.empty() || static_cast<double>(time_ns - std::min(heard_ns_, time_ns)) * 1e-9 > kSilent_s) {
    return std::nullopt;
  }
  while (samples_.size() > 1 && samples_[1].tick <= tick) {
    samples_.pop_front();
  }
  return samples_.front();
}

std::optional<BodyView> BodyView::create(const robot::Robot& robot) {
  if (!robot.body) {
    return std::nullopt;
  }
  auto body = body::RigidBody::create(*robot.body);
  return body ? std::optional(BodyView(robot, std::move(body).value())) : std::nullopt;
}

void BodyView::begin_anew() {
  truths_.clear();
  states_.clear();
}

BodyFrame BodyView::frame(std::span<const JointFrame> joints, std::uint64_t time_ns) {
  auto moved = body::BodyState::zero(body_.joints());
  Tick tick = std::numeric_limits<Tick>::max();
  for (const robot::Joint& joint : robot_->joints) {
    const signals::JointSummary& summary = joints[joint.number].newest;
    const bool heard = summary.tick != kNoTick;
    moved.angles_rad[joint.number] =
        heard ? joint.linkage.angle(summary.position_m_or_rad) : std::numeric_limits<double>::quiet_NaN();
    tick = heard ? std::min(tick, summary.tick) : tick;
  }
  body_.set_state(moved);
  BodyFrame frame;
  for (int leg = 0; leg < body_.legs(); ++leg) {
    BodyFrame::Leg placed;
    for (int index = 0; index < body::kJointsPerLeg; ++index) {
      placed.hinges_m[static_cast<std::size_t>(index)] = body_.hinge_position_m(leg, index);
    }
    placed.foot_m = body_.foot_position_m(leg);
    frame.legs.push_back(placed.foot_m.allFinite() ? std::optional(placed) : std::nullopt);
  }
  frame.centre_of_mass_m = body_.centre_of_mass_m();
  frame.truth = truths_.at(tick, time_ns);
  frame.state = states_.at(tick, time_ns);
  return frame;
}

}  // namespace farrier::monitor
