#include "recording/recording_file.hpp"

#include <algorithm>
#include <filesystem>

#include "core/replace_file.hpp"
#include "recording/idl_text.hpp"

namespace farrier::recording {
namespace {

constexpr const char* kProfile = "farrier";
constexpr const char* kVersion = "version";  // of a topic, in its channel's metadata

const bus::TopicSpec* find_topic(const std::string& name) {
  const auto topics = bus::topics();
  const auto found = std::ranges::find_if(topics, [&](const bus::TopicSpec& topic) { return topic.name == name; });
  return found == topics.end() ? nullptr : &*found;
}

/// A device or a pipe, which is written where it is.
bool is_special(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown) && !std::filesystem::is_regular_file(path, unknown);
}

}  // namespace

std::string path_while_written(const std::string& path) { return is_special(path) ? path : part_path(path); }

std::string left_behind(const std::string& path) {
  return path.empty() ? "" : "; what was recorded is in " + path_while_written(path);
}

Result<RunFileWriter> RunFileWriter::create(const std::string& path, const mcap::Text& facts) {
  auto file = FARRIER_TRY(mcap::Writer::create(path_while_written(path), kProfile, "farrier"));
  RunFileWriter writer(std::move(file), is_special(path) ? "" : path);
  for (const bus::TopicSpec& topic : bus::topics()) {
    const std::uint16_t schema =
        writer.file_.add_schema({.name = topic.type_name, .encoding = "omgidl", .data = idl_text(topic.id)});
    writer.file_.add_channel({.schema_id = schema,
                              .topic = topic.name,
                              .message_encoding = "cdr",
                              .metadata = {{kVersion, std::to_string(topic.version)}}});
  }
  writer.file_.write(mcap::Metadata{kRunFacts, facts});
  writer.flush();
  return writer;
}

mcap::Message message_of(const Sample& sample) noexcept {
  return {.channel_id = static_cast<std::uint16_t>(sample.topic),
          .sequence = sample.sequence,
          .log_time_ns = sample.log_time_ns,
          .publish_time_ns = sample.publish_time_ns,
          .data = sample.cdr};
}

void RunFileWriter::write(const Sample& sample) { file_.write(message_of(sample)); }

Result<Done> RunFileWriter::finish(const TopicCounts& lost) {
  mcap::Metadata losses{kLosses, {}};
  for (const bus::TopicSpec& topic : bus::topics()) {
    losses.values[topic.name] = std::to_string(lost[static_cast<std::size_t>(topic.id)]);
  }
  file_.write(losses);
  if (auto finished = file_.finish(); !finished) {
    return finished;
  }
  return path_.empty() ? Result<Done>(Done{}) : name_part(path_);
}

Result<RunFileReader> RunFileReader::open(const std::string& path) {
  auto file = FARRIER_TRY(mcap::Reader::open(path));
  return RunFileReader(std::move(file));
}

bool RunFileReader::next(Sample& sample) {
  const bool more = keeps_on() && read(sample);
  if (!more) {
    keep_on_ = nullptr;
  }
  return more;
}

bool RunFileReader::keeps_on() {
  if (keep_on_ && asked_ != file_.chunks()) {
    asked_ = file_.chunks();
    if (!keep_on_(file_.share_read())) {
      ending_ = kInterrupted;
    }
  }
  return ending_.empty();
}

bool RunFileReader::read(Sample& sample) {
  mcap::Message message;
  while (ending_.empty() && file_.next(message)) {
    auto [known, added] = topics_.try_emplace(message.channel_id);
    if (added) {
      const mcap::Channel& channel = file_.channels().at(message.channel_id);
      const bus::TopicSpec* topic = find_topic(channel.topic);
      const auto version = channel.metadata.find(kVersion);
      if (topic != nullptr && version != channel.metadata.end() && version->second != std::to_string(topic->version)) {
        ending_ = channel.topic + " is of version " + version->second + ", this farrier's is of version " +
                  std::to_string(topic->version) + ": read it with the farrier that wrote it";
        return false;
      }
      known->second = channel.message_encoding == "cdr" && version != channel.metadata.end() ? topic : nullptr;
    }
    if (known->second != nullptr) {
      sample = {known->second->id, message.sequence, message.log_time_ns, message.publish_time_ns, message.data};
      return true;
    }
  }
  return false;
}

mcap::Text RunFileReader::metadata(const std::string& name) const {
  for (const mcap::Metadata& one : file_.metadata()) {
    if (one.name == name) {
      return one.values;
    }
  }
  return {};
}

}  // namespace farrier::recording
