#pragma once

#include <dds/dds.h>

#include "bus_ros/ros_endpoints.hpp"

namespace farrier::bus_ros {

/// Opens a writer of a DDS topic ("rt/hyq/joint_states"). `user_data`: "typehash=...;", or empty.
Result<std::shared_ptr<RawRosWriter>> open_writer(dds_entity_t participant, const std::string& topic,
                                                  const std::string& ros_type, const RosQos& qos,
                                                  const std::string& user_data);

/// The same for a reader.
Result<std::shared_ptr<RawRosReader>> open_reader(dds_entity_t participant, const std::string& topic,
                                                  const std::string& ros_type, const RosQos& qos,
                                                  const std::string& user_data);

/// The GUID of an entity.
Gid gid_of(dds_entity_t entity);

}  // namespace farrier::bus_ros
