#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "mcap/writer.hpp"
#include "tools/ros_bag/bag_metadata.hpp"

namespace farrier::ros_bag {

/// Writes a bag of rosbag2: a folder of an MCAP file and metadata.yaml. Until finish() the folder has ".part" behind its
/// name; without it, the destructor removes the folder.
class BagWriter {
 public:
  /// Refuses a folder that exists, also as ".part", and one that cannot be made.
  static Result<BagWriter> create(const std::string& folder);
  BagWriter(BagWriter&&) noexcept = default;
  BagWriter& operator=(BagWriter&&) = delete;
  ~BagWriter();

  /// A topic comes into the bag with its first message. `topic` has the place `index` among all of the caller's.
  void write(std::size_t index, const ros_view::Topic& topic, std::uint64_t time_ns, std::span<const std::uint8_t> cdr);

  /// True if the disk has refused bytes.
  bool failed() const noexcept { return file_->failed(); }
  /// Messages so far.
  std::uint64_t messages() const noexcept { return content_.messages; }
  /// True if the topic of this place has a message.
  bool has(std::size_t index) const noexcept { return index < channels_.size() && channels_[index].has_value(); }

  /// Gives the folder its name. Refuses if the disk has not taken everything.
  Result<Done> finish();

 private:
  struct Channel {
    std::uint16_t id;
    std::size_t place;  // in content_.topics
  };

  BagWriter(mcap::Writer file, std::string folder, std::string part, std::string name);

  std::optional<mcap::Writer> file_;  // closed before its folder goes
  std::string folder_, part_;         // part_ is empty once it has its name
  BagContent content_;
  std::vector<std::optional<Channel>> channels_;
  std::map<std::string, std::uint16_t> schemas_;  // by type
};

}  // namespace farrier::ros_bag
