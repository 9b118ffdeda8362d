#include "tools/playback/recorded_run.hpp"

#include "mcap/reader.hpp"

namespace farrier::playback {

bool is_recording(const std::string& path) { return mcap::Reader::open(path).ok(); }

Result<RecordedRun> RecordedRun::open(const std::string& path, const robot::Overrides& overrides, KeepOn keep_on) {
  auto file = FARRIER_TRY(recording::RunFileReader::open(path));
  file.ask(keep_on);
  recording::Sample first;
  const bool any = file.next(first);
  if (file.ending() == recording::kInterrupted) {
    return Error{path + ": " + file.ending()};
  }
  if (std::string nothing = file.nothing_of_farrier(); !nothing.empty()) {
    return Error{std::move(nothing)};
  }
  mcap::Text facts = file.metadata(recording::kRunFacts);
  if (facts.empty()) {  // a writer may put them behind the samples
    facts = mcap::find_metadata(path, recording::kRunFacts, keep_on).value_or(mcap::Metadata{}).values;
  }
  const auto configuration = facts.find("configuration");
  if (configuration == facts.end()) {
    return Error{path + " does not say of which robot it is: give a recording of farrier record"};
  }
  if (!any) {
    return Error{path + " has no samples" + (file.ending().empty() ? "" : ": " + file.ending())};
  }
  auto robot = robot::load_robot_text(configuration->second, path, overrides);
  if (!robot) {
    return Error{config::to_string(robot.error())};
  }
  return RecordedRun(std::move(file), std::move(robot).value(), std::move(facts), first);
}

bool RecordedRun::next(recording::Sample& sample) {
  if (first_is_next_) {
    first_is_next_ = false;
    sample = first_;
    return true;
  }
  return file_.next(sample);
}

}  // namespace farrier::playback
