// farrier replay: a recording on the bus, as its robot's processes published it.

#include <cstdio>
#include <memory>

#include "bus_factory/bus_factory.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "recorder/watching_endpoint.hpp"
#include "tools/cli/command.hpp"
#include "tools/cli/guest.hpp"
#include "tools/cli/topic_choice.hpp"
#include "tools/recording/replayer.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;
using signals::SystemHello;

constexpr auto kListen = 1s;     // processes that run say hello fifty times a second while they start, then with health
constexpr auto kLongestNap = 50ms;

struct ReplayOptions {
  std::string path;
  std::vector<std::string> topics;
  double speed = 1.0;
  std::string vendor = "cyclone";
  bus::NetworkOptions network;
};

int fail(const std::string& message, int status) {
  std::fprintf(stderr, "farrier replay: %s\n", message.c_str());
  return status;
}

/// The robot that was recorded, from the configuration in the file, which comes before its samples.
Result<robot::Robot> recorded_robot(run_file::RunFileReader& file, const std::string& path, run_file::Sample& first,
                                    bool& any) {
  any = file.next(first);
  const mcap::Text facts = file.metadata(run_file::kRunFacts);
  const auto configuration = facts.find("configuration");
  if (configuration == facts.end()) {
    return Error{path + " does not say of which robot it is: give a recording of farrier record"};
  }
  auto robot = robot::load_robot_text(configuration->second, path);
  if (!robot) {
    return Error{config::to_string(robot.error())};
  }
  return std::move(robot).value();
}

void nap(bus::Bus& bus, SteadyTime until) {
  while (!participant::stop_requested() && participant::steady_now() < until) {
    const Nanoseconds left = until - participant::steady_now();
    bus.wait_for_arrivals(~std::uint64_t{0}, std::min<Nanoseconds>(left, kLongestNap));
  }
}

/// Refuses where a robot of this name runs: a replay would speak in the name of its processes.
Result<Done> nobody_is_there(bus::Bus& bus, const robot::Robot& robot, int domain) {
  auto hellos = bus::Subscription<SystemHello>::create(
      bus, recorder::watching_endpoint(robot, bus::TopicId::kSystemHello));
  if (!hellos) {
    return hellos.error();
  }
  std::string heard;
  nap(bus, participant::steady_now() + kListen);
  hellos.value().drain([&](const SystemHello& hello) { heard = signals::text_of(hello.name); });
  if (!heard.empty()) {
    return Error{heard + " of robot " + robot.name + " runs in domain " + std::to_string(domain) +
                 ", and a replay would speak in its name: give a --domain of its own"};
  }
  return Done{};
}

/// Publishes all samples from `sample` on, as far apart as they were recorded; how many.
std::uint64_t play(bus::Bus& bus, recording::Replayer& replayer, run_file::RunFileReader& file,
                   run_file::Sample& sample, double speed) {
  const SteadyTime begin = participant::steady_now();
  const std::uint64_t first_ns = sample.log_time_ns;
  std::uint64_t published = 0;
  do {
    const std::uint64_t since_ns = sample.log_time_ns - std::min(sample.log_time_ns, first_ns);
    nap(bus, begin + Nanoseconds(static_cast<std::int64_t>(static_cast<double>(since_ns) / speed)));
    if (participant::stop_requested()) {
      break;
    }
    published += replayer.publish(sample) ? 1 : 0;
  } while (file.next(sample));
  return published;
}

int run_replay(const ReplayOptions& o) {
  participant::install_signal_handlers();
  auto file = run_file::RunFileReader::open(o.path);
  if (!file) {
    return fail(file.error().message, kBadInput);
  }
  run_file::Sample sample;
  bool any = false;
  const auto robot = recorded_robot(file.value(), o.path, sample, any);
  if (!robot) {
    return fail(robot.error().message, kBadInput);
  }
  if (!any) {
    return fail(o.path + " has no samples " + file.value().ending(), kBadInput);
  }
  auto bus = bus_factory::create_bus(bus::parse_vendor(o.vendor).value(), o.network);
  if (!bus) {
    return fail(bus.error().message, kFailed);
  }
  if (auto alone = nobody_is_there(*bus.value(), robot.value(), o.network.domain); !alone) {
    return fail(alone.error().message, kBadInput);
  }
  auto replayer = recording::Replayer::create(*bus.value(), robot.value(), topics_of(o.topics));
  if (!replayer) {
    return fail(replayer.error().message, kFailed);
  }
  std::fprintf(stderr, "farrier replay: %s of robot %s in domain %d\n", o.path.c_str(), robot.value().name.c_str(),
               o.network.domain);
  nap(*bus.value(), participant::steady_now() + kListen);  // for readers to find the writers
  const std::uint64_t published = play(*bus.value(), replayer.value(), file.value(), sample, o.speed);
  std::printf("%s: %llu samples published\n", o.path.c_str(), static_cast<unsigned long long>(published));
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  if (!file.value().ending().empty()) {
    return fail(o.path + ": " + file.value().ending(), kFailed);
  }
  return kPassed;
}

}  // namespace

std::function<int()> declare_replay(CLI::App& app) {
  auto o = std::make_shared<ReplayOptions>();
  app.add_option("file", o->path, "recording, as farrier record makes it")->required()->type_name("<file>");
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
