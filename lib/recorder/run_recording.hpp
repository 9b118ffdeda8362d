#pragma once

#include <memory>
#include <string>

#include "participant/participant.hpp"
#include "recorder/recorder.hpp"
#include "recording/background_writer.hpp"

namespace farrier::recorder {

/// A recording of a lock-step run by one of its participants. The run begins only when it hears every process, and goes
/// on only when its participant does: every sample of every tick is in it.
class RunRecording {
 public:
  /// Opens ports of `participant`, which outlives it; hence before the greeting. `facts`: recording::kRunFacts. Refuses
  /// a file that cannot be written, and if the bus refuses.
  static Result<std::unique_ptr<RunRecording>> create(const std::string& path, const mcap::Text& facts,
                                                      const robot::Robot& robot,
                                                      participant::Participant& participant);

  /// Takes the samples that have come. Call it at least once in two hundred ticks, or samples are overwritten, which
  /// finish() reports.
  void poll();

  /// True if this many ticks are complete, with every joint's sensors, valve command and measurement.
  bool has(Tick ticks) const;

  /// Ends the file. Refuses when it lacks samples, with topic and number, and when the disk did not take everything.
  Result<Done> finish(Tick ticks);

 private:
  RunRecording(Recorder recorder, recording::RunFileWriter file, std::size_t joints)
      : recorder_(std::move(recorder)), file_(std::move(file)), joints_(joints) {}

  Recorder recorder_;
  recording::BackgroundWriter file_;
  std::size_t joints_;
};

}  // namespace farrier::recorder
