// farrier replay: a recording on the bus, as its robot's processes published it.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "bus_factory/bus_factory.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "recorder/watching_endpoint.hpp"
#include "cli/base/command.hpp"
#include "cli/base/long_work.hpp"
#include "cli/record/guest.hpp"
#include "cli/recording/rerun.hpp"
#include "cli/record/topic_choice.hpp"
#include "tools/playback/recorded_run.hpp"
#include "tools/playback/replayer.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;
using signals::SystemHello;

constexpr auto kListen = 1s;  // processes that run say hello fifty times a second while they start, then with health

struct ReplayOptions {
  std::string path;
  std::vector<std::string> topics;
  double speed = 1.0;
  std::string rerun_of;  ///< empty: nothing
  std::string vendor = "cyclone";
  bus::NetworkOptions network;
};

/// Refuses where a robot of this name runs: a replay would speak in the name of its processes.
Result<Done> nobody_is_there(bus::Bus& bus, const robot::Robot& robot, int domain) {
  auto hellos = FARRIER_TRY(
      bus::Subscription<SystemHello>::create(bus, recorder::watching_endpoint(robot, bus::TopicId::kSystemHello)));
  std::string heard;
  nap(bus, participant::steady_now() + kListen);
  hellos.drain([&](const SystemHello& hello) { heard = signals::text_of(hello.name); });
  if (!heard.empty()) {
    return Error{heard + " of robot " + robot.name + " runs in domain " + std::to_string(domain) +
                 ", and a replay would speak in its name: give a --domain of its own"};
  }
  return Done{};
}

/// Publishes all samples as far apart as they were recorded, without the steps of the clock; how many.
std::uint64_t play(bus::Bus& bus, playback::Replayer& replayer, playback::RecordedRun& run, double speed) {
  const SteadyTime begin = participant::steady_now();
  std::size_t told = 0;  // steps
  std::uint64_t published = 0;
  for (recording::Sample sample; run.next(sample);) {
    for (const auto& steps = run.timeline().steps(); told < steps.size(); ++told) {
      std::fprintf(stderr, "farrier replay: %s; the replay goes on without the step\n",
                   recording::to_string(steps[told]).c_str());
    }
    nap(bus, begin + Nanoseconds(static_cast<std::int64_t>(static_cast<double>(sample.elapsed_ns) / speed)));
    if (participant::stop_requested()) {
      break;
    }
    published += replayer.publish(sample) ? 1 : 0;
  }
  return published;
}

int run_replay(const ReplayOptions& o) {
  participant::install_signal_handlers();
  const KeepOn until_stopped = [](double) { return !participant::stop_requested(); };
  auto run = playback::RecordedRun::open(o.path, {}, o.rerun_of.empty() ? until_stopped : long_work("replay, reading"));
  if (!run) {
    return refuse("replay", run.error().message);
  }
  if (!o.rerun_of.empty()) {
    return rerun_estimator(run.value(), o.path);
  }
  const robot::Robot& robot = run.value().robot();
  auto bus = bus_factory::create_bus(bus::parse_vendor(o.vendor).value(), o.network);
  if (!bus) {
    return fail("replay", bus.error().message);
  }
  if (auto alone = nobody_is_there(*bus.value(), robot, o.network.domain); !alone) {
    return refuse("replay", alone.error().message);
  }
  auto replayer = playback::Replayer::create(*bus.value(), robot, topics_of(o.topics));
  if (!replayer) {
    return fail("replay", replayer.error().message);
  }
  std::fprintf(stderr, "farrier replay: %s of robot %s in domain %d\n", o.path.c_str(), robot.name.c_str(),
               o.network.domain);
  nap(*bus.value(), participant::steady_now() + kListen);  // for readers to find the writers
  const std::uint64_t published = play(*bus.value(), replayer.value(), run.value(), o.speed);
  std::printf("%s: %llu samples published\n", o.path.c_str(), static_cast<unsigned long long>(published));
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  if (!run.value().ending().empty()) {
    return fail("replay", o.path + ": " + run.value().ending());
  }
  return kPassed;
}

}  // namespace

std::function<int()> declare_replay(CLI::App& app) {
  auto o = std::make_shared<ReplayOptions>();
  app.add_option("file", o->path, "recording, as farrier record makes it")->required()->type_name("<file>");
  app.add_option("--rerun", o->rerun_of,
                 "publish nothing: feed the recorded measurements to this version's estimators and "
                 "compare their estimates with the recorded ones, bit by bit")
      ->check(CLI::IsMember({"estimator"}))
      ->type_name("estimator");
  declare_topic_choice(app, o->topics);
  app.add_option("--speed", o->speed, "times as fast as it was recorded")
      ->check(CLI::Range(0.01, 1000.0))
      ->type_name("<factor>")
      ->capture_default_str();
  declare_vendor(app, o->vendor);
  declare_network(app, o->network);
  return [o] { return run_replay(*o); };
}

}  // namespace farrier::cli
