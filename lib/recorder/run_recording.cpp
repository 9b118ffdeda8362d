#include "recorder/run_recording.hpp"

#include <algorithm>
#include <array>

namespace farrier::recorder {
namespace {

using enum bus::TopicId;

/// Topics of which every joint sends a sample in every tick.
constexpr std::array kOfEveryTick{kJointSensors, kJointValveCommand, kJointMeasurement};

}  // namespace

Result<std::unique_ptr<RunRecording>> RunRecording::create(const std::string& path, const mcap::Text& facts,
                                                           const robot::Robot& robot,
                                                           participant::Participant& participant) {
  auto recorder = FARRIER_TRY(Recorder::of_journals(participant, robot));
  auto file = FARRIER_TRY(recording::RunFileWriter::create(path, facts));
  return std::unique_ptr<RunRecording>(
      new RunRecording(std::move(recorder), std::move(file), robot.joints.size()));
}

void RunRecording::poll() {
  recorder_.drain([this](const recording::Sample& sample) { file_.offer(sample); });
}

bool RunRecording::has(Tick ticks) const {
  const std::uint64_t samples = static_cast<std::uint64_t>(ticks) * joints_;
  return std::ranges::all_of(recorder_.progress(), [&](const TopicProgress& topic) {
    return std::ranges::find(kOfEveryTick, topic.topic) == kOfEveryTick.end() || topic.samples >= samples;
  });
}

Result<Done> RunRecording::finish(Tick ticks) {
  poll();
  recording::TopicCounts lost = recorder_.lost();
  const bool complete = has(ticks);
  if (auto finished = file_.finish(lost); !finished) {
    return finished;
  }
  const recording::TopicCounts dropped = file_.dropped();
  for (const bus::TopicSpec& topic : bus::topics()) {
    const auto i = static_cast<std::size_t>(topic.id);
    if (lost[i] + dropped[i] > 0) {
      return Error{"the recording lacks " + std::to_string(lost[i] + dropped[i]) + " samples of " + topic.name};
    }
  }
  return complete ? Result<Done>(Done{}) : Error{"the recording ends before the run does"};
}

}  // namespace farrier::recorder
