#pragma once

#include <dds/dds.h>

#include <memory>

#include "bus/bus.hpp"

namespace farrier::bus_cyclone {

/// Cyclone's description of a topic's type.
const dds_topic_descriptor_t& topic_descriptor(bus::TopicId topic);

/// Wraps a DDS writer of this topic; owns it from here on.
std::unique_ptr<bus::RawWriter> wrap_writer(bus::TopicId topic, dds_entity_t writer);

/// Creates a DDS reader of this topic that counts its arrivals in `notifier`, if that is not null.
Result<std::unique_ptr<bus::RawReader>> make_reader(bus::TopicId topic, dds_entity_t subscriber,
                                                    dds_entity_t dds_topic, const dds_qos_t& qos,
                                                    std::shared_ptr<bus::Notifier> notifier);

}  // namespace farrier::bus_cyclone
