#include "tools/ros_bag/export_bag.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/transport.hpp"
#include "monitor/robot_view.hpp"
#include "recording/visit_sample.hpp"
#include "ros_view/robot_messages.hpp"
#include "signals/tick_of.hpp"
#include "tools/playback/recorded_run.hpp"
#include "tools/ros_bag/bag_writer.hpp"
#include "urdf/urdf_text.hpp"

namespace farrier::ros_bag {
namespace {

constexpr std::uint64_t kFrame_ns = 50'000'000;
constexpr std::uint64_t kViewBegin_ns = 1'000'000'000;   // for the view 0 is no time
constexpr std::uint64_t kLongestLag_ns = 2'000'000'000;  // of a topic behind another: recorders write them in blocks
constexpr Tick kMostTicks = 4'000'000'000;               // 46 days at 1 kHz; more is damage

/// Topics of which messages are made.
std::vector<bus::TopicId> all_topics() {
  std::vector<bus::TopicId> topics = ros_view::frame_topics();
  using enum bus::TopicId;
  topics.insert(topics.end(), {kJointSensors, kBodyImu, kBodyState});
  return topics;
}

/// Time of samples in a bag, ns since 1970, without steps of the clock of day.
class SampleTime {
 public:
  SampleTime(bool simulated, double period_s) : simulated_(simulated), period_s_(period_s) {}

  template <class Signal>
  std::uint64_t of(const recording::Sample& sample, const Signal& signal) {
    if (!begin_) {
      const std::uint64_t elapsed_ns = std::min(sample.elapsed_ns, sample.log_time_ns);
      begin_ = TickTime{0, std::max<std::uint64_t>(sample.log_time_ns - elapsed_ns, 1)};
    }
    const Tick tick = signals::kIsOrder<Signal> ? kNoTick : signals::tick_of(signal);
    if (simulated_) {
      newest_ns_ = time_of_tick(*begin_, tick).value_or(std::max(newest_ns_, begin_->time_ns));
      return newest_ns_;
    }
    const std::uint64_t heard_ns = begin_->time_ns + sample.elapsed_ns;
    if constexpr (requires { signal.sample_time_ns; }) {
      const std::uint64_t age_ns = sample.log_time_ns - std::min(sample.publish_time_ns, sample.log_time_ns);
      const std::uint64_t time_ns = heard_ns - std::min(age_ns, sample.elapsed_ns);
      if (tick >= 0 && tick <= kMostTicks) {
        sampled_ = TickTime{tick, time_ns};
      }
      return time_ns;
    }
    // Heard in blocks, so its tick says more than when it was heard.
    return sampled_ ? time_of_tick(*sampled_, tick).value_or(heard_ns) : heard_ns;
  }

 private:
  struct TickTime {
    Tick tick;
    std::uint64_t time_ns;
  };

  /// Time of a tick, counted in periods from another one; none for no tick, and for one that is damaged.
  std::optional<std::uint64_t> time_of_tick(const TickTime& known, Tick tick) const {
    if (tick < 0 || tick > kMostTicks) {
      return std::nullopt;
    }
    const double since_s = static_cast<double>(tick - known.tick) * period_s_;
    if (static_cast<double>(known.time_ns) + since_s * 1e9 < 1.0) {
      return std::nullopt;
    }
    return known.time_ns + static_cast<std::uint64_t>(std::llround(since_s * 1e9));
  }

  bool simulated_;
  double period_s_;
  std::optional<TickTime> begin_;    // tick 0 in simulated time
  std::optional<TickTime> sampled_;  // newest sensors
  std::uint64_t newest_ns_ = 0;
};

class Exporter {
 public:
  Exporter(const robot::Robot& robot, const ros_view::RobotMessages::Options& options, bool simulated, BagWriter& bag)
      : messages_(robot, options), view_(robot), time_(simulated, robot.period_s), bag_(bag) {}

  void take(const recording::Sample& sample) {
    if (std::ranges::find(topics_, sample.topic) == topics_.end()) {
      return;
    }
    recording::visit_sample(sample, [&](const auto& signal) {
      if (!signals::is_probe(signal)) {
        const std::uint64_t time_ns = time_.of(sample, signal);
        newest_ns_ = std::max(newest_ns_, time_ns);
        waiting_.emplace(time_ns, Kept{sample, {sample.cdr.begin(), sample.cdr.end()}});
      }
    });
    while (!waiting_.empty() && waiting_.begin()->first + kLongestLag_ns < newest_ns_) {
      hear_first();
    }
  }

  void finish() {
    while (!waiting_.empty()) {
      hear_first();
    }
    look();
    publish();
  }

  /// Topics without a message.
  std::vector<std::string> missing() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < messages_.topics().size(); ++i) {
      if (!bag_.has(i)) {
        names.push_back(messages_.topics()[i].name);
      }
    }
    return names;
  }

