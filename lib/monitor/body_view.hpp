#pragma once

#include <deque>
#include <span>

#include "body/dynamics/rigid_body.hpp"
#include "monitor/frame.hpp"
#include "robot/robot.hpp"

namespace farrier::monitor {

/// Makes the part of a frame that shows the robot in space: its legs by the angles that joints report, its trunk by
/// what a simulation and locomotion say.
class BodyView {
 public:
  /// `robot` must outlive it. None for a robot whose file describes no rigid bodies.
  static std::optional<BodyView> create(const robot::Robot& robot);

  /// `time_ns`: log time of the sample.
  void take(const signals::BodyTruth& truth, std::uint64_t time_ns) { truths_.take(truth, time_ns); }
  void take(const signals::BodyState& state, std::uint64_t time_ns) { states_.take(state, time_ns); }

  /// Forgets all samples: another run begins.
  void begin_anew();

  /// `joints` by number. Trunk and legs are of one tick as far as samples allow: the newest that every joint has
  /// reported. Samples older than kSilent_s are left out.
  BodyFrame frame(std::span<const JointFrame> joints, std::uint64_t time_ns);

 private:
  /// The newest samples of a topic.
  template <class Signal>
  class Recent {
   public:
    void take(const Signal& signal, std::uint64_t time_ns);
    void clear() { samples_.clear(); }
    /// The newest that is not after `tick`, or the oldest there is; forgets those before it.
    std::optional<Signal> at(Tick tick, std::uint64_t time_ns);

   private:
    std::deque<Signal> samples_;
    std::uint64_t heard_ns_ = 0;
  };

  BodyView(const robot::Robot& robot, body::RigidBody body) : robot_(&robot), body_(std::move(body)) {}

  const robot::Robot* robot_;
  body::RigidBody body_;
  Recent<signals::BodyTruth> truths_;
  Recent<signals::BodyState> states_;
};

}  // namespace farrier::monitor
