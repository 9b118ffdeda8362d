#include "recorder/watching_endpoint.hpp"

#include "bus/watching.hpp"
#include "participant/participant.hpp"
#include "robot/keys.hpp"

namespace farrier::recorder {

bus::EndpointSpec watching_endpoint(const robot::Robot& robot, bus::TopicId topic, int depth) {
  bus::EndpointSpec endpoint =
      participant::endpoint_of({.name = {}, .robot = robot.name}, topic, robot::legs_of_joints(robot));
  endpoint.qos = bus::qos_for_watching(bus::spec(topic), depth);
  return endpoint;
}

}  // namespace farrier::recorder