 private:
  struct Kept {
    recording::Sample sample;  // without its bytes
    std::vector<std::uint8_t> cdr;
  };

  /// Takes the earliest sample that waits.
  void hear_first() {
    const auto first = waiting_.extract(waiting_.begin());
    const std::uint64_t time_ns = first.key();
    recording::Sample sample = first.mapped().sample;
    sample.cdr = first.mapped().cdr;
    advance(time_ns);
    recording::visit_sample(sample, [&](const auto& signal) { hear(signal, time_ns); });
    if (std::ranges::find(frame_topics_, sample.topic) != frame_topics_.end()) {
      sample.log_time_ns = kViewBegin_ns + sample.elapsed_ns;
      view_now_ns_ = std::max(view_now_ns_, sample.log_time_ns);
      view_.take(sample);
      viewed_ = true;
    }
  }

  /// Samples up to now are of earlier times, so that messages can be made of them.
  void advance(std::uint64_t time_ns) {
    if (time_ns <= now_ns_) {
      return;
    }
    if (now_ns_ == 0) {
      next_look_ns_ = time_ns + kFrame_ns;
    } else {
      publish();
    }
    now_ns_ = time_ns;
    if (now_ns_ >= next_look_ns_) {
      next_look_ns_ = now_ns_ + kFrame_ns;
      look();
    }
  }

  void look() {
    if (viewed_) {
      messages_.take(view_.frame(view_now_ns_), now_ns_);
    }
  }

  void publish() {
    const auto write = [this](std::size_t topic, std::uint64_t time_ns, std::span<const std::uint8_t> cdr) {
      if (bag_.messages() == 0) {
        describe(time_ns);
      }
      bag_.write(topic, messages_.topics()[topic], time_ns, cdr);
    };
    messages_.publish(now_ns_, write);
  }

  /// The description comes first, so that who plays the bag has it from the begin on.
  void describe(std::uint64_t time_ns) {
    if (const std::vector<std::uint8_t> cdr = messages_.description_cdr(); !cdr.empty()) {
      const std::size_t topic = messages_.description_topic();
      bag_.write(topic, messages_.topics()[topic], time_ns, cdr);
    }
  }

  void hear(const signals::JointSensors& sensors, std::uint64_t time_ns) { messages_.take(sensors, time_ns); }
  void hear(const signals::JointSummary& summary, std::uint64_t) { messages_.take(summary); }
  void hear(const signals::BodyImu& imu, std::uint64_t time_ns) { messages_.take(imu, time_ns); }
  void hear(const signals::BodyState& state, std::uint64_t time_ns) { messages_.take(state, time_ns); }
  template <class Signal>
  void hear(const Signal&, std::uint64_t) {}

  ros_view::RobotMessages messages_;
  monitor::RobotView view_;
  SampleTime time_;
  BagWriter& bag_;
  const std::vector<bus::TopicId> frame_topics_ = ros_view::frame_topics();
  const std::vector<bus::TopicId> topics_ = all_topics();
  std::multimap<std::uint64_t, Kept> waiting_;  // by time
  std::uint64_t newest_ns_ = 0;
  std::uint64_t now_ns_ = 0, next_look_ns_ = 0;
  std::uint64_t view_now_ns_ = kViewBegin_ns;
  bool viewed_ = false;
};

}  // namespace

Result<Exported> export_bag(const std::string& recording, const std::string& folder, const ExportOptions& options,
                            const KeepOn& keep_on) {
  auto run = FARRIER_TRY(playback::RecordedRun::open(recording, {}, keep_on));
  const robot::Robot& robot = run.robot();
  ros_view::RobotMessages::Options made;
  made.ros_namespace = options.ros_namespace.empty() ? "/" + robot.name : options.ros_namespace;
  made.rate_Hz = options.rate_Hz;
  if (robot.body) {
    made.description = FARRIER_TRY(urdf::urdf_text(robot));
  }
  const auto clock = run.facts().find("clock");
  const bool simulated = clock != run.facts().end() && clock->second == name_of(kClockKinds, ClockKind::kLockstep);
  auto bag = FARRIER_TRY(BagWriter::create(folder));
  Exporter exporter(robot, made, simulated, bag);
  for (recording::Sample sample; !bag.failed() && run.next(sample);) {
    exporter.take(sample);
  }
  if (run.ending() == recording::kInterrupted) {
    return Error{run.ending()};
  }
  exporter.finish();
  if (bag.messages() == 0) {
    return Error{recording + " has no samples of which messages of ROS could be made: record all topics"};
  }
  FARRIER_TRY(bag.finish());
  return Exported{bag.messages(), exporter.missing(), run.ending()};
}

}  // namespace farrier::ros_bag
