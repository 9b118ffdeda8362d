#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/publisher/qos/PublisherQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/subscriber/qos/SubscriberQos.hpp>

#include <memory>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "bus/network.hpp"
#include "bus_fastdds/fast_transport.hpp"

namespace farrier::bus_fastdds {

namespace dds = eprosima::fastdds::dds;

/// The one transport of a participant; its `receiving` is to be set once the participant exists.
std::shared_ptr<FastTransportDescriptor> transport(const bus::NetworkOptions& options);

/// `index` gives the participant its well-known ports.
dds::DomainParticipantQos participant_qos(const bus::NetworkOptions& options, int index,
                                          std::shared_ptr<FastTransportDescriptor> transport);

dds::PublisherQos publisher_qos(const std::vector<std::string>& partitions);
dds::SubscriberQos subscriber_qos(const std::vector<std::string>& partitions);

/// `secured`: of a participant that encrypts.
dds::DataWriterQos writer_qos(const bus::EndpointSpec& endpoint, bool secured);
dds::DataReaderQos reader_qos(const bus::EndpointSpec& endpoint);

}  // namespace farrier::bus_fastdds
