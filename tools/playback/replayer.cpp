#include "tools/playback/replayer.hpp"

#include <algorithm>

#include "participant/participant.hpp"
#include "participant/stream_journal.hpp"
#include "robot/keys.hpp"
#include "signals/cdr.hpp"

namespace farrier::playback {
namespace {

template <class Signal>
class TypedLine final : public Line {
 public:
  static Result<std::unique_ptr<Line>> create(bus::Bus& bus, const robot::Robot& robot) {
    const bus::TopicSpec& topic = bus::spec(bus::TopicOf<Signal>::id);
    bus::EndpointSpec endpoint = participant::endpoint_of(
        {.name = {}, .robot = robot.name, .clock = bus::ClockKind::kRealtime}, topic.id, robot::legs_of_joints(robot));
    // A recording that is paused is no process that died.
    endpoint.qos.deadline = bus::kInfinite;
    endpoint.qos.lease = bus::kInfinite;
    auto publisher = FARRIER_TRY(bus::Publisher<Signal>::create(bus, endpoint));
    std::unique_ptr<TypedLine> line(new TypedLine(std::move(publisher)));
    if constexpr (signals::kJournalled<Signal>) {
      endpoint.topic = bus::TopicId::kSystemJournal;
      endpoint.partitions = {bus::partition(robot.name)};
      auto journal = FARRIER_TRY(bus::Publisher<signals::SystemJournal>::create(bus, endpoint));
      line->journal_ = std::make_unique<participant::StreamJournal>(std::move(journal), 0, topic.id,
                                                                     bus::ClockKind::kRealtime);
    }
    return std::unique_ptr<Line>(std::move(line));
  }

  bool publish(std::span<const std::uint8_t> cdr) override {
    Signal signal;
    if (!signals::from_cdr(cdr, signal)) {
      return false;
    }
    const bool published = publisher_.publish(signal);
    if constexpr (signals::kJournalled<Signal>) {
      journal_->add(signal);
      journal_->flush();
    }
    return published;
  }

 private:
  explicit TypedLine(bus::Publisher<Signal> publisher) : publisher_(std::move(publisher)) {}

  bus::Publisher<Signal> publisher_;
  std::unique_ptr<participant::StreamJournal> journal_;  ///< where signals::kJournalled: for who records the replay
};

using MakeLine = Result<std::unique_ptr<Line>> (*)(bus::Bus&, const robot::Robot&);

#define FARRIER_LINE(Signal, file) &TypedLine<signals::Signal>::create,
constexpr MakeLine kLines[] = {FARRIER_SIGNALS(FARRIER_LINE)};
#undef FARRIER_LINE

}  // namespace

Result<Replayer> Replayer::create(bus::Bus& bus, const robot::Robot& robot, const std::vector<bus::TopicId>& topics) {
  Replayer replayer;
  for (const bus::TopicSpec& topic : bus::topics()) {
    replayer.lines_.emplace_back();
    if (topics.empty() || std::ranges::find(topics, topic.id) != topics.end()) {
      auto line = FARRIER_TRY(kLines[static_cast<std::size_t>(topic.id)](bus, robot));
      replayer.lines_.back() = std::move(line);
    }
  }
  return replayer;
}

bool Replayer::publish(const recording::Sample& sample) {
  const auto& line = lines_[static_cast<std::size_t>(sample.topic)];
  return line != nullptr && line->publish(sample.cdr);
}

}  // namespace farrier::playback
