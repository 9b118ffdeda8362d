#include "tools/ros_bag/bag_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace farrier::ros_bag {
namespace {

namespace fs = std::filesystem;

}  // namespace

Result<BagWriter> BagWriter::create(const std::string& folder) {
  fs::path path = fs::path(folder).lexically_normal();
  path = path.has_filename() ? path : path.parent_path();  // "bag/"
  const fs::path part = path.string() + ".part";
  std::error_code refused;
  if (fs::symlink_status(path, refused).type() != fs::file_type::not_found) {
    return Error{path.string() + " is there already: give the name of a folder to be made"};
  }
  if (!fs::create_directory(part, refused)) {
    return Error{refused ? "cannot make " + part.string() + ": " + refused.message()
                         : part.string() + " is there already, perhaps of an export that was killed: remove it"};
  }
  const std::string name = path.filename().string() + "_0.mcap";
  auto file = mcap::Writer::create((part / name).string(), "ros2", "farrier");
  if (!file) {
    fs::remove_all(part, refused);
    return file.error();
  }
  return BagWriter(std::move(file).value(), path.string(), part.string(), name);
}

BagWriter::BagWriter(mcap::Writer file, std::string folder, std::string part, std::string name)
    : file_(std::move(file)), folder_(std::move(folder)), part_(std::move(part)) {
  content_.file = std::move(name);
}

BagWriter::~BagWriter() {
  if (!part_.empty()) {
    file_.reset();
    std::error_code gone;
    fs::remove_all(part_, gone);
  }
}

void BagWriter::write(std::size_t index, const ros_view::Topic& topic, std::uint64_t time_ns,
                      std::span<const std::uint8_t> cdr) {
  channels_.resize(std::max(channels_.size(), index + 1));
  std::optional<Channel>& channel = channels_[index];
  if (!channel) {
    std::uint16_t& schema = schemas_[topic.type];  // ids count from 1
    if (schema == 0) {
      schema = file_->add_schema({.name = topic.type, .encoding = "ros2msg", .data = topic.definition});
    }
    const mcap::Text metadata = {{"offered_qos_profiles", qos_profiles(topic)}, {"topic_type_hash", topic.type_hash}};
    channel = {
        file_->add_channel({.schema_id = schema, .topic = topic.name, .message_encoding = "cdr", .metadata = metadata}),
        content_.topics.size()};
    content_.topics.push_back({topic});
  }
  std::uint64_t& count = content_.topics[channel->place].messages;
  file_->write(mcap::Message{.channel_id = channel->id,
                             .sequence = static_cast<std::uint32_t>(count),
                             .log_time_ns = time_ns,
                             .publish_time_ns = time_ns,
                             .data = cdr});
  ++count;
  content_.first_ns = content_.messages == 0 ? time_ns : std::min(content_.first_ns, time_ns);
  content_.last_ns = std::max(content_.last_ns, time_ns);
  ++content_.messages;
}

Result<Done> BagWriter::finish() {
  file_->write(mcap::Metadata{.name = "rosbag2", .values = {{"serialized_metadata", bag_information(content_, 0)}}});
  FARRIER_TRY(file_->finish());
  file_.reset();
  std::ofstream metadata(part_ + "/metadata.yaml");
  metadata << "rosbag2_bagfile_information:\n" << bag_information(content_, 2);
  if (!metadata.flush()) {
    return Error{"cannot write " + part_ + "/metadata.yaml: " + std::strerror(errno)};
  }
  std::error_code refused;
  fs::rename(part_, folder_, refused);
  if (refused) {
    return Error{"cannot name " + part_ + " " + folder_ + ": " + refused.message()};
  }
  part_.clear();
  return Done{};
}

}  // namespace farrier::ros_bag
