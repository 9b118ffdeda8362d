#pragma once

#include <deque>
#include <vector>

#include "bus/topics.hpp"
#include "monitor/body_view.hpp"
#include "monitor/frame.hpp"
#include "monitor/supply_view.hpp"
#include "robot/robot.hpp"
#include "recording/recording_file.hpp"

namespace farrier::monitor {

/// Makes frames from samples, whether they come from a bus (recorder::Recorder) or a recording
/// (recording::RunFileReader). Times are log times.
class RobotView {
 public:
  /// `robot` must outlive it.
  explicit RobotView(const robot::Robot& robot);

  /// Topics it reads. Summaries of joints come fifty a second, copies of their estimates ten a second, at any control
  /// period. The state of the body and, from a simulation, its truth come at every tick, those of the supply every 10
  /// ms.
  static const std::vector<bus::TopicId>& topics();

  /// Samples of other topics, and of joints and legs that the robot does not have, are left out. A new session,
  /// announced by a hello, resets the view; events stay.
  void take(const recording::Sample& sample);

  /// Adds an event of the monitor's own.
  void note(signals::Severity severity, std::string text, std::uint64_t time_ns);

  /// Frame at `time_ns`, which is not before the last sample's time. Everything "since the last frame" is then reset.
  Frame frame(std::uint64_t time_ns);

 private:
  /// One second of a joint's summaries.
  struct Heard {
    std::uint64_t time_ns;
    Tick tick;
    int ticks;
    double squared_error, squared_reference;
  };
  struct Joint {
    JointFrame now;
    std::deque<Heard> second;
    std::uint64_t heard_ns = 0;  ///< 0: never
  };
  struct Participant {
    ParticipantFrame now;
    std::uint64_t heard_ns = 0;
  };
  struct Switch {
    Tick tick;
    signals::Phase phase;
  };

  void take(const signals::JointSummary& summary);
  void take(const signals::JointControllerGains& gains);
  void take(const signals::JointModelEstimateCopy& estimate);
  void take(const signals::JointUpdateDecision& decision);
  void take(const signals::GaitPhase& phase);
  void take(const signals::SystemMode& mode);
  void take(const signals::SystemHello& hello);
  void take(const signals::SystemHealth& health);
  void take(const signals::SystemEvent& event);
  void take(const signals::BodyTruth& truth);
  void take(const signals::BodyState& state);
  void take(const signals::SupplyState& state) { supply_.take(state, newest_ns_); }
  void take(const signals::SupplyTruth& truth) { supply_.take(truth); }
  template <class Signal>
  void take(const Signal&) {}

  void begin_anew();
  double since_first_s(std::uint64_t time_ns) const noexcept;

  const robot::Robot& robot_;
  std::optional<BodyView> body_;
  SupplyView supply_;
  std::uint64_t first_ns_ = 0, newest_ns_ = 0;  ///< log times; 0: none yet
  std::uint64_t session_ = 0;
  Tick tick_ = kNoTick;
  signals::SystemMode mode_;
  std::vector<Joint> joints_;
  std::vector<LegFrame> legs_;
  std::vector<std::vector<Switch>> switches_;  ///< by leg, announced and still ahead, behind the one that holds
  std::vector<Participant> participants_;
  std::vector<EventFrame> events_;
  std::uint64_t event_count_ = 0;
};

}  // namespace farrier::monitor
