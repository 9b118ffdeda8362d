#pragma once

// Calls of Cyclone DDS that both of its users share: the robot's bus and the node of ROS 2.

#include <dds/dds.h>

#include <memory>
#include <string>

#include "core/result.hpp"

namespace farrier::cyclone_base {

struct QosDeleter {
  void operator()(dds_qos_t* qos) const noexcept { dds_delete_qos(qos); }
};
using QosPtr = std::unique_ptr<dds_qos_t, QosDeleter>;

/// QoS of every endpoint. The newest `depth` samples of a key are kept, also for late joiners of a transient-local writer. A
/// key whose writer has ended stays: no sample means "gone". The representation is XCDR1, the only one that Fast DDS 2.9 and
/// the nodes of ROS 2 know.
QosPtr endpoint_qos(int depth);

/// Error for a call that Cyclone refused, with its reason.
Error refused(const std::string& what, dds_return_t code);

/// An element of Cyclone's configuration.
std::string element(const std::string& name, const std::string& content);

/// Elements of an address list: computers to look for participants on.
std::string peer_elements(const auto& addresses) {
  std::string peers;
  for (const std::string& address : addresses) {
    peers += "<Peer Address=\"" + address + "\"/>";
  }
  return peers;
}

/// The part of a GUID that all entities of a participant share.
inline constexpr std::size_t kPrefixBytes = 12;

/// It in hexadecimal digits.
std::string prefix_text(const dds_guid_t& guid);

}  // namespace farrier::cyclone_base
