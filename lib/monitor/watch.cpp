#include "monitor/watch.hpp"

#include <algorithm>
#include <utility>

#include "participant/clock.hpp"

namespace farrier::monitor {
namespace {

constexpr std::uint64_t kBetweenNotes_ns = 5'000'000'000;  // of one topic: a bad network would fill the page

}  // namespace

Result<Watch> Watch::create(bus::Bus& bus, const robot::Robot& robot) {
  auto recorder = FARRIER_TRY(recorder::Recorder::create(bus, robot, RobotView::topics()));
  return Watch(std::move(recorder), robot);
}

Frame Watch::look() {
  // The clock of day may be set while a robot runs.
  const auto now_ns = static_cast<std::uint64_t>(participant::steady_now().time_since_epoch().count());
  recorder_.drain([&](recording::Sample sample) {
    sample.log_time_ns = now_ns;
    view_.take(sample);
  });
  const std::uint64_t lost = note_losses(now_ns);
  Frame frame = view_.frame(now_ns);
  frame.lost_samples = lost;
  return frame;
}

std::uint64_t Watch::note_losses(std::uint64_t time_ns) {
  std::uint64_t all = 0;
  for (const recorder::TopicProgress& topic : recorder_.progress()) {
    const std::string name = bus::spec(topic.topic).name;
    Told& told = told_[static_cast<std::size_t>(topic.topic)];
    // Some topics have a sequence of their own; of the others the transport alone knows.
    const std::uint64_t lost = std::max(topic.lost, topic.reader.lost);
    all += lost;
    if (topic.reader.incompatible_qos > told.refused) {
      told.refused = topic.reader.incompatible_qos;
      view_.note(signals::Severity::kWarning, "cannot hear a writer of " + name + " for its QoS; which: farrier topics",
                 time_ns);
    }
    if (lost > told.lost && time_ns >= told.time_ns + kBetweenNotes_ns) {
      view_.note(signals::Severity::kWarning,
                 std::to_string(lost - told.lost) + " samples of " + name + " lost on the way to this monitor",
                 time_ns);
      told.lost = lost;
      told.time_ns = time_ns;
    }
  }
  return all;
}

}  // namespace farrier::monitor
