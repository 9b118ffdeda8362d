#include "cli/processes/helm.hpp"

namespace farrier::cli {

Result<Helm> Helm::create(participant::Participant& participant,
                          std::function<Steered(Tick, const signals::BodyState&)> steers) {
  const participant::Identity& identity = participant.identity();
  bus::EndpointSpec listening = participant::endpoint_of(identity, bus::TopicId::kBodyState);
  listening.wakes = false;
  auto states = FARRIER_TRY(bus::Subscription<signals::BodyState>::create(participant.bus(), listening));
  auto commands = FARRIER_TRY(bus::Publisher<signals::BodyCommand>::create(
      participant.bus(), participant::endpoint_of(identity, bus::TopicId::kBodyCommand)));
  auto requests = FARRIER_TRY(bus::Publisher<signals::SystemRequest>::create(
      participant.bus(), participant::endpoint_of(identity, bus::TopicId::kSystemRequest)));
  return Helm(identity.session, std::move(states), std::move(commands), std::move(requests), std::move(steers));
}

bool Helm::steer(Tick tick) {
  states_.drain([this](const signals::BodyState& state) {
    if (!signals::is_probe(state)) {
      newest_ = state;
    }
  });
  Steered steered = steers_(tick, newest_);
  if (steered.command) {
    steered.command->session = session_;
    steered.command->count = ++count_;
    commands_.publish(*steered.command);
  }
  if (steered.stops) {
    signals::SystemRequest request;
    request.session = session_;
    request.tick = tick;
    request.count = ++count_;
    request.request = signals::Request::kStop;
    requests_.publish(request);
  }
  return steered.ends;
}

}  // namespace farrier::cli
