// farrier topics: writers, readers and rates of topics in a domain, and QoS that do not match.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "bus/qos_text.hpp"
#include "bus_factory/bus_factory.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "recorder/recorder.hpp"
#include "cli/base/command.hpp"
#include "cli/deploy/findings.hpp"
#include "cli/record/guest.hpp"
#include "cli/base/help.hpp"
#include "tools/deploy/bus_findings.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::cli {
namespace {

struct TopicsOptions {
  double look_s = 3.0;
  bool json = false;
  GuestOptions guest;
};

struct VendorCounts {
  int cyclone = 0, fast = 0, other = 0;

  void add(const std::string& participant) {
    const std::string vendor = participant.substr(0, 4);
    ++(vendor == "0110" ? cyclone : vendor == "010f" ? fast : other);
  }
  std::string text() const {
    std::string text = std::to_string(cyclone) + " + " + std::to_string(fast);
    return other == 0 ? text : text + " + " + std::to_string(other);
  }
};

/// One topic of the domain, as it was found.
struct TopicView {
  std::string name;
  std::set<std::string> types{}, offered{};  ///< offered: QoS of writers
  VendorCounts writers{}, readers{};
  double rate_hz = 0.0;                      ///< of received samples; 0 for topics that are not of the contract
  std::uint64_t lost = 0;
};

/// Returns topics and their rates: ours in the order of the contract, then those of other systems.
std::vector<TopicView> views_of(const bus::Discovery& found, const std::vector<recorder::TopicProgress>& heard,
                                double seconds) {
  std::vector<TopicView> views;
  for (const bus::TopicSpec& topic : bus::topics()) {
    views.push_back({.name = topic.name});
  }
  for (const recorder::TopicProgress& topic : heard) {
    views[static_cast<std::size_t>(topic.topic)].rate_hz = static_cast<double>(topic.samples) / seconds;
    views[static_cast<std::size_t>(topic.topic)].lost = topic.lost;
  }
  for (const bus::DiscoveredEndpoint& endpoint : found.endpoints) {
    auto view = std::ranges::find(views, endpoint.topic, &TopicView::name);
    if (view == views.end()) {
      views.push_back({.name = endpoint.topic});
      view = views.end() - 1;
    }
    (endpoint.writes ? view->writers : view->readers).add(endpoint.participant);
    view->types.insert(endpoint.type);
    if (endpoint.writes) {
      view->offered.insert(bus::qos_text(endpoint.qos, false));
    }
  }
  return views;
}

std::string joined(const std::set<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) {
    all += (all.empty() ? "" : "; ") + text;
  }
  return all;
}

void print_text(const std::vector<TopicView>& views) {
  std::printf("%-24s %9s %9s %9s %6s  %-28s %s\n", "topic", "writers", "readers", "Hz", "lost", "type",
              "QoS of its writers");
  for (const TopicView& view : views) {
    std::printf("%-24s %9s %9s %9s %6llu  %-28s %s\n", view.name.c_str(), view.writers.text().c_str(),
                view.readers.text().c_str(), report::short_number(view.rate_hz).c_str(),
                static_cast<unsigned long long>(view.lost), joined(view.types).c_str(), joined(view.offered).c_str());
  }
  std::printf("writers and readers: of Cyclone DDS + Fast DDS, without this command's own\n");
}

void print_json(const std::vector<TopicView>& views) {
  const auto counts = [](const VendorCounts& count) {
    return nlohmann::json{{"cyclone", count.cyclone}, {"fast", count.fast}, {"other", count.other}};
  };
  nlohmann::json all = nlohmann::json::array();
  for (const TopicView& view : views) {
    all.push_back({{"topic", view.name},
                   {"types", view.types},
                   {"writers", counts(view.writers)},
                   {"readers", counts(view.readers)},
                   {"rate_hz", view.rate_hz},
                   {"lost", view.lost},
                   {"offered_qos", view.offered}});
  }
  std::printf("%s\n", all.dump(2).c_str());
}

/// Returns the streams that writers of `found` offer: topics that come many times a second while a robot runs.
std::vector<bus::TopicId> offered_streams(const bus::Discovery& found) {
  std::vector<bus::TopicId> streams;
  for (const bus::TopicSpec& topic : bus::topics()) {
    const bool offered = std::ranges::any_of(found.endpoints, [&](const bus::DiscoveredEndpoint& endpoint) {
      return endpoint.writes && endpoint.topic == topic.name;
    });
    if (offered && topic.sending == bus::Sending::kTogether) {
      streams.push_back(topic.id);
    }
  }
  return streams;
}

/// Counts what comes for `how_long` after every one of `streams` was heard, or after kFirstSampleLimit. The counts
/// leave out what came before: announcements from before this command joined, and a late discovery.
std::vector<recorder::TopicProgress> listen(bus::Bus& bus, recorder::Recorder& recorder,
                                            const std::vector<bus::TopicId>& streams, Nanoseconds how_long) {
  const auto drain_until = [&](SteadyTime end, const auto& enough) {
    while (participant::steady_now() < end && !participant::stop_requested() && !enough()) {
      bus.wait_for_arrivals(~std::uint64_t{0}, std::chrono::milliseconds(5));
      recorder.drain([](const recording::Sample&) {});
    }
  };
  const auto all_heard = [&] {
    const std::vector<recorder::TopicProgress> heard = recorder.progress();
    return std::ranges::all_of(streams, [&](bus::TopicId stream) {
      return std::ranges::any_of(heard, [&](const auto& topic) { return topic.topic == stream && topic.samples > 0; });
    });
  };
  drain_until(participant::steady_now() + kFirstSampleLimit, all_heard);
  const std::vector<recorder::TopicProgress> before = recorder.progress();
  drain_until(participant::steady_now() + how_long, [] { return false; });
  std::vector<recorder::TopicProgress> counted = recorder.progress();
  for (std::size_t i = 0; i < counted.size(); ++i) {
    counted[i].samples -= before[i].samples;
  }
  return counted;
}

int run_topics(const TopicsOptions& o) {
  participant::install_signal_handlers();
  const auto robot = robot::load_robot(o.guest.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  // First without readers of its own, so that discovery finds only those of others.
  const std::chrono::duration<double> half(o.look_s / 2);
  const auto half_ns = std::chrono::duration_cast<Nanoseconds>(half);
  const auto found = bus_factory::discover(o.guest.network, half_ns);
  if (!found) {
    return fail("topics", found.error().message);
  }
  auto bus = join_as_guest(o.guest, bus::Role::kMonitor);
  if (!bus) {
    return fail("topics", bus.error().message, bus.error().status);
  }
  auto recorder = recorder::Recorder::create(*bus.value(), robot.value(), {});
  if (!recorder) {
    return fail("topics", recorder.error().message);
  }
  const auto heard = listen(*bus.value(), recorder.value(), offered_streams(found.value()), half_ns);
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  const std::vector<TopicView> views = views_of(found.value(), heard, half.count());
  if (o.json) {
    print_json(views);
    return kPassed;
  }
  print_text(views);
  return print_findings(deploy::bus_findings(found.value(), robot.value().name, o.guest.network), robot.value().name);
}

}  // namespace

std::function<int()> declare_topics(CLI::App& app) {
  auto o = std::make_shared<TopicsOptions>();
  app.add_option("--look", o->look_s, "how long to look, half of it for who is there, half for what comes")
      ->check(between(0.5, 60.0))
      ->type_name("<s>")
      ->capture_default_str();
  app.add_flag("--json", o->json, "as JSON, without what does not go together");
  declare_guest(app, o->guest);
  return [o] { return run_topics(*o); };
}

}  // namespace farrier::cli
