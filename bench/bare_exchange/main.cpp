// bare_exchange: one process of farrier bench's baseline: the samples of a run, and nothing computed from them.

#include "bench/bare_exchange/bare_exchange.hpp"
#include "bench/bare_exchange/bare_realtime.hpp"
#include "process/process.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto options = participant::parse_options("bare_exchange", "Exchanges a run's samples bare", argc, argv);
  const bool lockstep = options.clock == bus::ClockKind::kLockstep;
  process::Factory<participant::RealtimeApplication> clock;
  if (options.number == participant::kSimBridge) {
    clock = [&](auto& member, const auto& robot) { return bench::create_bare_clock(robot, member, options.ticks); };
  }
  return process::run(
      options,
      [&](auto& member, const auto& robot) {
        return lockstep ? bench::create_bare(robot, options.joints, options.world == participant::World::kBody, member,
                                             options.ticks)
                        : bench::create_bare_answer(robot, options.joints, member);
      },
      clock);
}
