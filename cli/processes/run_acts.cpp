#include "cli/processes/run_acts.hpp"

#include <csignal>

#include <algorithm>

namespace farrier::cli {
namespace {

constexpr int kHour_s = 3600;

}  // namespace

Result<RunActs> RunActs::create(std::vector<Act> acts, participant::Participant& participant,
                                std::optional<HostClock> clock) {
  RunActs run(std::move(acts), participant.identity().session, std::move(clock));
  if (std::ranges::any_of(run.acts_, [](const Act& act) { return act.member.empty(); })) {
    auto requests = FARRIER_TRY(bus::Publisher<signals::SystemRequest>::create(
        participant.bus(), participant::endpoint_of(participant.identity(), bus::TopicId::kSystemRequest)));
    run.requests_.emplace(std::move(requests));
  }
  return run;
}

Result<Done> RunActs::perform(Tick due, Tick tick, std::vector<ChildProcess>& children, const Start& start) {
  while (performed_.size() < acts_.size() && acts_[performed_.size()].at <= due) {
    const Act& act = acts_[performed_.size()];
    if (act.member.empty()) {
      signals::SystemRequest request;
      request.session = session_;
      request.tick = tick;
      request.count = ++asked_;
      request.request = act.request;
      requests_->publish(request);
    } else if (run::sets_clock(act.signal)) {
      FARRIER_TRY(clock_->set(act.signal == run::kClockForward ? kHour_s : -kHour_s));
    } else if (act.signal == run::kStart || act.signal == run::kStartTwin) {
      auto started = FARRIER_TRY(start(act.member, act.signal == run::kStart ? act.member : act.member + "_twin"));
      std::erase_if(children, [&](const ChildProcess& child) { return child.name() == started.name(); });
      children.push_back(std::move(started));
    } else if (const auto child = std::ranges::find(children, act.member, &ChildProcess::name);
               child != children.end()) {
      ::kill(child->pid(), act.signal);
    }
    performed_.push_back(tick);
  }
  return Done{};
}

}  // namespace farrier::cli
