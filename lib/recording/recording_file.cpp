#include "recording/recording_file.hpp"

#include <filesystem>

#include "core/replace_file.hpp"
#include "recording/idl_text.hpp"

namespace farrier::recording {
namespace {

constexpr const char* kProfile = "farrier";

/// A device or a pipe, which is written where it is.
bool is_special(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown) && !std::filesystem::is_regular_file(path, unknown);
}

}  // namespace

std::string path_while_written(const std::string& path) { return is_special(path) ? path : part_path(path); }

Result<Done> refuse_existing(const std::string& path) {
  std::error_code unknown;
  if (std::filesystem::is_regular_file(path, unknown)) {
    return Error{path + " is there already: give another file, or --force to replace it"};
  }
  const std::string part = part_path(path);
  if (!is_special(path) && std::filesystem::is_regular_file(part, unknown) &&
      std::filesystem::file_size(part, unknown) > 0) {
    return Error{part +
                 " is there, of a recorder that was killed or still runs: give another file or rename that one, "
                 "or --force to replace it"};
  }
  return Done{};
}

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
                              .metadata = {{kVersionOfTopic, std::to_string(topic.version)}}});
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

}  // namespace farrier::recording
