// farrier drive: the whole robot on a ground in real time, steered by keys.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/base/command.hpp"
#include "cli/base/installation.hpp"
#include "cli/drive/steering.hpp"
#include "cli/drive/terminal_keys.hpp"
#include "core/fault.hpp"
#include "cli/processes/pause_watch.hpp"
#include "cli/trot/trot_options.hpp"
#include "cli/trot/trot_run.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "process/process.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr const char* kKeysText =
    "arrows or w, s, a, d: speed and turning; comma, full stop: sideways; space: stop and stand; l: lie down;\n"
    "q or Ctrl-C: lie down and end; x: every joint to null at once\n";
constexpr auto kRepeat = 50ms;  // locomotion takes silence of half a second for a lost operator
constexpr auto kLongestEnd = 20s;
constexpr const char* kPage = "monitor";

struct DriveOptions {
  TrotOptions trot;
  double duration_s = 0.0;
  bool no_page = false;
};

/// From keys and the robot's state to what the launcher publishes.
class Drive {
 public:
  Drive(const robot::Robot& robot, TerminalKeys keys, double duration_s)
      : steering_(robot.locomotion->reference),
        keys_(std::move(keys)),
        ticks_(static_cast<Tick>(duration_s / robot.period_s)) {}

  /// As DdsRun::steers.
  Steered step(Tick tick, const signals::BodyState& state) {
    steering_.take(state.mode);
    for (const Key key : keys_.pressed()) {
      steering_.press(key);
    }
    if (keys_.lost() || (ticks_ > 0 && tick >= ticks_)) {
      steering_.lose_terminal();
    }
    const SteadyTime now = participant::steady_now();
    if (steering_.ending() && end_ == SteadyTime{}) {
      end_ = now + kLongestEnd;
    }
    Steered steered;
    steered.ends = steering_.ended() || steering_.nulled() || (end_ != SteadyTime{} && now > end_);
    steered.stops = steering_.nulled();
    if (now >= next_) {
      next_ = now + kRepeat;
      const locomotion::MotionCommand& command = steering_.command();
      signals::BodyCommand signal;
      signal.tick = std::max<Tick>(tick, 0);
      signal.request = command.request;
      signal.forward_m_s = command.forward_m_s;
      signal.left_m_s = command.left_m_s;
      signal.yaw_rate_rad_s = command.yaw_rate_rad_s;
      steered.command = signal;
      show(state);
    }
    fell_ = fell_ || state.mode == MotionMode::kFallen;
    return steered;
  }

  bool fell() const noexcept { return fell_; }
  bool lost_terminal() const noexcept { return keys_.lost(); }

 private:
  void show(const signals::BodyState& state) {
    if (keys_.lost()) {
      return;
    }
    const std::string text = steering_.text() + "; at " + report::short_number(state.position_m[0]) + ", " +
                             report::short_number(state.position_m[1]) + " m";
    std::fprintf(stderr, "\r\033[K%s", text.c_str());
    std::fflush(stderr);
  }

  Steering steering_;
  TerminalKeys keys_;
  Tick ticks_;
  SteadyTime next_{}, end_{};
  bool fell_ = false;
};

/// Joints that tripped in the run, by their events.
std::size_t trips_of(const RunOutcome& outcome) {
  return static_cast<std::size_t>(std::ranges::count_if(outcome.events, [](const signals::SystemEvent& event) {
    return event.joint != signals::kNoJoint &&
           signals::text_of(event.text).find(to_string(Fault::kTripped)) != std::string_view::npos;
  }));
}

int drive(DriveOptions o) {
  o.trot.clock = bus::ClockKind::kRealtime;
  o.trot.world = participant::World::kBody;
  o.trot.velocity.clear();
  o.trot.design = robot::Design::kPhases;
  const auto loaded = process::load_robot(common_options(o.trot));
  if (!loaded) {
    std::fputs(config::to_string(loaded.error()).c_str(), stderr);
    return kBadInput;
  }
  const robot::Robot& robot = loaded.value();
  if (!robot.can_walk()) {
    return refuse("drive", robot.cannot_walk_error());
  }
  if (o.trot.dds == DdsChoice::kInproc) {
    return refuse("drive", "--dds inproc runs on the lock-step clock only: choose a vendor");
  }
  auto keys = TerminalKeys::open();
  if (!keys) {
    return refuse("drive", keys.error().message);
  }
  o.trot.out = std::filesystem::absolute(o.trot.out).string();
  DdsRun run = dds_run(robot, o.trot, "");
  run.common.ticks = 0;
  run.common.trace_path.clear();
  if (!o.no_page) {
    run.onlookers.push_back({.name = kPage, .arguments = {"monitor", "--web"}, .listens = "page at"});
    std::fprintf(stderr, "page: http://localhost:8642/\n");
  }
  std::fputs(kKeysText, stderr);
  Drive driver(robot, std::move(keys).value(), o.duration_s);
  run.steers = [&driver](Tick tick, const signals::BodyState& state) { return driver.step(tick, state); };
  PauseWatch pauses;
  const auto ran = run_over_dds(robot, run);
  std::fputc('\n', stderr);
  if (!ran) {
    return fail("drive", ran.error().message);
  }
  const std::size_t trips = trips_of(ran.value());
  std::printf("drove %s s: %zu joints tripped, the robot %s; a bare timer was late by %s ms at most%s\n",
              report::short_number(ran.value().wall_s).c_str(), trips, driver.fell() ? "fell" : "did not fall",
              report::short_number(std::chrono::duration<double, std::milli>(pauses.longest()).count()).c_str(),
              driver.lost_terminal() ? "; the terminal was lost" : "");
  return trips == 0 && !driver.fell() ? kPassed : kFailed;
}

}  // namespace

std::function<int()> declare_drive(CLI::App& app) {
  auto o = std::make_shared<DriveOptions>();
  o->trot.out = "out/drive";
  o->trot.robot_path = shipped_robot("hyq.yaml");
  app.add_option("--robot", o->trot.robot_path, "robot file")->type_name("<file>")->default_str("hyq.yaml, as shipped");
  declare_processes(app, o->trot);
  app.add_option("--scene", o->trot.scene_path, "scene file of the ground, pushes and payloads; a plane unless given")
      ->type_name("<file>");
  app.add_option("--duration", o->duration_s,
                 "seconds after which the robot lies down and the command ends; 0: by keys")
      ->check(CLI::NonNegativeNumber)
      ->type_name("<s>")
      ->capture_default_str();
  app.add_option("--out", o->trot.out, "directory for the logs")->type_name("<dir>")->capture_default_str();
  app.add_flag("--no-page", o->no_page, "without the page of farrier monitor")->type_name("");
  return [o] { return drive(*o); };
}

}  // namespace farrier::cli
