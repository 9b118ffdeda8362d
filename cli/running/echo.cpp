// farrier echo: prints what a robot's processes publish, a sample a line.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "recorder/watching_endpoint.hpp"
#include "signals/tick_of.hpp"
#include "cli/base/command.hpp"
#include "cli/record/guest.hpp"
#include "cli/record/topic_choice.hpp"
#include "report/figures/sample_text.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kSilenceWorthSaying = 5s;

struct EchoOptions {
  std::vector<std::string> topics;
  std::string joint;
  std::uint64_t count = 0;
  GuestOptions guest;
};

/// The reading end of one topic that prints what comes.
class Echo {
 public:
  virtual ~Echo() = default;
  /// Prints at most that many; how many it were.
  virtual std::uint64_t print(std::uint64_t most) = 0;
};

/// Which samples are printed, and how they are called.
struct Filter {
  const robot::Robot& robot;
  const robot::Joint* joint;  ///< null: of all
};

template <class Signal>
class TypedEcho final : public Echo {
 public:
  static Result<std::unique_ptr<Echo>> create(bus::Bus& bus, const Filter& filter) {
    const bus::TopicSpec& topic = bus::spec(bus::TopicOf<Signal>::id);
    auto heard =
        FARRIER_TRY(bus::Subscription<Signal>::create(bus, recorder::watching_endpoint(filter.robot, topic.id)));
    return std::unique_ptr<Echo>(new TypedEcho(topic.name, std::move(heard), filter));
  }

  std::uint64_t print(std::uint64_t most) override {
    std::uint64_t printed = 0;
    heard_.drain([&](const Signal& signal) {
      if (printed < most && wanted(signal)) {
        ++printed;
        std::printf("%s: %s\n", topic_, report::sample_text(signal, filter_.robot).c_str());
      }
    });
    return printed;
  }

 private:
  TypedEcho(const char* topic, bus::Subscription<Signal> heard, const Filter& filter)
      : topic_(topic), heard_(std::move(heard)), filter_(filter) {}

  bool wanted(const Signal& signal) const {
    if (signals::is_probe(signal)) {
      return false;
    }
    if constexpr (requires { signal.joint; }) {
      return filter_.joint == nullptr || signal.joint == filter_.joint->number;
    }
    return true;
  }

  const char* topic_;
  bus::Subscription<Signal> heard_;
  Filter filter_;
};

using MakeEcho = Result<std::unique_ptr<Echo>> (*)(bus::Bus&, const Filter&);

#define FARRIER_ECHO(Signal, file) &TypedEcho<signals::Signal>::create,
constexpr MakeEcho kEchoes[] = {FARRIER_SIGNALS(FARRIER_ECHO)};
#undef FARRIER_ECHO

int listen(bus::Bus& bus, const std::vector<std::unique_ptr<Echo>>& echoes, const EchoOptions& o) {
  std::uint64_t left = o.count > 0 ? o.count : ~std::uint64_t{0};
  SteadyTime heard = participant::steady_now();
  while (left > 0 && !participant::stop_requested()) {
    const std::uint64_t arrivals = bus.arrivals();
    const std::uint64_t before = left;
    for (const auto& echo : echoes) {
      left -= echo->print(left);
    }
    if (std::fflush(stdout) != 0) {
      return kFailed;  // the reason is that of the output
    }
    const SteadyTime now = participant::steady_now();
    if (left != before) {
      heard = now;
    } else if (now - heard > kSilenceWorthSaying) {
      heard = now;
      std::fprintf(stderr, "farrier echo: nothing comes in domain %d; why: farrier doctor --domain %d\n",
                   o.guest.network.domain, o.guest.network.domain);
    }
    bus.wait_for_arrivals(arrivals + 1, 100ms);
  }
  return left == 0 ? kPassed : participant::stop_status();
}

int run_echo(const EchoOptions& o) {
  participant::install_signal_handlers();
  const auto robot = robot::load_robot(o.guest.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  const Filter filter{robot.value(), o.joint.empty() ? nullptr : robot.value().find(o.joint)};
  if (!o.joint.empty() && filter.joint == nullptr) {
    return refuse("echo", "--joint: " + o.guest.robot_path + " has no joint '" + o.joint + "'");
  }
  auto bus = join_as_guest(o.guest, bus::Role::kMonitor);
  if (!bus) {
    return fail("echo", bus.error().message, bus.error().status);
  }
  std::vector<std::unique_ptr<Echo>> echoes;
  for (const bus::TopicId topic : topics_of(o.topics)) {
    auto echo = kEchoes[static_cast<std::size_t>(topic)](*bus.value(), filter);
    if (!echo) {
      return fail("echo", echo.error().message);
    }
    echoes.push_back(std::move(echo).value());
  }
  return listen(*bus.value(), echoes, o);
}

}  // namespace

std::function<int()> declare_echo(CLI::App& app) {
  auto o = std::make_shared<EchoOptions>();
  app.add_option("topics", o->topics, "topics of idl/README.md, such as joint/measurement")
      ->required()
      ->check(CLI::IsMember(topic_names()))
      ->type_name("<topic>...");
  app.add_option("--joint", o->joint, "samples of this joint alone")->type_name("<name>");
  app.add_option("--count", o->count, "end after so many samples")->type_name("<n>")->default_str("never");
  declare_guest(app, o->guest);
  return [o] { return run_echo(*o); };
}

}  // namespace farrier::cli
